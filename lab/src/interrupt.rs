//! Ctrl-C, and a request to end, as something to ask for instead of the end itself.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::Failure;

/// Whether somebody has asked to stop.
#[derive(Clone, Debug, Default)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens to SIGINT, SIGTERM and SIGHUP from now on.
    ///
    /// # Errors
    /// The system does not let it.
    pub fn listen() -> Result<Self, Failure> {
        let interrupt = Self::default();
        let flag = Arc::clone(&interrupt.0);
        ctrlc::set_handler(move || {
            // Asked a second time: whoever waits does not want to wait for the end of a row.
            if flag.swap(true, Ordering::SeqCst) {
                // Nor for the end of a file, which then goes.
                #[cfg(unix)]
                cpu::output::stop::remove_temporary();
                std::process::exit(130);
            }
        })
        .map_err(|error| Failure::Other(error.to_string()))?;
        Ok(interrupt)
    }

    /// Goes on, or breaks off once somebody has asked.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.0.load(Ordering::SeqCst) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// As a result.
    ///
    /// # Errors
    /// [`Failure::Interrupted`] once somebody has asked.
    pub fn check(&self) -> Result<(), Failure> {
        if self.flow().is_break() { Err(Failure::Interrupted) } else { Ok(()) }
    }
}
