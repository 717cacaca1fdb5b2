//! `render-lab help`: prints the help of a command, or a table of the lines that an input file may have.

use clap::Args;

use crate::{Failure, format, terminal};

/// Options of `help`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  render-lab help config       every key of a configuration, its values, its default and what it means
  render-lab help scene        every line of a scene
  render-lab help bench scale  the options of a command")]
pub struct Arguments {
    /// A command, or config or scene
    topic: Vec<String>,
}

impl Arguments {
    /// Prints the help of the topic.
    ///
    /// # Errors
    /// An error if there is no such topic, or if standard output cannot be written.
    pub fn run(&self, mut command: clap::Command) -> Result<(), Failure> {
        let text = match self.topic.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["config"] => format!(
                "A configuration file: one key and its values a line, in any order; every key may be left out.\n\
                 Blank lines are ignored; of a key that is repeated the last counts.\n\n{}",
                format::config_table()
            ),
            ["scene"] => format!(
                "A scene file: one material or object a line; a material stands above the objects made of it.\n\n{}",
                format::scene_table()
            ),
            ref path => {
                command.build();
                let mut found = &mut command;
                for name in path {
                    let missing =
                        format!("there is no command or topic [{name}]; render-lab --help lists the commands");
                    found = found.find_subcommand_mut(name).ok_or(missing)?;
                }
                found.render_long_help().to_string()
            }
        };
        terminal::write(text.as_bytes())
    }
}
