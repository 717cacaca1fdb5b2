//! Measures other programs in turn, by their command lines.

use std::ffi::OsString;
use std::path::PathBuf;

use measure::statistics::Median;
use measure::turns::{order, turns_of};
use serde::{Deserialize, Serialize};
use tempfile::TempDir;

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
}

/// What the runs of a command took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timed {
    /// The name of the command.
    pub command: String,
    /// User time of every round, in seconds: the mean of its runs.
    pub seconds: Vec<f64>,
    /// Median of the user times.
    pub median: Median,
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
    /// Measures `jobs` in turn. The result of a job is a message if one of its runs fails.
    ///
    /// A command that takes less than [`SHORTEST`](measure::turns::SHORTEST) runs several times in a round.
    ///
    /// # Errors
    /// [`Failure::Interrupted`], or the system cannot start processes.
    pub fn measure(&self, jobs: &[Job], limits: &Limits) -> Result<Vec<Result<Timed, String>>, Failure> {
        let printed = TempDir::new()?;
        let [warm_up, rounds] = [self.warm_up, self.rounds].map(usize::from);
        let bar = terminal::progress((warm_up + rounds) * jobs.len(), "runs");
        let mut turns = vec![1; jobs.len()];
        let mut runs: Vec<Result<Vec<Run>, String>> = vec![Ok(Vec::new()); jobs.len()];
        let every = order(warm_up, jobs.len()).map(|index| (index, true));
        for (index, is_warm_up) in every.chain(order(rounds, jobs.len()).map(|index| (index, false))) {
            bar.inc(1);
            let Ok(done) = &mut runs[index] else { continue };
            match jobs[index].mean_run(turns[index], limits, &printed)? {
                Ok(run) if is_warm_up => turns[index] = turns_of(run.wall),
                Ok(run) => done.push(run),
                Err(message) => runs[index] = Err(message),
            }
        }
        bar.finish_and_clear();
        Ok(jobs.iter().zip(runs).map(|(job, runs)| Ok(Timed::of(job, &runs?))).collect())
    }
}

impl Job {
    /// Runs the command `turns` times, and returns the means of what it took, or a message if a run fails.
    fn mean_run(&self, turns: u32, limits: &Limits, printed: &TempDir) -> Result<Result<Run, String>, Failure> {
        let mut mean: Option<Run> = None;
        for _ in 0..turns {
            let run = supervise::run(&self.words, &self.place, printed.path(), limits)?;
            if run.end != End::Status(0) {
                let errors = std::fs::read(printed.path().join(PRINTED[1]))?;
                let said = String::from_utf8_lossy(&errors[..errors.len().min(500)]).trim_end().to_owned();
                return Ok(Err(format!("{}: {}{}{said}", self.name, run.end, if said.is_empty() { "" } else { ": " })));
            }
            let share = 1.0 / f64::from(turns);
            let before = mean.unwrap_or(Run { user: 0.0, wall: 0.0, memory: 0.0, joules: Some(0.0), ..run });
            mean = Some(Run {
                user: before.user + share * run.user,
                wall: before.wall + share * run.wall,
                memory: before.memory.max(run.memory),
                joules: before.joules.zip(run.joules).map(|(sum, joules)| sum + share * joules),
                end: run.end,
            });
        }
        Ok(mean.ok_or_else(|| format!("{}: it was not run", self.name)))
    }
}

impl Timed {
    fn of(job: &Job, runs: &[Run]) -> Self {
        let all = |figure: fn(&Run) -> f64| runs.iter().map(figure).collect::<Vec<_>>();
        let seconds = all(|run| run.user);
        let joules: Option<Vec<f64>> = runs.iter().map(|run| run.joules).collect();
        Self {
            command: job.name.clone(),
            median: Median::of(&seconds),
            seconds,
            wall: Median::of(&all(|run| run.wall)),
            memory: all(|run| run.memory).into_iter().fold(0.0, f64::max),
            joules: joules.map(|joules| Median::of(&joules)),
        }
    }
}
