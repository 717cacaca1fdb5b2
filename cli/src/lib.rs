//! What `render-aos` and `render-soa` share: arguments in, messages and exit status out.

use std::io::Write;
use std::process::ExitCode;

/// Runs the program on this process' arguments. An error goes to standard error, byte for byte, and gives status 1.
#[must_use]
pub fn main<L: cpu::Layout>() -> ExitCode {
    #[cfg(unix)]
    cpu::output::stop::remove_temporary_when_stopped();
    match cpu::program::run::<L>(std::env::args_os().skip(1)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let message = [b"Error: ", &error.message()[..], b"\n"].concat();
            // Where standard error is closed there is nobody left to tell; the status still says it.
            let _ = std::io::stderr().write_all(&message);
            ExitCode::FAILURE
        }
    }
}
