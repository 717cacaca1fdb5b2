//! Checks that every binary, example and script of the project explains its use for `--help`, and does nothing else
//! then.
//!
//! Cargo lists the programs, so a new program is tested from its start. Only the evaluated programs are left out,
//! because the statement prescribes their messages. The module `scripts` tests the scripts.

#[cfg(unix)]
#[path = "help/scripts.rs"]
mod scripts;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::SystemTime;

use object::{Object, ObjectSection};
use serde_json::Value;
use test_support::folder::Folder;

/// Names of the evaluated programs, whose messages the statement prescribes.
const EVALUATED: [&str; 2] = ["render-aos", "render-soa"];

/// Programs that do nothing without the name of a file or folder.
const NEED_FILES: [&str; 6] = ["charts", "compare", "read_scene", "reference", "shader-lab", "stress"];

/// A binary or an example of the workspace.
#[derive(Debug)]
struct Program {
    package: String,
    name: String,
    /// Cargo's name for the kind of program: `bin` or `example`.
    kind: String,
    /// Names of the features that it needs, separated by commas.
    features: String,
}

fn cargo(arguments: &[&str]) -> Vec<Value> {
    let mut command = Command::new(env!("CARGO"));
    command.args(arguments).arg("--locked").current_dir(test_support::project_root());
    let output = command.output().expect("cargo runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::Deserializer::from_slice(&output.stdout).into_iter().map(|value| value.expect("it is JSON")).collect()
}

/// Returns the text of a JSON string. Panics for any other value.
fn text(value: &Value) -> String {
    value.as_str().unwrap_or_else(|| panic!("{value} is no text")).to_owned()
}

/// Returns the entries of a JSON list, or no entries for any other value.
fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// Returns all programs of the workspace.
fn programs() -> Vec<Program> {
    let metadata = cargo(&["metadata", "--no-deps", "--format-version", "1"]);
    let mut programs = Vec::new();
    for package in list(&metadata[0]["packages"]) {
        for target in list(&package["targets"]) {
            let kind = text(&target["kind"][0]);
            if kind == "bin" || kind == "example" {
                let features: Vec<_> = list(&target["required-features"]).iter().map(text).collect();
                let (package, name) = (text(&package["name"]), text(&target["name"]));
                programs.push(Program { package, name, kind, features: features.join(",") });
            }
        }
    }
    programs
}

/// Builds the programs with the profile of the tests, and returns Cargo's messages. Most programs are built already.
fn build(programs: &[Program]) -> Vec<Value> {
    let mut messages = cargo(&["build", "--message-format", "json", "--workspace", "--bins", "--examples"]);
    // Cargo leaves out programs whose features are not switched on.
    for Program { package, name, kind, features } in programs.iter().filter(|program| !program.features.is_empty()) {
        let kind = format!("--{kind}");
        messages.extend(cargo(&["build", "--message-format", "json", "-p", package, &kind, name, "-F", features]));
    }
    messages
}

/// Returns the path of a built program, which is in Cargo's messages.
fn path(program: &Program, messages: &[Value]) -> PathBuf {
    let is_its = |message: &&Value| {
        let target = &message["target"];
        let [name, kind] = [&program.name, &program.kind].map(String::as_str);
        target["name"] == name && target["kind"][0] == kind && message["executable"].is_string()
    };
    let message = messages.iter().find(is_its).unwrap_or_else(|| panic!("{program:?} was not built"));
    PathBuf::from(text(&message["executable"]))
}

/// Adds the time of the last change of each file in `folder` to `found`. The folders `target` and `.git` are left out,
/// and `node_modules`, whose scripts are those of other projects.
fn changes(folder: &Path, found: &mut BTreeMap<PathBuf, SystemTime>) {
    for entry in std::fs::read_dir(folder).expect("the folder is readable") {
        let path = entry.expect("the folder is readable").path();
        let is_own = |name: &str| path.file_name().is_some_and(|own| own == name);
        if path.is_dir() && !path.is_symlink() {
            if !["target", ".git", "node_modules"].into_iter().any(is_own) {
                changes(&path, found);
            }
        } else if let Ok(changed) = path.symlink_metadata().and_then(|metadata| metadata.modified()) {
            found.insert(path, changed);
        }
    }
}

fn files(folder: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let mut found = BTreeMap::new();
    changes(folder, &mut found);
    found
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
    let root = test_support::project_root();
    let programs: Vec<_> = programs().into_iter().filter(|it| !EVALUATED.contains(&it.name.as_str())).collect();
    let messages = build(&programs);
    let built: Vec<_> = programs.iter().map(|program| (program, path(program, &messages))).collect();
    let folder = Folder::new();
    let before = files(&root);
    let mut faults = Vec::new();
    for (program, path) in &built {
        for place in [&*root, folder.path()] {
            let output = Command::new(path).arg("--help").current_dir(place).output().expect("it starts");
            let fault = fault(&program.name, &output);
            faults.extend(fault.map(|fault| format!("{}: {fault}", program.name)));
        }
    }
    faults.dedup();
    assert_eq!(faults, [""; 0]);
    assert_eq!(files(&root), before, "a program wrote into the project");
    assert!(files(folder.path()).is_empty(), "a program wrote into its folder");
    assert!(built.len() >= 10, "only {} programs were found", built.len());
}

#[test]
fn a_wrong_command_line_ends_with_2() {
    let programs: Vec<_> = programs().into_iter().filter(|it| !EVALUATED.contains(&it.name.as_str())).collect();
    let messages = build(&programs);
    let folder = Folder::new();
    let mut faults = Vec::new();
    let mut without = 0;
    for program in &programs {
        let needs_files = NEED_FILES.contains(&program.name.as_str());
        without += usize::from(needs_files);
        // The programs that read or write files refuse to run without a name, too.
        for arguments in [&["--bogus"][..], &[]].into_iter().take(1 + usize::from(needs_files)) {
            let mut command = Command::new(path(program, &messages));
            let output = command.args(arguments).current_dir(folder.path()).output().expect("it starts");
            faults.extend(fault_of_refusal(&output).map(|fault| format!("{} {arguments:?}: {fault}", program.name)));
        }
    }
    assert_eq!(without, NEED_FILES.len(), "every program of the list exists");
    assert_eq!(faults, [""; 0]);
    assert!(files(folder.path()).is_empty(), "a program wrote into its folder");
    assert!(programs.len() >= 10, "only {} programs were found", programs.len());
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
    let root = test_support::project_root();
    let root = root.to_str().expect("the tests are in a folder with a plain name");
    let programs = programs();
    let messages = build(&programs);
    let mut faults = Vec::new();
    for program in &programs {
        let bytes = std::fs::read(path(program, &messages)).expect("it was built");
        faults.extend(data_with(&bytes, root).map(|data| format!("{}: {data}", program.name)));
    }
    assert_eq!(faults, [""; 0]);
    assert!(programs.len() >= 12, "only {} programs were found", programs.len());
    // This test contains the path, because it looks for the programs there.
    let own = std::fs::read(std::env::current_exe().expect("it runs")).expect("it is a file");
    assert!(data_with(&own, root).is_some());
}

#[cfg(unix)]
#[test]
fn an_answer_that_lacks_something_is_noticed() {
    use std::os::unix::process::ExitStatusExt;
    let answer = |status: i32, said: &str, complaint: &str| {
        let status = std::process::ExitStatus::from_raw(status << 8);
        fault("tool", &Output { status, stdout: said.into(), stderr: complaint.into() })
    };
    assert_eq!(answer(0, "tool X\nDoes it.\n\nExample:\n  tool 3", ""), None);
    assert_eq!(answer(2, "tool X\n\nExample:\n  tool 3", ""), Some("the status is not 0"));
    assert_eq!(answer(0, "tool X\n\nExample:\n  tool 3", "oh"), Some("it writes to standard error"));
    assert_eq!(answer(0, "Does it.\n\nExample:\n  tool 3", ""), Some("its usage does not have its name"));
    assert_eq!(answer(0, "tool X\n", ""), Some("it has no example"));
    assert_eq!(answer(0, "tool X\n\nExample:\n", ""), Some("it has no example"));
}
