//! The shared code of `render-aos` and `render-soa`: reads the arguments, reports errors, and returns the exit status.

mod error;
pub mod program;

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

pub use crate::error::Error;

/// Runs the program with the arguments of this process. An error gives status 1, and its message is written to standard
/// error. It is written byte for byte, except on a terminal, for which control characters are escaped.
#[must_use]
pub fn main<L: cpu::Layout>() -> ExitCode {
    #[cfg(unix)]
    output::stop::remove_temporary_when_stopped();
    match program::run::<L>(std::env::args_os().skip(1)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let mut stderr = std::io::stderr();
            let message = if stderr.is_terminal() { error.message_for_terminal() } else { error.message() };
            // If standard error is closed, only the status reports the error.
            let _ = stderr.write_all(&[b"Error: ", &message[..], b"\n"].concat());
            ExitCode::FAILURE
        }
    }
}
