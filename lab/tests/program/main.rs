//! Runs the built program `render-lab` as a user would.

mod attacks;
mod bench;
mod check;
mod checkpoint;
mod class;
mod compare;
mod completion;
mod diagnose;
mod files;
mod grading;
mod hostile;
mod limits;
mod memory;
mod mutated;
mod pictures;
mod render;
mod results;
mod rubric;
mod scenes;
mod scripts;
mod slurm;

use std::process::{Command, Output};

/// The variable that names the folder of the course's cases. Checks and gradings then have more cases than these tests
/// expect, so all commands run without it.
const COURSE: &str = "RENDER_REFERENCE_DIR";

/// Returns the command `render-lab` with these arguments. Its working folder is the project's root.
fn lab(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
    command.current_dir(test_support::project_root()).env_remove(COURSE).args(arguments);
    command
}

/// Runs `render-lab` with these arguments until it ends, and returns its output and status.
fn run(arguments: &[&str]) -> Output {
    lab(arguments).output().expect("the program runs")
}

/// Runs `render-lab`, checks that it succeeds, and returns what it printed on standard output.
fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).expect("it prints text")
}

/// Runs `render-lab`, and checks that it fails with status 2 and prints nothing on standard output. Returns what it
/// printed on standard error.
fn complaint(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
    assert!(output.stdout.is_empty(), "{output:?}");
    String::from_utf8(output.stderr).expect("it complains in text")
}

/// Runs a line of bash in `folder`. In the line, `$lab` is the path of the program and `$root` that of the project.
fn bash(folder: &test_support::folder::Folder, line: &str) -> Output {
    let mut bash = test_support::running::bash();
    // Without this, bash would split a path with blanks.
    let line = format!("IFS=$'\\n'; {line}");
    bash.current_dir(folder.path()).args(["-c", &line]).env("lab", env!("CARGO_BIN_EXE_render-lab"));
    bash.env("root", test_support::project_root()).env_remove(COURSE);
    bash.output().expect("bash starts")
}

/// Runs a line of bash as [`bash`] does, and checks that it fails with status 2. Returns what it printed on standard
/// error.
fn bash_complaint(folder: &test_support::folder::Folder, line: &str) -> String {
    let output = bash(folder, line);
    assert_eq!(output.status.code(), Some(2), "{line}: {output:?}");
    String::from_utf8(output.stderr).expect("it complains in text")
}
