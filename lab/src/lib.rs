//! The everyday and measuring tool around the renderer.
//!
//! Each command has a module of its own in [`commands`]; what they share lies beside it: pictures from files
//! ([`picture`]), how two of them differ ([`difference`]), which renderer is meant ([`engine`]), what a process has used
//! ([`usage`]). Measuring lives in [`mod@bench`], and [`report`] turns its data into charts and pages.
//!
//! Rendering is `cpu`'s alone, on one thread: this crate adds eyes and clocks.

pub mod bench;
pub mod cli;
pub mod commands;
pub mod difference;
pub mod engine;
pub mod failure;
pub mod heatmap;
pub mod interrupt;
pub mod picture;
pub mod report;
pub mod sources;
pub mod terminal;
pub mod usage;

use std::ffi::OsString;
use std::io::IsTerminal;
use std::process::ExitCode;

use clap::Parser;

pub use failure::Failure;

/// Runs the command on this process' arguments; an error goes to standard error.
#[must_use]
pub fn main() -> ExitCode {
    // From here on a signal that ends the process leaves no temporary file.
    cpu::output::stop::remove_temporary_when_stopped();
    match command_line().and_then(|cli| cli.run()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if let Some(message) = failure.message() {
                terminal::note(&format!("Error: {message}"));
            }
            ExitCode::from(failure.status())
        }
    }
}

/// What this process was asked for.
fn command_line() -> Result<cli::Cli, Failure> {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    cli::Cli::try_parse_from(&arguments).map_err(|error| {
        let is_clean = |argument: &OsString| {
            cpu::text::escape(argument.as_encoded_bytes()).as_bytes() == argument.as_encoded_bytes()
        };
        if error.use_stderr() && arguments.iter().all(is_clean) {
            let _ = error.print();
            return Failure::CommandLine;
        }
        if error.use_stderr() {
            // It repeats what was typed, which could command the terminal.
            terminal::note(&error.render().to_string());
            return Failure::CommandLine;
        }
        let written = if std::io::stdout().is_terminal() {
            error.print().map_err(Failure::from)
        } else {
            terminal::write(error.render().to_string().as_bytes())
        };
        written.err().unwrap_or(Failure::Help)
    })
}
