//! `render-lab time`: measures any commands in turn.

use std::path::PathBuf;

use clap::Args;
use measure::statistics::Median;
use measure::turns::ratio;

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
    /// Print the figures as JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
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
        };
        let jobs: Vec<_> = self.commands.iter().map(job).collect();
        let timed = self.rounds.measure(&jobs, &supervise::NONE, true)?;
        let record = Record { machine, commands: timed.into_iter().collect::<Result<_, _>>()? };
        super::print_as(self.json, &[], &record, || table(&record.commands))
    }
}

fn table(commands: &[Timed]) -> String {
    let bounded = |Median { median, low, high, .. }: Median, text: fn(f64) -> String| {
        format!("{} ({} to {})", text(median), text(low), text(high))
    };
    let row = |timed: &Timed| {
        // The system's clock of user time may count nothing for a short command.
        let ratio = Some(ratio(&timed.seconds, &commands[0].seconds)).filter(|ratio| ratio.high.is_finite());
        vec![
            bounded(timed.median, seconds),
            ratio.map_or_else(String::new, |ratio| bounded(ratio, short)),
            seconds(timed.wall.median),
            format!("{:.1} MB", timed.memory),
            timed.joules.map_or_else(|| "no meter".to_owned(), |joules| format!("{} J", short(joules.median))),
            terminal::escape_lines(&timed.command),
        ]
    };
    let head = ["user time", "times the first", "elapsed", "memory", "energy", "command"].map(str::to_owned).to_vec();
    terminal::table(&std::iter::once(head).chain(commands.iter().map(row)).collect::<Vec<_>>())
}
