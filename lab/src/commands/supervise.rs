//! `render-lab supervise`: the second process of [`crate::supervise::run`]. It is not in the help.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::Args;

use crate::Failure;
use crate::supervise::{Limits, confine, watch};

/// Options of `supervise`.
#[derive(Debug, Args)]
#[command(hide = true, after_help = "Examples:\n  render-lab supervise --printed . -- ls /tmp")]
pub struct Arguments {
    #[command(flatten)]
    limits: Limits,
    /// Folder in which the command runs
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    place: PathBuf,
    /// Folder for the files stdout.txt and stderr.txt
    #[arg(long, value_name = "FOLDER")]
    printed: PathBuf,
    /// Keep the command away from all other processes, where the system allows it
    #[arg(long)]
    confined: bool,
    /// Folder of which the command sees nothing but its own folders
    #[arg(long, value_name = "FOLDER")]
    hidden: Vec<PathBuf>,
    /// Whether this is the first process of its own table of processes
    #[arg(long, hide = true)]
    inside: bool,
    /// The command
    #[arg(required = true, last = true)]
    command: Vec<OsString>,
}

impl Arguments {
    /// Runs the command, and prints as JSON how it ended and what it took.
    ///
    /// # Errors
    /// Standard output cannot be written, or [`Failure::Interrupted`].
    pub fn run(&self) -> Result<(), Failure> {
        if self.confined && !self.inside {
            let arguments: Vec<_> = std::env::args_os().skip(2).collect();
            match confine::inside(&arguments, &self.hidden, [&self.place, &self.printed])? {
                Some(0) => return Ok(()),
                Some(status) => return Err(Failure::Printed(status)),
                None => {}
            }
        }
        confine::protect(self.inside);
        watch::answer(&self.limits, &self.command, &self.place, &self.printed)
    }
}
