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
        let output = Command::new("sh")
            .env("LC_ALL", "C")
            .args(command)
            .current_dir(&elsewhere)
            .output()
            .expect("the shell starts");
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
    assert!(answered >= 15, "only {answered} scripts were tried");
}

/// Most entry points: scripts, and programs that no script starts.
const MOST_ENTRY_POINTS: usize = 25;

/// Most variables of the environment whose names begin with `RENDER_`.
const MOST_VARIABLES: usize = 12;

/// Returns the words in code spans of the first cells, or of the last cells, of a table in CONTRIBUTING.md.
fn in_table(heading: &str, is_last: bool) -> Vec<String> {
    let text = std::fs::read_to_string(test_support::project_root().join("CONTRIBUTING.md")).expect("it is there");
    let section = text.split("\n## ").find(|section| section.starts_with(heading)).expect("the heading is there");
    let rows = section.lines().filter(|line| line.starts_with("| ")).skip(1);
    let cells =
        rows.filter_map(|row| row.trim_matches('|').split_once('|').map(|(one, two)| if is_last { two } else { one }));
    let spans = cells.flat_map(|cell| cell.split('`').skip(1).step_by(2));
    let words = spans.filter_map(|span| span.split([' ', '=']).next());
    let mut words: Vec<_> =
        words.filter(|word| !word.starts_with("--") && *word != "cargo").map(str::to_owned).collect();
    words.sort();
    words.dedup();
    words
}

#[test]
fn one_table_has_every_entry_point_and_one_every_variable() {
    let root = test_support::project_root();
    let all = files(&root);
    let name = |path: &Path| path.strip_prefix(&root).expect("it is below the root").display().to_string();
    let scripts = all.keys().filter(|path| interpreter(&root, path).is_some()).map(|path| name(path));
    let entries = in_table("Which command", true);
    let missing: Vec<_> = scripts.filter(|script| !entries.contains(script)).collect();
    assert!(missing.is_empty(), "CONTRIBUTING.md has no row for {missing:?}");
    assert!((15..=MOST_ENTRY_POINTS).contains(&entries.len()), "{} entry points: {entries:?}", entries.len());

    let listed = in_table("Which variables", false);
    assert!((5..=MOST_VARIABLES).contains(&listed.len()), "{} variables: {listed:?}", listed.len());
    for path in all.keys() {
        let Ok(text) = std::fs::read_to_string(path) else { continue };
        for rest in text.split("RENDER_").skip(1) {
            let end = rest.find(|letter: char| !letter.is_ascii_uppercase() && letter != '_').unwrap_or(rest.len());
            let variable = format!("RENDER_{}", &rest[..end]);
            // Those of a process that a unit test starts are no one else's.
            let is_internal = rest.is_empty() || end == 0 || variable.starts_with("RENDER_STOP_");
            assert!(
                is_internal || listed.contains(&variable),
                "CONTRIBUTING.md has no row for {variable} in {}",
                name(path)
            );
        }
    }
}

#[test]
fn an_example_can_be_copied() {
    assert!(has_example("tests/run", "Runs.\n\n  tests/run --browser\n"));
    assert!(has_example("tests/run", "Runs.\n\n  N=3 tests/run 5     # for FOLDER\n"));
    assert!(!has_example("tests/run", "Runs.\n\n  tests/run [FILTER]\n"));
    assert!(!has_example("tests/run", "Runs.\n\n  tests/run FOLDER\n"));
    assert!(!has_example("tests/run", "As tests/run, but more.\n"));
}
