//! `render-lab completions` and `render-lab man`: completion scripts and manual pages for packages.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;
use output::{Options, Output};

use crate::{Failure, sources, terminal};

/// Options of `completions`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/completions.txt").trim_ascii_end())]
pub struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    /// Writes the completion script for the chosen shell to standard output.
    ///
    /// # Errors
    /// An error if standard output cannot be written.
    pub fn run(&self, command: &mut clap::Command) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, command, "render-lab", &mut script);
        if self.shell == Shell::Bash {
            // Works around an error of clap_complete 4.6.11 for programs with a hyphen in their name. Its script sets
            // `cmd` to names that begin with render__lab, but its labels begin with render__subcmd__lab. Without this
            // replacement, nothing below the first level is completed.
            let text = String::from_utf8_lossy(&script).replace("render__subcmd__lab", "render__lab");
            script = text.into_bytes();
        }
        terminal::write(&script)
    }
}

/// Options of `man`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  render-lab man ~/.local/share/man/man1 && man ~/.local/share/man/man1/render-lab-bench.1")]
pub struct Man {
    /// Folder for the pages, one for each command; it is made if it is not there
    folder: PathBuf,
}

impl Man {
    /// Writes a manual page for each command into the folder.
    ///
    /// # Errors
    /// An error if a file cannot be written.
    pub fn run(&self, command: clap::Command, options: Options) -> Result<(), Failure> {
        sources::make_folder(&self.folder)?;
        let mut command = command.disable_help_subcommand(true);
        command.build();
        self.write_page(command, options)
    }

    /// Writes the pages of all subcommands of `command`, and then the page of `command`.
    fn write_page(&self, command: clap::Command, options: Options) -> Result<(), Failure> {
        for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
            self.write_page(below.clone(), options)?;
        }
        let page = clap_mangen::Man::new(command);
        let mut text = Vec::new();
        page.render(&mut text)?;
        Ok(Output::open(&self.folder.join(page.get_filename()), options)?.fill(|file| file.write_all(&text))?)
    }
}
