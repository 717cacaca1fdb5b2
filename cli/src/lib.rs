//! The shared code of `render-aos` and `render-soa`: reads the arguments, reports errors, and returns the exit status.

mod error;
pub mod program;
mod stack;

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

pub use crate::error::Error;

/// Runs a program with the arguments of this process, and returns its exit status: 0, or 1 after an error. The message
/// of an error is written to standard error byte for byte. If standard error is a terminal, control characters are
/// escaped.
#[must_use]
pub fn main<L: cpu::Renderable>() -> ExitCode {
    output::stop::remove_temporary_when_stopped();
    match program::run::<L>(std::env::args_os().skip(1)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let mut stderr = std::io::stderr();
            let message = error.message(stderr.is_terminal());
            // An error is ignored: if standard error is closed, only the exit status tells of the failure.
            let _ = stderr.write_all(&[b"Error: ", &message[..], b"\n"].concat());
            ExitCode::FAILURE
        }
    }
}
