//! Notes signals that ask the process to stop, so that a command can finish a row or a task and then end.

use std::ops::ControlFlow;

use output::stop;

use crate::Failure;

/// Tells whether the process has been asked to stop. The default value never does; it is for tests.
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    listens: bool,
}

impl Interrupt {
    /// Listens to SIGHUP, SIGINT and SIGTERM from now on. The first signal is only noted. The second signal ends the
    /// process at once, because the user does not want to wait for the end of a row.
    #[must_use]
    pub fn listen() -> Self {
        stop::note_first_request();
        Self { listens: true }
    }

    /// Returns `Break` after a request to stop, else `Continue`.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.listens && stop::requested() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Returns an error after a request to stop.
    ///
    /// # Errors
    /// [`Failure::Interrupted`] after a request to stop.
    pub fn check(&self) -> Result<(), Failure> {
        if self.flow().is_break() { Err(Failure::Interrupted) } else { Ok(()) }
    }
}
