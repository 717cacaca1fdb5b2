//! `render-lab help`: prints the help of a command, or a table of the lines that an input file may have.

use clap::Args;
use clap::builder::PossibleValuesParser;

use crate::format::hint::nearest;
use crate::{Failure, format, terminal};

/// Options of `help`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/help.txt").trim_ascii_end())]
pub struct Arguments {
    /// A command, or config or scene
    #[arg(value_parser = PossibleValuesParser::new(TOPICS.split(' ')), hide_possible_values = true)]
    topic: Option<String>,
    /// A command below it
    below: Vec<String>,
}

/// The words that completion scripts offer as a topic: every command, and both input files.
pub const TOPICS: &str = "animate bench check compare completions config convert diagnose explain generate grade inspect man \
                          render report scene shader time view";

impl Arguments {
    /// Prints the help of the topic.
    ///
    /// # Errors
    /// An error if there is no such topic, or if standard output cannot be written.
    pub fn run(&self, mut command: clap::Command) -> Result<(), Failure> {
        let text = match self.topic.iter().chain(&self.below).map(String::as_str).collect::<Vec<_>>()[..] {
            ["config"] => format!(
                "A configuration file: one key and its values a line, in any order; every key may be left out.\n\
                 Blank lines are ignored; of a key that is repeated the last counts.\n\n{}",
                format::config_table()
            ),
            ["scene"] => format!(
                "A scene file: one material or object a line; a material stands above the objects made of it.\n\n{}",
                format::scene_table()
            ),
            [file @ ("config" | "scene"), name, ..] => {
                return Err(format!("[{file}] is a file, and has no command or topic [{name}] below it").into());
            }
            ref path => {
                command.build();
                let mut found = &mut command;
                for name in path {
                    let names: Vec<_> = found.get_subcommands().map(|command| command.get_name().to_owned()).collect();
                    let close =
                        nearest(name.as_bytes(), names.iter().map(String::as_bytes)).map(String::from_utf8_lossy);
                    let advice = close.map_or("render-lab --help lists the commands".to_owned(), |close| {
                        format!("did you mean [{close}]?")
                    });
                    let missing = format!("there is no command or topic [{name}]; {advice}");
                    found = found.find_subcommand_mut(name).ok_or(missing)?;
                }
                found.render_long_help().to_string()
            }
        };
        terminal::write(text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::TOPICS;
    use crate::cli::Cli;

    #[test]
    fn every_command_and_file_is_a_topic() {
        let command = Cli::command();
        let shown = command.get_subcommands().filter(|command| !command.is_hide_set());
        let commands = shown.map(clap::Command::get_name).filter(|&name| name != "help");
        let mut expected: Vec<_> = commands.chain(["config", "scene"]).collect();
        expected.sort_unstable();
        assert_eq!(TOPICS.split(' ').collect::<Vec<_>>(), expected);
    }
}
