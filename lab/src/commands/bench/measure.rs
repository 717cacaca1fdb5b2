//! Measures the tasks of a plan one after the other. If it is interrupted, it stores the results of the finished tasks.

use std::time::Instant;

use output::Options;

use crate::Failure;
use crate::bench::machine::Machine;
use crate::bench::matrix::{Plan, Task};
use crate::bench::progress::{self, Partial};
use crate::bench::results::{Growth, Results};
use crate::commands::bench::How;
use crate::interrupt::Interrupt;
use crate::{sources, terminal};

impl How {
    /// Measures `tasks` one after the other, and writes the results to the file of `--out`. If it is interrupted, the
    /// results of finished tasks are kept in a partial file. With `--resume`, these tasks are not measured again.
    ///
    /// # Errors
    /// An error of a file or a task, or an interruption.
    pub(super) fn run<'a>(&self, options: Options, tasks: impl Iterator<Item = &'a Task>) -> Result<(), Failure> {
        let interrupt = Interrupt::listen();
        // Checked first, because a measurement takes minutes and its results would be lost.
        Results::check_writable(&self.out, options)?;
        let plan = Plan {
            quick: self.quick,
            repeats: usize::from(self.repeats),
            idle: self.subtract_idle,
            reference: self.reference.clone(),
        };
        let machine = Machine::here();
        let say = |text: String| (!self.quiet).then(|| terminal::note(&text));
        measure::busy::warning(machine.load).map(say);
        let (empty, tasks): (Vec<_>, Vec<_>) = tasks.partition(|task| plan.is_empty(task));
        let mut partial = self.begin(&format!("{plan:?}, commit {}", machine.commit))?;
        if partial.done.is_empty() {
            partial.results = Results { quick: self.quick, machines: vec![machine], ..Results::default() };
            // They measure nothing, and add the reason to the results.
            for task in empty {
                plan.run(task, &mut partial.results, &interrupt)?;
            }
            if self.resume {
                say("there is no interrupted measurement to go on with, so all tasks are measured".to_owned());
            }
        } else {
            say(format!("going on after {} of {} tasks", partial.done.len(), tasks.len()));
        }
        let kept = Partial::path(&self.out);
        let (start, mut measured) = (Instant::now(), 0);
        for (index, task) in tasks.iter().enumerate() {
            let name = task.to_string();
            if partial.done.contains(&name) {
                continue;
            }
            say(progress::announcement(index + 1, tasks.len(), task, measured, start));
            // The task gets a copy, so that an interrupted task adds nothing to the stored results.
            let mut results = partial.results.clone();
            match plan.run(task, &mut results, &interrupt) {
                Err(Failure::Interrupted) if !partial.done.is_empty() && kept.is_some() => {
                    let done = format!("{} of {} tasks are kept", partial.done.len(), tasks.len());
                    return Err(Failure::Paused(format!(
                        "interrupted; {done}: the same command with --resume goes on"
                    )));
                }
                outcome => outcome?,
            }
            (partial.results, measured) = (results, measured + 1);
            partial.done.push(name);
            if let (Some(path), true) = (&kept, index + 1 < tasks.len()) {
                partial.write(path, options)?;
            }
        }
        let mut results = partial.results;
        results.complete();
        progress::spread_warning(&results).map(say);
        for Growth { parameter, engine, law, .. } in &results.growth {
            let error = law.exponent_error.map_or_else(String::new, |error| format!(" +- {error:.2}"));
            say(format!("{engine}: time grows with {parameter} to the power {:.2}{error}", law.exponent));
        }
        results.write(&self.out, options)?;
        if let Some(path) = kept {
            // The error is ignored: after a single task the file does not exist.
            let _ = std::fs::remove_file(path);
        }
        say(format!(
            "{}: {} times in {:.0} s",
            sources::output_name(&self.out),
            results.timings.len(),
            start.elapsed().as_secs_f64()
        ));
        Ok(())
    }

    /// Returns the results to continue from. With `--resume` and an existing partial file these are its results,
    /// otherwise empty results.
    ///
    /// # Errors
    /// An error if the partial file cannot be used, or if it exists and `--resume` was not given.
    fn begin(&self, request: &str) -> Result<Partial, Failure> {
        let fresh = Partial { request: request.to_owned(), ..Partial::default() };
        match Partial::path(&self.out).filter(|path| path.exists()) {
            Some(path) if self.resume => Partial::read(&path, request),
            Some(path) => {
                let path = terminal::name(&path);
                Err(format!("{path} has an interrupted measurement: --resume goes on with it, or remove the file")
                    .into())
            }
            None => Ok(fresh),
        }
    }
}
