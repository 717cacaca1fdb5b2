//! How tests start a program, and a process that does not outlive its test.

use std::ffi::OsStr;
use std::io;
use std::ops::{Deref, DerefMut};
use std::process::{Child, Command, Output};

/// The variable with which Cargo runs the test programs under another program, for instance `qemu-x86_64 -cpu Nehalem`.
const RUNNER: &str = "CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_RUNNER";

/// Returns a command that runs the program at `path`, under Cargo's runner if there is one. With an emulator as the
/// runner, a test would otherwise run on the emulated processor, and start `path` on that of the machine.
#[must_use]
pub fn program(path: impl AsRef<OsStr>) -> Command {
    let runner = std::env::var(RUNNER).unwrap_or_default();
    let mut words = runner.split_whitespace();
    let Some(first) = words.next() else { return Command::new(path) };
    let mut command = Command::new(first);
    command.args(words).arg(path);
    command
}

/// Returns the command `bash` with messages in English. With a locale that is not installed, bash would also print a
/// warning.
#[must_use]
pub fn bash() -> Command {
    let mut command = Command::new("bash");
    command.env("LC_ALL", "C");
    command
}

/// A running process. It is killed when this value is dropped, so that it ends even if the test fails.
#[derive(Debug)]
pub struct Running(Option<Child>);

impl Running {
    /// Starts the process.
    ///
    /// # Errors
    /// The system's error.
    pub fn start(command: &mut Command) -> io::Result<Self> {
        command.spawn().map(|child| Self(Some(child)))
    }

    /// Waits for the end of the process, and returns what it wrote into its pipes.
    ///
    /// # Errors
    /// The system's error.
    pub fn output(mut self) -> io::Result<Output> {
        self.0.take().ok_or(io::ErrorKind::NotFound)?.wait_with_output()
    }
}

impl Deref for Running {
    type Target = Child;

    fn deref(&self) -> &Child {
        self.0.as_ref().expect("only `output` takes it")
    }
}

impl DerefMut for Running {
    fn deref_mut(&mut self) -> &mut Child {
        self.0.as_mut().expect("only `output` takes it")
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        if let Some(mut child) = self.0.take() {
            // An error is ignored: the process has ended already.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}
