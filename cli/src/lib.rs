//! What `render-aos` and `render-soa` share: arguments in, messages and exit status out.

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

/// Runs the program on this process' arguments. An error goes to standard error and gives status
/// 1: byte for byte, but escaped where standard error is a terminal.
#[must_use]
pub fn main<L: cpu::Layout>() -> ExitCode {
    #[cfg(unix)]
    cpu::program::remove_temporary_when_stopped();
    match cpu::program::run::<L>(std::env::args_os().skip(1)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let mut stderr = std::io::stderr();
            let message = if stderr.is_terminal() { error.message_for_terminal() } else { error.message() };
            // Where standard error is closed nothing can be said; the status still tells.
            let _ = stderr.write_all(&[b"Error: ", &message[..], b"\n"].concat());
            ExitCode::FAILURE
        }
    }
}
