//! Checks that every script of the project explains its use for `--help`. Scripts are found in the folders, so a new
//! script is tested from its start.

use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};

use test_support::folder::Folder;

use crate::files;

/// Returns the program that runs a script of the project, or `None` for any other file. A script is an executable file
/// that begins with `#!/usr/bin/env` and the program's name. Hidden folders may hold other tools, so they are left out,
/// except for the folder of the continuous integration.
fn interpreter(root: &Path, path: &Path) -> Option<String> {
    let first = path.strip_prefix(root).ok()?.iter().next()?.to_str()?;
    if first.starts_with('.') && first != ".ci" {
        return None;
    }
    let metadata = path.metadata().ok()?;
    if !metadata.is_file() || metadata.permissions().mode() & 0o111 == 0 {
        return None;
    }
    let content = std::fs::read(path).ok()?;
    let program = content.strip_prefix(b"#!/usr/bin/env ")?.split(|byte| *byte == b'\n').next()?;
    Some(String::from_utf8_lossy(program).into_owned())
}

fn is_installed(program: &str) -> bool {
    Command::new(program).arg("--version").stdout(Stdio::null()).status().is_ok_and(|status| status.success())
}

/// Returns whether a script's help has an example: a line with the script's path that can be copied as it is. Such a
/// line has no optional part in brackets and no placeholder, which is a word in capital letters, after the path.
fn has_example(script: &str, said: &str) -> bool {
    let is_placeholder = |word: &str| word.len() > 1 && word.chars().all(|letter| letter.is_ascii_uppercase());
    let can_be_copied = |rest: &str| !rest.contains('[') && !rest.split_whitespace().any(is_placeholder);
    said.lines().filter_map(|line| line.split_once(script)).any(|(before, rest)| {
        line_starts_with_the_command(before) && can_be_copied(rest.split_once('#').map_or(rest, |(command, _)| command))
    })
}

/// Returns whether only white space and settings of variables, as in `N=3`, stand before a command.
fn line_starts_with_the_command(before: &str) -> bool {
    before.starts_with(' ') && before.split_whitespace().all(|word| word.contains('='))
}

#[test]
fn every_script_answers_help_and_writes_nothing() {
    let root = test_support::project_root();
    let folder = Folder::new();
    // A relative path from elsewhere shows that no script looks for itself after it has changed its folder.
    let elsewhere = folder.file("a/b");
    std::fs::create_dir_all(&elsewhere).expect("the folder is writable");
    std::os::unix::fs::symlink(&root, folder.file("project")).expect("the folder is writable");
    let before = files(&root);
    let mut faults = Vec::new();
    let mut answered = 0;
    for path in before.keys() {
        let Some(program) = interpreter(&root, path) else { continue };
        let script = path.strip_prefix(&root).expect("it is below the root").display().to_string();
        if !is_installed(&program) {
            println!("{script}: {program} is not installed, so the script was not tried");
            continue;
        }
        answered += 1;
        let command = ["-c", "\"$0\" --help", &format!("../../project/{script}")];
        let output = Command::new("sh").args(command).current_dir(&elsewhere).output().expect("the shell starts");
        let said = String::from_utf8_lossy(&output.stdout);
        if output.status.code() != Some(0) || !output.stderr.is_empty() {
            faults.push(format!("{script}: {:?}, {}", output.status, String::from_utf8_lossy(&output.stderr)));
        } else if !has_example(&script, &said) {
            faults.push(format!("{script}: it has no example"));
        }
    }
    assert_eq!(faults, [""; 0]);
    assert_eq!(files(&root), before, "a script wrote into the project");
    assert_eq!(files(folder.path()).len(), 1, "a script wrote into its folder");
    assert!(answered >= 19, "only {answered} scripts were tried");
}

#[test]
fn an_example_can_be_copied() {
    assert!(has_example("tests/run", "Runs.\n\n  tests/run --browser\n"));
    assert!(has_example("tests/run", "Runs.\n\n  N=3 tests/run 5     # for FOLDER\n"));
    assert!(!has_example("tests/run", "Runs.\n\n  tests/run [FILTER]\n"));
    assert!(!has_example("tests/run", "Runs.\n\n  tests/run FOLDER\n"));
    assert!(!has_example("tests/run", "As tests/run, but more.\n"));
}
