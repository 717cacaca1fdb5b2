//! The command line: all commands with their options.

use clap::{CommandFactory, Parser, Subcommand};
use cpu::internals::InstructionSet;
use output::Options;

use crate::Failure;
use crate::commands::{
    animate, bench, check, compare, completions, convert, diagnose, explain, generate, grade, help, inspect, render,
    report, shader, supervise, time, view,
};

/// Returns the version, the commit, and the instruction set that the renderer chooses on this machine.
fn version() -> String {
    let set = InstructionSet::chosen().name();
    format!("{} (commit {}, {set})", env!("CARGO_PKG_VERSION"), env!("LAB_COMMIT"))
}

/// Renders spheres and cylinders, compares pictures, and measures how long it all takes.
#[derive(Debug, Parser)]
#[command(
    name = "render-lab",
    version = version(),
    disable_help_subcommand = true,
    after_help = include_str!("../help/program.txt").trim_ascii_end(),
    max_term_width = 120
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Do not wait until files are on the disk: faster, but a loss of power may damage them
    #[arg(long, global = true)]
    pub no_sync: bool,
}

impl Cli {
    /// Runs the command that the command line names.
    ///
    /// # Errors
    /// The reason why the command ended early.
    pub fn run(&self) -> Result<(), Failure> {
        self.command.run(Options { sync: !self.no_sync })
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render a scene into a picture, with progress on a terminal
    Render(render::Arguments),
    /// Render a turn of the camera, or its way to another one, as frames or as one animated PNG
    Animate(animate::Arguments),
    /// Say how far two pictures differ, and whether the course accepts it
    Compare(compare::Arguments),
    /// Hold any program with the statement's command line to the specification
    Check(check::Arguments),
    /// Name why a program's pictures are not those of the statement
    Diagnose(diagnose::Arguments),
    /// Tell the life of a pixel: draws, rays, hits, colours, bytes
    Explain(explain::Arguments),
    /// Check, measure and grade the programs of a folder
    Grade(grade::Arguments),
    /// Write a picture in another format: PPM, PNG, PFM, NPY, EXR
    Convert(convert::Arguments),
    /// Say what is in a scene and how the renderer prepares for it
    Inspect(inspect::Arguments),
    /// Write a random scene, the same for the same seed, and a configuration that shows it
    Generate(generate::Arguments),
    /// Measure run time and error
    Bench(bench::Arguments),
    /// Measure any commands in turn
    Time(time::Arguments),
    /// Run one command under limits
    #[command(hide = true)]
    Supervise(supervise::Arguments),
    /// Turn measured data into charts and one self-contained HTML page
    Report(report::Arguments),
    /// Serve a page on this machine that edits a scene and shows its picture
    View(view::Arguments),
    /// Start shader-lab, which renders with a user's WGSL
    Shader(shader::Arguments),
    /// Write completions for a shell to standard output
    Completions(completions::Completions),
    /// Write manual pages into a folder
    Man(completions::Man),
    /// Explain a command, or the lines of a file: help config, help scene
    Help(help::Arguments),
}

impl Command {
    /// Runs the command. `options` tells how it writes its files.
    ///
    /// # Errors
    /// The reason why the command ended early.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        // The renderer would ignore a wrong name, and another set would be used or measured.
        InstructionSet::named()?;
        match self {
            Self::Render(arguments) => arguments.run(options),
            Self::Animate(arguments) => arguments.run(options),
            Self::Compare(arguments) => arguments.run(options),
            Self::Check(arguments) => arguments.run(options),
            Self::Diagnose(arguments) => arguments.run(),
            Self::Explain(arguments) => arguments.run(),
            Self::Grade(arguments) => arguments.run(options),
            Self::Convert(arguments) => arguments.run(options),
            Self::Inspect(arguments) => arguments.run(),
            Self::Generate(arguments) => arguments.run(options),
            Self::Bench(arguments) => arguments.run(options),
            Self::Time(arguments) => arguments.run(),
            Self::Supervise(arguments) => arguments.run(),
            Self::Report(arguments) => arguments.run(options),
            Self::View(arguments) => arguments.run(options),
            Self::Shader(arguments) => arguments.run(),
            Self::Completions(arguments) => arguments.run(&mut Cli::command()),
            Self::Man(arguments) => arguments.run(Cli::command(), options),
            Self::Help(arguments) => arguments.run(Cli::command()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Adds `command` and all commands below it to `into`.
    fn all(command: &clap::Command, into: &mut Vec<clap::Command>) {
        into.push(command.clone());
        for child in command.get_subcommands().filter(|child| child.get_name() != "help") {
            all(child, into);
        }
    }

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn every_command_that_does_something_shows_examples() {
        let mut commands = Vec::new();
        all(&Cli::command(), &mut commands);
        let leaves: Vec<_> = commands.iter().filter(|command| !command.has_subcommands()).collect();
        assert!(leaves.len() >= 12, "{} commands", leaves.len());
        for command in leaves {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(help.contains("Examples:\n") && help.contains("render-lab"), "{}: {help}", command.get_name());
            // In a narrower terminal, a longer example would be broken into two commands.
            let is_whole = |line: &str| !line.starts_with("  render-lab") || line.len() <= 100;
            assert!(help.lines().all(is_whole), "{help}");
        }
    }
}
