//! Asks whether a signal has requested the process to stop, so that a command can finish a row or a task and then end.
//!
//! [`listen`] starts to note SIGHUP, SIGINT and SIGTERM. The first signal is only noted, and the second ends the
//! process at once. So a user who does not want to wait for the end of a row sends the signal twice.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use nix::sys::signal::{SigSet, Signal};

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

/// Whether SIGUSR1 came since [`take_wish`] was called last.
static WISH: AtomicBool = AtomicBool::new(false);

fn wish() -> SigSet {
    SigSet::from(Signal::SIGUSR1)
}

/// Keeps SIGUSR1 from this thread and from those that it starts, so that only [`listen_for_wish`] gets it. Call it
/// before other threads are started.
pub fn block_wish() {
    // The only error is a wrong set of signals.
    let _ = wish().thread_block();
}

/// Starts to note SIGUSR1, the wish for a checkpoint.
pub fn listen_for_wish() {
    // Without another thread there is no checkpoint on request, but all others are written.
    let _ = std::thread::Builder::new().name("wish".to_owned()).stack_size(1 << 16).spawn(|| {
        while wish().wait().is_ok() {
            WISH.store(true, Ordering::Relaxed);
        }
    });
}

/// Returns whether there is a wish for a checkpoint, and forgets it.
pub fn take_wish() -> bool {
    WISH.swap(false, Ordering::Relaxed)
}
