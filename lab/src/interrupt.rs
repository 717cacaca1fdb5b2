//! Asks whether a signal has requested the process to stop, so that a command can finish a row or a task and then end.
//!
//! [`listen`] starts to note SIGHUP, SIGINT and SIGTERM. The first signal is only noted, and the second ends the
//! process at once. So a user who does not want to wait for the end of a row sends the signal twice.

use std::ops::ControlFlow;

pub use output::stop::note_first_request as listen;
use output::stop::requested;

use crate::Failure;

/// Returns `Break` if the process has been asked to stop since [`listen`] was called, and otherwise `Continue`.
pub fn flow() -> ControlFlow<()> {
    if requested() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// Returns `Ok` unless the process has been asked to stop since [`listen`] was called.
///
/// # Errors
/// [`Failure::Interrupted`] if the process has been asked to stop.
pub fn check() -> Result<(), Failure> {
    if requested() { Err(Failure::Interrupted) } else { Ok(()) }
}
