//! `render-lab bench`: measures, and writes the results to files.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::{Args, Subcommand};
use output::Options;

use crate::bench::diff::{Change, Changes, Times};
use crate::bench::machine::Machine;
use crate::bench::matrix::{PARAMETERS, Plan, Task, tasks};
use crate::bench::mechanisms;
use crate::bench::results::check::Total;
use crate::bench::results::{Growth, Results};
use crate::numbers::above_zero;
use crate::report::style::{seconds, short};
use crate::{Failure, interrupt, sources, terminal};

/// Options of `bench`.
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(subcommand)]
    what: What,
}

/// What is measured.
#[derive(Debug, Subcommand)]
enum What {
    /// Time against width, samples, depth, number of objects, and their number in one view
    #[command(after_help = "Examples:\n  render-lab bench scale --out scale.json\n  \
                            render-lab bench scale objects --quick --out objects.json")]
    Scale {
        /// One parameter; all without it
        #[arg(value_parser = clap::builder::PossibleValuesParser::new(PARAMETERS))]
        parameter: Option<String>,
        #[command(flatten)]
        how: How,
    },
    /// Run time against error of a picture for every implementation
    #[command(after_help = "Examples:\n  render-lab bench error --repeats 9 --out error.json")]
    Error {
        #[command(flatten)]
        how: How,
    },
    /// What mechanisms of the renderer gain on many scenes, as a table in Markdown
    #[command(after_help = "Examples:\n  render-lab bench mechanisms >mechanisms.md")]
    Mechanisms {
        /// Repeats of each time
        #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..))]
        repeats: u16,
        /// Small pictures, to try it out in minutes
        #[arg(long)]
        quick: bool,
    },
    /// All of it
    #[command(after_help = "Examples:\n  render-lab bench all --out docs/report/data/bench.json\n  \
                            render-lab bench all --quick --part 3/10 --out part-3.json")]
    All {
        /// The I-th of N shares of the tasks, for a cluster; join them with merge
        #[arg(long, value_name = "I/N", value_parser = parse_part, default_value = "1/1")]
        part: (usize, usize),
        #[command(flatten)]
        how: How,
    },
    /// List the tasks of the matrix, one a line: as many parts as make sense
    #[command(after_help = "Examples:\n  render-lab bench tasks | wc -l")]
    Tasks,
    /// Join the results of parts
    #[command(after_help = "Examples:\n  render-lab bench merge --out bench.json part-*.json")]
    Merge {
        /// File to write
        #[arg(long, value_name = "OUT.json")]
        out: PathBuf,
        /// Results to join, all of one commit
        #[arg(required = true)]
        parts: Vec<PathBuf>,
    },
    /// Say what became faster or slower between two records
    #[command(after_help = include_str!("../../help/bench-diff.txt").trim_ascii_end())]
    Diff {
        /// The older record
        old: PathBuf,
        /// The newer record
        new: PathBuf,
        /// Smaller changes, in percent, do not count
        #[arg(long, value_name = "PERCENT", default_value_t = 2.0, value_parser = above_zero)]
        least: f64,
        /// Print the changes as JSON
        #[arg(long)]
        json: bool,
    },
}

/// How it is measured, and where to.
#[derive(Debug, Args)]
struct How {
    /// File to write; - is standard output
    #[arg(long, value_name = "OUT.json")]
    out: PathBuf,
    /// Small pictures, to try it out in minutes
    #[arg(long)]
    quick: bool,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
    /// Repeats of each time
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..))]
    repeats: u16,
}

/// Returns the two numbers of a part, such as 3/10.
///
/// # Errors
/// What is needed instead.
pub fn parse_part(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(part, parts)| Some((part.parse().ok()?, parts.parse().ok()?)));
    numbers.filter(|&(part, parts)| part >= 1 && part <= parts).ok_or_else(|| "I/N is needed, as in 3/10".to_owned())
}

impl Arguments {
    /// Measures, lists tasks, or joins results, as the command line asks.
    ///
    /// # Errors
    /// An error of a file or a task, or [`Failure::Interrupted`].
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let all = tasks();
        match &self.what {
            What::Scale { parameter, how } => {
                let is_wanted = |name: &str| parameter.as_ref().is_none_or(|parameter| parameter == name);
                how.run(options, all.iter().filter(|task| matches!(task, Task::Scale(name) if is_wanted(name))))
            }
            What::Error { how } => how.run(options, all.iter().filter(|task| matches!(task, Task::Error(_)))),
            What::Mechanisms { repeats, quick } => {
                terminal::print(mechanisms::table(usize::from(*repeats), *quick)?.trim_end())
            }
            What::All { part: (part, parts), how } => how.run(options, all.iter().skip(part - 1).step_by(*parts)),
            What::Tasks => {
                let names: Vec<_> = all.iter().map(ToString::to_string).collect();
                terminal::print(&names.join("\n"))
            }
            What::Merge { out, parts } => merge(out, parts, options),
            What::Diff { old, new, least, json } => diff([old, new], least / 100.0, *json),
        }
    }
}

