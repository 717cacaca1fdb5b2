//! The help and the error messages of the project's scripts. No script does its work here.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::{Command, Output};

use test_support::folder::Folder;

/// Runs a script of the project, which finds only the programs in `folder`.
fn script(name: &str, arguments: &[&str], folder: &Folder) -> Output {
    Command::new("/usr/bin/env")
        .args(["bash", name])
        .args(arguments)
        .current_dir(test_support::project_root())
        .env("PATH", folder.path())
        .output()
        .expect("bash is there")
}

/// Returns a folder of programs: those in `names` do nothing and fail; those that a shell script needs are links to the
/// real ones.
fn programs(names: &[&str]) -> Folder {
    let folder = Folder::new();
    for name in ["bash", "dirname", "sed", "grep", "id"] {
        let real = ["/usr/bin", "/bin"].map(|place| format!("{place}/{name}"));
        let real = real.into_iter().find(|path| fs::metadata(path).is_ok()).expect("every system has it");
        std::os::unix::fs::symlink(real, folder.file(name)).expect("the folder is writable");
    }
    for name in names {
        fs::write(folder.file(name), "#!/bin/sh\nexit 1\n").expect("the folder is writable");
        fs::set_permissions(folder.file(name), fs::Permissions::from_mode(0o755)).expect("it is ours");
    }
    folder
}

#[test]
fn tests_run_lists_what_is_missing_and_installs_nothing_where_it_must_not() {
    let folder = programs(&["cargo", "dpkg-query", "apt-get"]);
    let output = script("tests/run", &["--no-install", "--browser", "--slurm"], &folder);
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).expect("it is text");
    let list = "mesa-vulkan-drivers valgrind strace chromium slurm-wlm munge";
    assert!(message.starts_with(&format!("tests/run: missing: {list}; as root: apt-get install")), "{message}");
    // Without --no-install the script names the packages and then installs them; here apt-get fails.
    let output = script("tests/run", &[], &folder);
    let said = String::from_utf8(output.stdout).expect("it is text");
    assert!(
        said.contains("are installed now (--no-install ends instead): mesa-vulkan-drivers valgrind strace\n"),
        "{said}"
    );
    assert!(!output.status.success());
}

#[test]
fn scripts_have_help_and_refuse_what_they_do_not_know() {
    let folder = programs(&["cargo"]);
    for name in [
        "tests/run",
        "tests/slurm.sh",
        "lab/slurm/submit",
        "docs/build-report",
        "docs/measure-perf",
        "bench/instructions",
        "tests/ratio.sh",
        "tests/measure-limits",
    ] {
        let output = script(name, &["--help"], &folder);
        let said = String::from_utf8(output.stdout).expect("it is text");
        assert!(output.status.success() && said.contains(name), "{name}: {said} {:?}", output.stderr);
    }
    // Nothing is measured unless the file to write is named.
    for (name, arguments) in [
        ("tests/run", &["--bogus"][..]),
        ("docs/measure-perf", &[]),
        ("docs/measure-perf", &["perf.csv", "many"]),
        ("docs/measure-perf", &["9", "perf.csv"]),
    ] {
        let output = script(name, arguments, &folder);
        assert_eq!(output.status.code(), Some(2), "{name} {arguments:?}");
        let message = String::from_utf8(output.stderr).expect("it is text");
        assert!(message.contains(name) && output.stdout.is_empty(), "{message}");
    }
}
