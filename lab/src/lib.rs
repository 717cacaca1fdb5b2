//! The everyday and measuring tool around the renderer.
//!
//! Each command has a module of its own in [`commands`]; what they share lies beside it: pictures from files
//! ([`picture`]), how two of them differ ([`difference`]), which renderer is meant ([`engine`]), what a process has
//! used ([`usage`]). Measuring lives in [`mod@bench`], and [`report`] turns its data into charts and pages.
//!
//! Rendering is `cpu`'s alone, on one thread: this crate adds eyes and clocks.

pub mod bench;
pub mod cli;
pub mod commands;
pub mod difference;
pub mod engine;
pub mod failure;
pub mod format;
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

/// Stack of the thread that does all work, in bytes.
const STACK_BYTES: usize = 8 << 20;

/// Runs the command on this process' arguments; an error goes to standard error.
#[must_use]
pub fn main() -> ExitCode {
    // From here on a signal that ends the process leaves no temporary file.
    cpu::internals::output::stop::remove_temporary_when_stopped();
    // The limit on the main thread's stack may be smaller than rendering needs, which is some 300 kB in a debug build.
    let thread = std::thread::Builder::new().name("main".to_owned()).stack_size(STACK_BYTES);
    match thread.spawn(run).map(std::thread::JoinHandle::join) {
        Ok(Ok(status)) => status,
        // A panic has said what it had to say.
        Ok(Err(_)) => ExitCode::from(2),
        // There is too little memory for another stack.
        Err(_) => run(),
    }
}

fn run() -> ExitCode {
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
            cpu::internals::input::text::escape(argument.as_encoded_bytes()).as_bytes() == argument.as_encoded_bytes()
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
