//! Checks that every binary and example of the project explains its use for `--help`, and does nothing else then, and
//! that it refuses a wrong command line. Only the evaluated programs are left out, because the statement prescribes
//! their messages.

use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::LazyLock;

use object::{Object, ObjectSection};
use serde_json::Value;
use test_support::folder::Folder;
use test_support::{cargo, project_root};

use crate::files;

/// Names of the evaluated programs, whose messages the statement prescribes.
const EVALUATED: [&str; 2] = ["render-aos", "render-soa"];

/// Programs that do nothing without the name of a file or folder.
const NEED_FILES: [&str; 6] = ["charts", "compare", "read_scene", "reference", "shader-lab", "stress"];

/// The names and paths of all binaries and examples of the workspace. They are built on the first use. After
/// `cargo test --workspace` only the examples are left to build.
static PROGRAMS: LazyLock<Vec<(String, PathBuf)>> = LazyLock::new(|| {
    let messages = cargo("", &["build", "--message-format", "json", "--workspace", "--bins", "--examples"]);
    let mut programs = Vec::new();
    for message in messages.lines() {
        let message: Value = serde_json::from_str(message).expect("cargo writes JSON");
        let (name, kind) = (&message["target"]["name"], &message["target"]["kind"][0]);
        let is_program = kind == "bin" || kind == "example";
        if let (Some(name), Some(path)) = (name.as_str(), message["executable"].as_str().filter(|_| is_program)) {
            programs.push((name.to_owned(), path.into()));
        }
    }
    programs
});

/// Returns the names and paths of the programs that answer `--help`.
fn programs_with_help() -> impl Iterator<Item = &'static (String, PathBuf)> {
    PROGRAMS.iter().filter(|(name, _)| !EVALUATED.contains(&name.as_str()))
}

/// Returns the fault in a program's answer to `--help`, or `None` if there is none.
fn fault(name: &str, output: &Output) -> Option<&'static str> {
    let said = String::from_utf8_lossy(&output.stdout).replace("\r\n", "\n");
    // An example is a line that begins with "Example", with a command below it that has the program's name.
    let example = said.split_once("Example").map(|(_, rest)| rest);
    if output.status.code() != Some(0) {
        Some("the status is not 0")
    } else if !output.stderr.is_empty() {
        Some("it writes to standard error")
    } else if !said.split("Example").next().is_some_and(|usage| usage.contains(name)) {
        Some("its usage does not have its name")
    } else if !example.is_some_and(|example| example.lines().skip(1).any(|line| line.contains(name))) {
        Some("it has no example")
    } else {
        None
    }
}

#[test]
fn every_program_answers_help_and_writes_nothing() {
    let (root, folder) = (project_root(), Folder::new());
    let programs: Vec<_> = programs_with_help().collect();
    let before = files(&root);
    let mut faults = Vec::new();
    for (name, path) in programs {
        for place in [&*root, folder.path()] {
            let output = Command::new(path).arg("--help").current_dir(place).output().expect("it starts");
            faults.extend(fault(name, &output).map(|fault| format!("{name}: {fault}")));
        }
    }
    assert_eq!(faults, [""; 0]);
    assert_eq!(files(&root), before, "a program wrote into the project");
    assert!(files(folder.path()).is_empty(), "a program wrote into its folder");
}

#[test]
fn a_wrong_command_line_ends_with_2() {
    let folder = Folder::new();
    let mut faults = Vec::new();
    let mut without = 0;
    for (name, path) in programs_with_help() {
        let needs_files = NEED_FILES.contains(&name.as_str());
        without += usize::from(needs_files);
        // The programs that read or write files refuse to run without a name, too.
        for arguments in [&["--bogus"][..], &[]].into_iter().take(1 + usize::from(needs_files)) {
            let output = Command::new(path).args(arguments).current_dir(folder.path()).output().expect("it starts");
            faults.extend(fault_of_refusal(&output).map(|fault| format!("{name} {arguments:?}: {fault}")));
        }
    }
    assert_eq!(without, NEED_FILES.len(), "every program of the list exists");
    assert_eq!(faults, [""; 0]);
    assert!(files(folder.path()).is_empty(), "a program wrote into its folder");
}

/// What is wrong with a program's answer to a wrong command line, if anything is.
fn fault_of_refusal(output: &Output) -> Option<String> {
    let said = String::from_utf8_lossy(&output.stderr);
    // A main function that returns an `Err` prints its `Debug` form, which for a text has quotes.
    let is_message = said.to_lowercase().starts_with("error: ") && !said.starts_with("Error: \"usage");
    if output.status.code() != Some(2) {
        Some(format!("the status is {:?}, not 2", output.status.code()))
    } else if !output.stdout.is_empty() {
        Some("it writes to standard output".to_owned())
    } else if !is_message || said.contains("\\n") || said.contains("Custom {") {
        Some(format!("its message is [{said}]"))
    } else {
        None
    }
}

/// Returns up to 100 bytes of a program that begin with `path`, or `None` if the program does not contain it. Only what
/// is loaded into memory is searched, so debug information is left out.
fn data_with(program: &[u8], path: &str) -> Option<String> {
    let file = object::File::parse(program).expect("it is a program");
    let sections = file.sections().filter(|section| section.address() != 0);
    let mut data = sections.filter_map(|section| section.data().ok());
    data.find_map(|bytes| {
        let place = bytes.windows(path.len()).position(|part| part == path.as_bytes())?;
        Some(String::from_utf8_lossy(&bytes[place..bytes.len().min(place + 100)]).into_owned())
    })
}

#[cfg(target_os = "linux")]
#[test]
fn no_program_contains_the_path_of_its_checkout() {
    let root = project_root();
    let root = root.to_str().expect("the tests are in a folder with a plain name");
    let data_of = |path: &PathBuf| data_with(&std::fs::read(path).expect("it was built"), root);
    let faults: Vec<_> =
        PROGRAMS.iter().filter_map(|(name, path)| Some(format!("{name}: {}", data_of(path)?))).collect();
    assert_eq!(faults, [""; 0]);
    // This test contains the path, because it looks for the programs there.
    assert!(data_of(&std::env::current_exe().expect("it runs")).is_some());
}