impl How {
    /// Measures `tasks` one after the other, and writes the results to the file of `--out`.
    ///
    /// # Errors
    /// An error of a file or a task, or an interruption.
    fn run<'a>(&self, options: Options, tasks: impl Iterator<Item = &'a Task>) -> Result<(), Failure> {
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
            say(announcement(done, tasks.len(), task, start));
            plan.run(task, &mut results)?;
        }
        results.complete();
        spread_warning(&results).map(say);
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

/// Returns the message that announces the next of `of` tasks after the first `done`, with an estimate of the time left.
/// The estimate gives each remaining task the mean time of the tasks since `since`. The times of tasks differ, so it is
/// rough.
fn announcement(done: usize, of: usize, task: &Task, since: Instant) -> String {
    let left = match done {
        0 => String::new(),
        _ => format!(", about {} left", rough(since.elapsed().div_f64(done as f64).mul_f64((of - done) as f64))),
    };
    format!("task {} of {of}: {task}{left}", done + 1)
}

fn rough(time: Duration) -> String {
    match time.as_secs() {
        seconds @ 0..=99 => format!("{seconds} s"),
        seconds @ 100..=5999 => format!("{} min", seconds.div_ceil(60)),
        seconds => format!("{:.1} h", seconds as f64 / 3600.0),
    }
}

/// Returns a warning if the repeats of some settings differ much from each other, and otherwise `None`.
fn spread_warning(results: &Results) -> Option<String> {
    /// The largest spread without a warning. The spread is the distance between the bounds, divided by the median.
    const MOST_SPREAD: f64 = 0.1;
    let of = results.timings.len();
    let wide = results.timings.iter().filter(|timing| timing.median.spread() > MOST_SPREAD).count();
    (wide > 0).then(|| {
        format!(
            "warning: in {wide} of {of} settings the bounds of the median are more than {:.0} % of it apart: the machine was \
             busy or its clock changed. More --repeats on a quiet machine narrow them.",
            100.0 * MOST_SPREAD
        )
    })
}

fn merge(out: &Path, parts: &[PathBuf], options: Options) -> Result<(), Failure> {
    let inputs: Vec<&Path> = parts.iter().map(PathBuf::as_path).collect();
    sources::refuse_inputs_in_one(&inputs)?;
    output::refuse_inputs(out, &inputs)?;
    let (mut all, mut total) = (None, Total::default());
    for path in parts {
        let part = Results::read_part(path, &mut total)?;
        // The limits are checked after each file, so that all files together stay within them.
        let joined = Results::merge(all.into_iter().chain([part]))?;
        joined.check().map_err(|reason| format!("the parts together: {reason}"))?;
        all = Some(joined);
    }
    all.ok_or("there is nothing to join")?.write(out, options)
}

/// Compares two records and prints the changes of more than `least`.
///
/// # Errors
/// [`Failure::Rejected`] if a case became slower, or an error of a file.
fn diff([old, new]: [&PathBuf; 2], least: f64, json: bool) -> Result<(), Failure> {
    sources::refuse_inputs_in_one(&[old, new])?;
    let changes = Changes::between(&Times::read(old)?, &Times::read(new)?, least);
    if changes.slower.len() + changes.faster.len() + changes.unchanged + changes.unknown == 0 {
        return Err("the two records have no case in common".into());
    }
    if changes.other_processor {
        terminal::note("warning: the records come from different processors, so their times say little");
    }
    super::print_as(json, &[], &changes, || text(&changes))?;
    if changes.slower.is_empty() { Ok(()) } else { Err(Failure::Rejected) }
}

fn text(changes: &Changes) -> String {
    let row = |word: &str, change: &Change| {
        let [low, high] = change.bounds.map(short);
        let [old, new] = change.seconds.map(seconds);
        let ratio = format!("{} ({low} to {high})", short(change.ratio));
        vec![word.to_owned(), ratio, old, new, terminal::escape_lines(&change.case)]
    };
    let slower = changes.slower.iter().map(|change| row("slower", change));
    let faster = changes.faster.iter().map(|change| row("faster", change));
    let head = ["change", "ratio", "old", "new", "case"].map(str::to_owned).to_vec();
    let rows: Vec<_> = std::iter::once(head).chain(slower).chain(faster).collect();
    let table = if rows.len() > 1 { terminal::table(&rows) + "\n\n" } else { String::new() };
    let Changes { unchanged, unknown, only_old, only_new, .. } = changes;
    format!(
        "{table}{} slower, {} faster, {unchanged} within their spread; {unknown} measured too few times, {only_old} \
         only in the old record, {only_new} only in the new one",
        changes.slower.len(),
        changes.faster.len(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_task_is_announced_with_its_number_and_the_time_left() {
        let now = Instant::now();
        assert_eq!(announcement(0, 21, &Task::Scale("width"), now), "task 1 of 21: scale width");
        let earlier = now.checked_sub(Duration::from_secs(20)).expect("the clock has run that long");
        let text = announcement(2, 4, &Task::Error("x"), earlier);
        assert!(text.starts_with("task 3 of 4: error x, about 20 s left"), "{text}");
        assert_eq!([5, 100, 6000].map(|seconds| rough(Duration::from_secs(seconds))), ["5 s", "2 min", "1.7 h"]);
    }
}
