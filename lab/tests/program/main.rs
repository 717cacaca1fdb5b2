//! The built program, run as a user would.

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
mod scripts;
#[cfg(unix)]
mod slurm;
mod words;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// `render-lab` with these arguments, in the project's folder.
fn lab(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
    command.current_dir(test_support::project_root()).args(arguments);
    command
}

/// Runs to the end.
fn run(arguments: &[&str]) -> Output {
    lab(arguments).output().expect("the program runs")
}

/// Runs, and gives what it printed on standard output.
fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).expect("it prints text")
}

/// Runs what must go wrong with status 2, a message on standard error and nothing on standard output.
fn complaint(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
    assert!(output.stdout.is_empty(), "{output:?}");
    String::from_utf8(output.stderr).expect("it complains in text")
}

/// A folder removed at the end.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("the temporary folder is writable"))
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn name(&self, name: &str) -> String {
        self.file(name).to_str().expect("temporary names are text").to_owned()
    }

    fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.path()).expect("the folder is readable");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("it is readable").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}
