//! Measures the tasks of a plan one after the other.

use std::time::Instant;

use output::Options;

use crate::bench::machine::Machine;
use crate::bench::matrix::{Plan, Task};
use crate::bench::progress;
use crate::bench::results::{Growth, Results};
use crate::commands::bench::How;
use crate::{Failure, interrupt, sources, terminal};

impl How {
    /// Measures `tasks` one after the other, and writes the results to the file of `--out`.
    ///
    /// # Errors
    /// An error of a file or a task, or an interruption.
    pub(super) fn run<'a>(&self, options: Options, tasks: impl Iterator<Item = &'a Task>) -> Result<(), Failure> {
        interrupt::listen();
        // Checked first, because a measurement takes minutes and its results would be lost.
        drop(sources::open(&self.out, options)?);
        let plan = Plan { quick: self.quick, repeats: usize::from(self.repeats) };
        let machine = Machine::here();
        let say = |text: String| (!self.quiet).then(|| terminal::note(&text));
        measure::busy::warning(machine.load).map(say);
        let mut results = Results { quick: self.quick, machines: vec![machine], ..Results::default() };
        let (tasks, start): (Vec<_>, _) = (tasks.collect(), Instant::now());
        for (done, task) in tasks.iter().enumerate() {
            say(progress::announcement(done, tasks.len(), task, start));
            plan.run(task, &mut results)?;
        }
        results.complete();
        progress::spread_warning(&results).map(say);
        for Growth { parameter, engine, law, .. } in &results.growth {
            let error = law.exponent_error.map_or_else(String::new, |error| format!(" +- {error:.2}"));
            say(format!("{engine}: time grows with {parameter} to the power {:.2}{error}", law.exponent));
        }
        results.write(&self.out, options)?;
        say(format!(
            "{}: {} times in {:.0} s",
            sources::output_name(&self.out),
            results.timings.len(),
            start.elapsed().as_secs_f64()
        ));
        Ok(())
    }
}
