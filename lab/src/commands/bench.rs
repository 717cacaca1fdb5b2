//! `render-lab bench`: measures, and writes the results to files.

mod diff;
mod measure;

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use output::Options;

use crate::bench::matrix::{PARAMETERS, Task, tasks};
use crate::bench::results::Results;
use crate::bench::results::check::Total;
use crate::{Failure, sources, terminal};

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
    Diff(diff::Arguments),
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
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..))]
    repeats: u16,
}

fn parse_part(text: &str) -> Result<(usize, usize), String> {
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
            What::All { part: (part, parts), how } => how.run(options, all.iter().skip(part - 1).step_by(*parts)),
            What::Tasks => {
                let names: Vec<_> = all.iter().map(ToString::to_string).collect();
                terminal::print(&names.join("\n"))
            }
            What::Merge { out, parts } => merge(out, parts, options),
            What::Diff(arguments) => arguments.run(),
        }
    }
}

fn merge(out: &Path, parts: &[PathBuf], options: Options) -> Result<(), Failure> {
    let inputs: Vec<&Path> = parts.iter().map(PathBuf::as_path).collect();
    sources::refuse_inputs_in_one(&inputs)?;
    output::refuse_inputs(out, &inputs)?;
    let (mut all, mut total) = (Results::default(), Total::default());
    for (index, path) in parts.iter().enumerate() {
        let part = Results::read_part(path, &mut total)?;
        // The limits are checked after each file, so that all files together stay within them.
        all = if index == 0 { Results::merge(vec![part])? } else { Results::merge(vec![all, part])? };
        all.check().map_err(|reason| format!("the parts together: {reason}"))?;
    }
    all.write(out, options)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_one_of_some() {
        assert_eq!(parse_part("3/10"), Ok((3, 10)));
        for text in ["", "0/3", "4/3", "1", "a/b", "1/0"] {
            assert!(parse_part(text).is_err(), "{text}");
        }
    }

    #[test]
    fn parts_have_every_task_once() {
        let all = tasks();
        for parts in [1, 3, all.len(), all.len() + 5] {
            let mut joined: Vec<_> =
                (1..=parts).flat_map(|part| all.iter().skip(part - 1).step_by(parts)).cloned().collect();
            assert_eq!(joined.len(), all.len());
            joined.retain(|task| !all.contains(task));
            assert!(joined.is_empty());
        }
    }
}
