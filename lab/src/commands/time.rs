//! `render-lab time`: measures any commands in turn.

use std::path::PathBuf;

use clap::Args;
use measure::statistics::Median;
use measure::turns::ratio;
use tempfile::TempDir;

use crate::bench::commands::{Job, Record, Rounds, Timed};
use crate::bench::machine::Machine;
use crate::report::style::{seconds, short};
use crate::{Failure, supervise, terminal};

/// Options of `time`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/time.txt").trim_ascii_end())]
pub struct Arguments {
    /// Commands, each in quotes
    #[arg(required = true, value_name = "COMMAND")]
    commands: Vec<String>,
    #[command(flatten)]
    rounds: Rounds,
    /// Run this command before each run, without measuring it
    #[arg(long, value_name = "COMMAND")]
    prepare: Option<String>,
    /// Measure each command with every value: {NAME} in a command stands for it. Given twice, with every pair of values
    #[arg(long, value_name = "NAME=VALUE,VALUE", value_parser = parameter)]
    parameter: Vec<Parameter>,
    /// Print the figures as JSON
    #[arg(long)]
    json: bool,
}

/// A name in commands, and the values that stand for it.
#[derive(Clone, Debug)]
struct Parameter {
    name: String,
    values: Vec<String>,
}

/// Reads a parameter such as `samples=1,2,4`.
fn parameter(text: &str) -> Result<Parameter, String> {
    let (name, values) =
        text.split_once('=').filter(|(name, _)| !name.is_empty()).ok_or("NAME=VALUE,VALUE is needed")?;
    let values: Vec<_> = values.split(',').map(str::to_owned).collect();
    if values.iter().any(String::is_empty) {
        return Err("a value is empty; NAME=VALUE,VALUE is needed".to_owned());
    }
    Ok(Parameter { name: name.to_owned(), values })
}

impl Arguments {
    /// Returns each command with all values of the parameters, and what prepares it.
    fn commands(&self) -> Result<Vec<[Option<String>; 2]>, String> {
        let mut all: Vec<_> =
            self.commands.iter().map(|command| [Some(command.clone()), self.prepare.clone()]).collect();
        for Parameter { name, values } in &self.parameter {
            let place = format!("{{{name}}}");
            if !self.commands.iter().chain(&self.prepare).any(|command| command.contains(&place)) {
                return Err(format!("--parameter {name}: no command has {place}"));
            }
            let with = |texts: &[Option<String>; 2], value: &str| {
                texts.clone().map(|text| text.map(|text| text.replace(&place, value)))
            };
            all = all.iter().flat_map(|texts| values.iter().map(|value| with(texts, value))).collect();
            // A command without the name is measured once.
            all.dedup();
        }
        Ok(all)
    }

    /// Measures the commands, and prints what they took.
    ///
    /// # Errors
    /// A command fails, or [`Failure::Interrupted`].
    pub fn run(&self) -> Result<(), Failure> {
        let machine = Machine::here();
        if let Some(warning) = measure::busy::warning(machine.load) {
            terminal::note(&warning);
        }
        let job = |command: &String| Job {
            name: command.clone(),
            words: ["sh", "-c", command].map(Into::into).to_vec(),
            place: PathBuf::from("."),
            hidden: Vec::new(),
        };
        let commands = self.commands()?;
        let names: Vec<_> = commands.iter().map(|[command, _]| command.clone().unwrap_or_default()).collect();
        let printed = TempDir::new()?;
        let run = |text: &String| {
            // A command that fails ends the measurement.
            job(text).run(printed.path(), &supervise::NONE).map_err(|failure| match failure {
                Failure::Program(message) => Failure::from(message).about(&terminal::escape_lines(text)),
                other => other,
            })
        };
        let timed = self.rounds.measure(&names, |_, index| {
            commands[index][1].as_ref().map_or(Ok(()), |prepare| run(prepare).map(drop))?;
            run(&names[index])
        })?;
        let record = Record { machine, commands: timed.into_iter().collect::<Result<_, _>>()? };
        super::print_as(self.json, &[], &record, || table(&record.commands))
    }
}

fn table(commands: &[Timed]) -> String {
    let bounded = |Median { median, low, high, .. }: Median, text: fn(f64) -> String| {
        format!("{} ({} to {})", text(median), text(low), text(high))
    };
    let row = |timed: &Timed| {
        let ratio = Some(ratio(&timed.elapsed, &commands[0].elapsed)).filter(|ratio| ratio.high.is_finite());
        vec![
            bounded(timed.wall, seconds),
            ratio.map_or_else(String::new, |ratio| bounded(ratio, short)),
            seconds(timed.median.median),
            format!("{:.1} MB", timed.memory),
            timed.joules.map_or_else(|| "no meter".to_owned(), |joules| format!("{} J", short(joules.median))),
            terminal::escape_lines(&timed.command),
        ]
    };
    let head = ["elapsed", "times the first", "user time", "memory", "energy", "command"].map(str::to_owned).to_vec();
    terminal::table(&std::iter::once(head).chain(commands.iter().map(row)).collect::<Vec<_>>())
}
