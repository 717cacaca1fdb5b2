//! A process that does not outlive its test.

use std::io;
use std::ops::{Deref, DerefMut};
use std::process::{Child, Command, Output};

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
