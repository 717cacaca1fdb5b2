//! `render-lab completions`: completion scripts for shells.

use clap::Args;
use clap_complete::Shell;

use crate::{Failure, terminal};

/// Options of `completions`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  render-lab completions bash > ~/.local/share/bash-completion/completions/render-lab
  render-lab completions fish > ~/.config/fish/completions/render-lab.fish")]
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
