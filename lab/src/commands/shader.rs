//! `render-lab shader`: starts `shader-lab`, which is a program of its own because it needs a Vulkan driver.

use std::ffi::OsString;
use std::io::ErrorKind;
use std::os::unix::process::CommandExt;
use std::process::Command;

use clap::Args;

use crate::Failure;

/// The program that is started.
const PROGRAM: &str = "shader-lab";

/// Options of `shader`.
#[derive(Debug, Args)]
#[command(disable_help_flag = true, after_help = include_str!("../../help/shader.txt").trim_ascii_end())]
pub struct Arguments {
    /// The arguments of shader-lab
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENT")]
    arguments: Vec<OsString>,
}

impl Arguments {
    /// Replaces this process by `shader-lab`, which is looked for in `PATH`.
    ///
    /// # Errors
    /// A message with the command that installs it, if it is not there.
    pub fn run(&self) -> Result<(), Failure> {
        // Its messages and its help name the command that the user knows.
        let error = Command::new(PROGRAM).arg0("render-lab shader").args(&self.arguments).exec();
        Err(match error.kind() {
            ErrorKind::NotFound => format!(
                "{PROGRAM} is not installed. In a checkout of this project: cargo install --locked --path gpu-check \
                 --bin {PROGRAM}"
            ),
            _ => format!("{PROGRAM} cannot be started: {error}"),
        }
        .into())
    }
}
