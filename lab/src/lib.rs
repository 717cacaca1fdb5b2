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
pub mod format;
pub mod heatmap;
pub mod interrupt;
pub mod picture;
pub mod report;
pub mod sources;
pub mod usage;

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

pub use failure::Failure;

/// Runs the command on this process' arguments; an error goes to standard error.
#[must_use]
pub fn main() -> ExitCode {
    match cli::Cli::parse().command.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if let Some(message) = failure.message() {
                let line = [b"Error: ", &message[..], b"\n"].concat();
                // Where standard error is closed there is nobody left to tell; the status still says it.
                let _ = std::io::stderr().write_all(&line);
            }
            ExitCode::from(failure.status())
        }
    }
}
