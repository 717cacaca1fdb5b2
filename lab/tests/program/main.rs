//! Runs the built program as a user would.

mod bench;
mod compare;
#[cfg(unix)]
mod completion;
mod files;
#[cfg(unix)]
mod hostile;
#[cfg(unix)]
mod limits;
mod render;
#[cfg(unix)]
mod results;
#[cfg(unix)]
mod scripts;
#[cfg(unix)]
mod slurm;
mod words;

use std::process::{Command, Output};

/// Returns the command `render-lab` with these arguments, in the project's folder.
fn lab(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
    command.current_dir(test_support::project_root()).args(arguments);
    command
}

/// Runs `render-lab` to its end.
fn run(arguments: &[&str]) -> Output {
    lab(arguments).output().expect("the program runs")
}

/// Runs `render-lab`, which must succeed, and returns what it printed on standard output.
fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).expect("it prints text")
}

/// Runs `render-lab`, which must fail with status 2 and print nothing on standard output. Returns what it printed on
/// standard error.
fn complaint(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
    assert!(output.stdout.is_empty(), "{output:?}");
    String::from_utf8(output.stderr).expect("it complains in text")
}

/// Runs a line of bash in `folder`, where `$lab` is the program and `$root` the project.
#[cfg(unix)]
fn bash(folder: &test_support::folder::Folder, line: &str) -> Output {
    let mut bash = Command::new("bash");
    bash.current_dir(folder.path()).args(["-c", line]).env("lab", env!("CARGO_BIN_EXE_render-lab"));
    bash.env("root", test_support::project_root());
    bash.output().expect("bash starts")
}
