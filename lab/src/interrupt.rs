//! Records signals that request the process to stop, so that a command can finish a row or a task and then end.

use std::ops::ControlFlow;

use output::stop;

use crate::Failure;

/// Tells whether the process has been asked to stop. The default value ignores such requests; tests use it.
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    listens: bool,
}

impl Interrupt {
    /// Starts to listen for SIGHUP, SIGINT and SIGTERM. The first signal is only recorded, and the second ends the
    /// process at once. So a user who does not want to wait for the end of a row sends the signal twice.
    pub fn listen() -> Self {
        stop::note_first_request();
        Self { listens: true }
    }

    /// Returns `Break` if the process has been asked to stop, and otherwise `Continue`.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.listens && stop::requested() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Returns `Ok` unless the process has been asked to stop.
    ///
    /// # Errors
    /// [`Failure::Interrupted`] if the process has been asked to stop.
    pub fn check(&self) -> Result<(), Failure> {
        if self.flow().is_break() { Err(Failure::Interrupted) } else { Ok(()) }
    }
}
