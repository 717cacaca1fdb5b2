//! Ctrl-C, and a request to end, as something to ask for instead of the end itself.

use std::ops::ControlFlow;

use cpu::internals::output::stop;

use crate::Failure;

/// Whether the process has been asked to stop.
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    listens: bool,
}

impl Interrupt {
    /// Listens to SIGHUP, SIGINT and SIGTERM from now on. The first of them is only noted. The second ends the process,
    /// for whoever sends it does not want to wait for the end of a row.
    #[must_use]
    pub fn listen() -> Self {
        stop::note_first_request();
        Self { listens: true }
    }

    /// Goes on, or breaks off after a request.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.listens && stop::requested() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// As a result.
    ///
    /// # Errors
    /// [`Failure::Interrupted`] after a request.
    pub fn check(&self) -> Result<(), Failure> {
        if self.flow().is_break() { Err(Failure::Interrupted) } else { Ok(()) }
    }
}
