//! Measures other programs in turn, by their command lines.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use measure::statistics::Median;
use measure::turns::order;
use serde::{Deserialize, Serialize};

use super::machine::Machine;
use crate::supervise::{self, End, Limits, PRINTED, Run};
use crate::{Failure, terminal};

/// A command that is measured.
#[derive(Clone, Debug)]
pub struct Job {
    /// The name of the command in the results.
    pub name: String,
    /// The command.
    pub words: Vec<OsString>,
    /// The folder in which it runs.
    pub place: PathBuf,
    /// Folders of which it sees nothing but its own folders, where the system allows that.
    pub hidden: Vec<PathBuf>,
}

impl Job {
    /// Runs the command once. What it prints is in the files [`PRINTED`] of the folder `printed`.
    ///
    /// # Errors
    /// The errors of [`supervise::run`], and [`Failure::Program`] if its exit status is not 0: how it ended and what it
    /// said.
    pub fn run(&self, printed: &Path, limits: &Limits) -> Result<Run, Failure> {
        let run = supervise::run(&self.words, &self.place, printed, limits, &self.hidden)?;
        if run.end == End::Status(0) {
            return Ok(run);
        }
        let said = terminal::foreign(&supervise::start_of(&printed.join(PRINTED[1])));
        Err(Failure::Program(format!("{}\n{said}", run.end).trim_end().to_owned()))
    }
}

/// What the runs of a command took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timed {
    /// The name of the command.
    pub command: String,
    /// User time of every round, in seconds.
    pub seconds: Vec<f64>,
    /// Median of the user times.
    pub median: Median,
    /// Elapsed time of every round, in seconds.
    pub elapsed: Vec<f64>,
    /// Median of the elapsed times, in seconds.
    pub wall: Median,
    /// Largest resident memory of all runs, in MB (10⁶ bytes).
    pub memory: f64,
    /// Median of the energy that the machine used in one run, in joules, or `None` if there is no meter.
    pub joules: Option<Median>,
}

/// The results of `render-lab time`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The machine on which the commands were measured.
    pub machine: Machine,
    /// The commands, in the order of the command line.
    pub commands: Vec<Timed>,
}

/// How commands are measured.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Rounds {
    /// Measurements of each command
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..))]
    pub rounds: u16,
    /// Runs of each command before it is measured
    #[arg(long, value_name = "RUNS", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    pub warm_up: u16,
}

impl Rounds {
    /// Returns the number of all runs of a command.
    pub fn all(&self) -> usize {
        usize::from(self.warm_up) + usize::from(self.rounds)
    }

    /// Measures the commands `names` in turn: `run` runs the command with the index that comes second in the round that
    /// comes first. The result of a command is a message if one of its runs fails.
    ///
    /// # Errors
    /// An error of `run`, such as [`Failure::Interrupted`].
    pub fn measure(
        &self,
        names: &[String],
        mut run: impl FnMut(usize, usize) -> Result<Run, Failure>,
    ) -> Result<Vec<Result<Timed, String>>, Failure> {
        let bar = terminal::progress(self.all() * names.len(), "runs");
        let mut runs: Vec<Result<Vec<Run>, String>> = vec![Ok(Vec::new()); names.len()];
        for (number, index) in order(self.all(), names.len()).enumerate() {
            bar.inc(1);
            let Ok(done) = &mut runs[index] else { continue };
            let round = number / names.len();
            match Failure::of_program(run(round, index))? {
                Ok(run) if round >= usize::from(self.warm_up) => done.push(run),
                Ok(_) => {}
                // The message stands for the command, whose other runs are left out.
                Err(message) => runs[index] = Err(message),
            }
        }
        bar.finish_and_clear();
        Ok(names.iter().zip(runs).map(|(name, runs)| Ok(Timed::of(name, &runs?))).collect())
    }
}

impl Timed {
    fn of(name: &str, runs: &[Run]) -> Self {
        let all = |figure: fn(&Run) -> f64| runs.iter().map(figure).collect::<Vec<_>>();
        let seconds = all(|run| run.user);
        let joules: Option<Vec<f64>> = runs.iter().map(|run| run.joules).collect();
        Self {
            command: name.to_owned(),
            median: Median::of(&seconds),
            seconds,
            wall: Median::of(&all(|run| run.wall)),
            elapsed: all(|run| run.wall),
            memory: all(|run| run.memory).into_iter().fold(0.0, f64::max),
            joules: joules.map(|joules| Median::of(&joules)),
        }
    }
}
