//! Measures other programs in turn, by their command lines.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use measure::statistics::Median;
use measure::turns::order;
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

impl Job {
    /// Runs the command once. What it prints is in the files [`PRINTED`] of the folder `printed`.
    ///
    /// # Errors
    /// The errors of [`supervise::run`], or how the command ended and what it said, unless its exit status is 0.
    pub fn run(&self, printed: &Path, limits: &Limits) -> Result<Run, Failure> {
        let run = supervise::run(&self.words, &self.place, printed, limits)?;
        if run.end == End::Status(0) {
            return Ok(run);
        }
        let said = supervise::start_of(&printed.join(PRINTED[1]));
        Err(format!("{}\n{}", run.end, String::from_utf8_lossy(&said)).trim_end().into())
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
    /// Measures `jobs` in turn. The result of a job is a message if one of its runs fails.
    ///
    /// # Errors
    /// [`Failure::Interrupted`], or the first run that fails, if `all` must succeed.
    pub fn measure(&self, jobs: &[Job], limits: &Limits, all: bool) -> Result<Vec<Result<Timed, String>>, Failure> {
        self.measure_prepared(jobs, &[], limits, all)
    }

    /// Measures `jobs` as [`Rounds::measure`] does. Before each run of a job, runs the job of `prepare` at the same place
    /// without measuring it, if `prepare` is not empty.
    ///
    /// # Errors
    /// Those of [`Rounds::measure`], and the first preparation that fails.
    pub fn measure_prepared(
        &self,
        jobs: &[Job],
        prepare: &[Job],
        limits: &Limits,
        all: bool,
    ) -> Result<Vec<Result<Timed, String>>, Failure> {
        let printed = TempDir::new()?;
        let warm_up = usize::from(self.warm_up) * jobs.len();
        let rounds = usize::from(self.warm_up) + usize::from(self.rounds);
        let bar = terminal::progress(rounds * jobs.len(), "runs");
        let mut runs: Vec<Result<Vec<Run>, String>> = vec![Ok(Vec::new()); jobs.len()];
        for (number, index) in order(rounds, jobs.len()).enumerate() {
            bar.inc(1);
            let (job, Ok(done)) = (&jobs[index], &mut runs[index]) else { continue };
            if let Some(prepare) = prepare.get(index) {
                prepare.run(printed.path(), limits).map_err(|failure| failure.about(&prepare.name))?;
            }
            match job.run(printed.path(), limits) {
                Ok(run) if number >= warm_up => done.push(run),
                Ok(_) => {}
                Err(Failure::Interrupted) => return Err(Failure::Interrupted),
                Err(failure) if all => return Err(failure.about(&job.name)),
                // The message stands for the job, whose other runs are left out.
                Err(failure) => runs[index] = Err(failure.about(&job.name).message().unwrap_or_default()),
            }
        }
        bar.finish_and_clear();
        Ok(jobs.iter().zip(runs).map(|(job, runs)| Ok(Timed::of(job, &runs?))).collect())
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
            elapsed: all(|run| run.wall),
            memory: all(|run| run.memory).into_iter().fold(0.0, f64::max),
            joules: joules.map(|joules| Median::of(&joules)),
        }
    }
}
