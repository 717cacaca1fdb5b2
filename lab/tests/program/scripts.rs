//! Tests of the error messages of the project's scripts. No script does its real work in these tests.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::{Command, Output};

use test_support::folder::Folder;

/// Runs a script of the project with a `PATH` that has only the programs in `folder`. `words` may begin with variables
/// of the environment, such as `NAME=1`.
fn script(words: &[&str], folder: &Folder) -> Output {
    Command::new("/usr/bin/env")
        .args(words)
        .current_dir(test_support::project_root())
        .env("PATH", folder.path())
        .env("LC_ALL", "C")
        .output()
        .expect("bash is there")
}

/// Returns a folder of programs. Those in `names` do nothing and fail. Those that a shell script needs are links to the
/// real programs.
fn programs(names: &[&str]) -> Folder {
    let folder = Folder::new();
    for name in ["bash", "dirname", "sed", "grep", "id", "awk", "mktemp", "rm", "timeout"] {
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
    let folder = programs(&["cargo", "rustc", "dpkg-query", "apt-get"]);
    let output = script(&["bash", "tests/run", "--no-install", "--browser", "--slurm"], &folder);
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).expect("it is text");
    let list = "mesa-vulkan-drivers strace chromium npm rustc-web rust-web-src lld slurm-wlm munge";
    assert!(message.starts_with(&format!("tests/run: missing: {list}; as root: apt-get install")), "{message}");
    // Without `--no-install` the script prints the names of the packages, and then installs them. In this test apt-get
    // fails.
    let output = script(&["bash", "tests/run"], &folder);
    let said = String::from_utf8(output.stdout).expect("it is text");
    assert!(said.contains("are installed now (--no-install ends instead): mesa-vulkan-drivers strace\n"), "{said}");
    assert!(!output.status.success());
}

#[test]
fn a_failure_stops_no_test_and_the_last_lines_run_again_what_failed() {
    let folder = programs(&["cargo"]);
    for name in ["tee", "wc", "cat", "env"] {
        std::os::unix::fs::symlink(format!("/usr/bin/{name}"), folder.file(name)).expect("the folder is writable");
    }
    let cargo = "#!/bin/sh\ncase \"$*\" in\n\
        *--lib*) echo 'test a::b ... FAILED'; echo 'error: test failed, to rerun pass `-p cpu --lib`' >&2;;\n\
        *--doc*) echo 'test src/lib.rs - (line 10) ... FAILED'; echo 'doctest failed, to rerun pass `-p cpu --doc`';;\n\
        *--release*) echo 'error: could not compile' >&2;;\n*) exit 0;;\nesac\nexit 101\n";
    folder.write("cargo", cargo);
    let last_lines = |name: &str| {
        let output = script(&["-u", "STEPS_FAILED", "bash", name], &folder);
        assert_eq!(output.status.code(), Some(1), "{output:?}");
        let said = String::from_utf8(output.stdout).expect("it is text");
        said.split_once(&format!("{name}: FAILED; these commands run it again:\n")).expect("it failed").1.to_owned()
    };
    let unit = "    cargo test -p cpu --lib -- --exact a::b\n";
    let example = "    cargo test -p cpu --doc -- --exact 'src/lib.rs - (line 10)'\n";
    assert_eq!(last_lines("tests/utest.sh"), [unit, example].concat());
    assert_eq!(last_lines("tests/ftest.sh"), "    cargo build --release -p cli --bins\n");
}

/// Returns a folder of programs with a `cargo-deny` that ends with status `fetch` when it should download the list of
/// faults, and with status `check` when it should compare the dependencies with it.
fn programs_with_deny(fetch: i32, check: i32) -> Folder {
    let folder = programs(&["cargo", "cargo-deny"]);
    folder.write("cargo", "#!/bin/sh\nexec \"cargo-$1\" \"$@\"\n");
    let deny = format!(
        "#!/bin/sh\ncase \"$*\" in\n\"deny fetch db\") echo reason >&2; exit {fetch};;\n\
         *\" check --disable-fetch advisories\") exit {check};;\n*) exit 99;;\nesac\n"
    );
    folder.write("cargo-deny", deny);
    folder
}

#[test]
fn known_faults_fail_and_a_missing_list_is_ignored_unless_it_is_required() {
    let advisories = |folder: &Folder, required: &str| {
        let output = script(&[&format!("ADVISORIES_REQUIRED={required}"), "bash", "tests/parts/advisories"], folder);
        (output.status.code(), String::from_utf8(output.stdout).expect("it is text"))
    };
    let manifests = ["Cargo.toml", "python/Cargo.toml", "tests/fuzz/targets/Cargo.toml"];
    let ok: String = manifests.map(|manifest| format!("advisories of {manifest} ... ok\n")).concat();
    assert_eq!(advisories(&programs_with_deny(0, 0), "1"), (Some(0), ok));
    let ignored = |reason: &str| format!("advisories ... ignored: {reason}\n");
    let no_list = ignored("the list cannot be had: reason");
    let no_program = ignored("cargo-deny is missing; cargo install cargo-deny --locked");
    for (required, status) in [("", 0), ("1", 1)] {
        assert_eq!(advisories(&programs_with_deny(1, 0), required), (Some(status), no_list.clone()));
        assert_eq!(advisories(&programs(&["cargo"]), required), (Some(status), no_program.clone()));
        // A fault is never ignored.
        assert_eq!(advisories(&programs_with_deny(0, 7), required), (Some(7), String::new()));
    }
}

#[test]
fn scripts_refuse_what_they_do_not_know() {
    let folder = programs(&["cargo"]);
    // Nothing is measured unless the file to write is named, and unless there is a cluster.
    for (name, arguments) in [
        ("tests/run", &["--bogus"][..]),
        ("lab/slurm/submit", &[]),
        ("lab/slurm/submit", &["--bogus"]),
        ("lab/slurm/submit", &["no-cluster"]),
        ("python/build-wheel", &["--bogus"]),
        ("tests/run", &["no-part"]),
        ("docs/build-report", &["--bogus"]),
        ("docs/build-report", &["--language", "fr"]),
        ("docs/measure-perf", &["--bogus"]),
        ("docs/measure-perf", &[]),
        ("docs/measure-perf", &["perf.csv", "many"]),
        ("docs/measure-perf", &["9", "perf.csv"]),
        ("docs/measure-perf", &["--sweep"]),
    ] {
        let output = script(&[&["bash", name], arguments].concat(), &folder);
        assert_eq!(output.status.code(), Some(2), "{name} {arguments:?}");
        let message = String::from_utf8(output.stderr).expect("it is text");
        assert!(message.contains(name) && output.stdout.is_empty(), "{message}");
    }
}
