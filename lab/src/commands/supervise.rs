//! `render-lab supervise`: the second process of [`crate::supervise::run`]. It is not in the help.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::Args;

use crate::Failure;
use crate::supervise::Limits;

/// Options of `supervise`.
#[derive(Debug, Args)]
#[command(hide = true, after_help = "Examples:\n  render-lab supervise --printed . -- ls /tmp")]
pub struct Arguments {
    #[command(flatten)]
    limits: Limits,
    /// Folder for the files stdout.txt and stderr.txt
    #[arg(long, value_name = "FOLDER")]
    printed: PathBuf,
    /// The command
    #[arg(required = true, last = true)]
    command: Vec<OsString>,
}

impl Arguments {
    /// Runs the command, and prints as JSON how it ended and what it took.
    ///
    /// # Errors
    /// The command cannot be started, or [`Failure::Interrupted`].
    pub fn run(&self) -> Result<(), Failure> {
        super::print_json(&self.limits.watch(&self.command, &self.printed)?)
    }
}
