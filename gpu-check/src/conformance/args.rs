//! The command line of `conformance`.

use std::path::PathBuf;

use clap::Parser;

use super::probes;

/// Holds drivers to IEEE 754 and WGSL: runs small programs, and compares their results with what is allowed.
#[derive(Debug, Parser)]
#[command(
    name = "conformance",
    max_term_width = 120,
    after_help = "\
Examples:
  conformance                            the table for lavapipe
  conformance --probe loop-limit         one program with its inputs and results, for a report to its authors
  WGPU_ADAPTER_NAME=nvidia conformance --csv docs/gpu/probes.csv

A verdict is one of these: as written; rewritten, with the name of an allowed rewriting; within error, with the name of
the allowed error; refused, where a program may be refused; not available, if the adapter lacks f64; or failure.

Exit status: 0 no driver fails a probe
             1 a driver fails a probe
             2 an error, such as a missing driver
             130 interrupted"
)]
pub struct Arguments {
    /// Print the name, program and rule of each probe, and run nothing
    #[arg(long, conflicts_with_all = ["probe", "csv"])]
    pub list: bool,
    /// Run this probe alone, and print its program, inputs and results; may be repeated
    #[arg(long, value_name = "NAME", value_parser = known, conflicts_with = "csv")]
    pub probe: Vec<String>,
    /// Write the verdicts into this file too, as CSV; columns of other drivers that it has already stay
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Let drivers rewrite the arithmetic, which they otherwise do as it is written
    #[arg(long)]
    pub as_driver_likes: bool,
}

/// Returns the name of a probe, or a message with the most similar name if there is no such probe.
fn known(name: &str) -> Result<String, String> {
    let names = || probes::all().into_iter().map(|probe| probe.name);
    if names().any(|known| known == name) {
        return Ok(name.to_owned());
    }
    let likeness = |known: &String| strsim::jaro_winkler(known, name);
    let nearest = names().max_by(|one, other| likeness(one).total_cmp(&likeness(other))).unwrap_or_default();
    Err(format!("there is no probe [{name}]; did you mean [{nearest}]?; --list shows all"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_probe_is_named_with_the_nearest_one() {
        assert_eq!(known("sum-f64"), Ok("sum-f64".to_owned()));
        let message = "there is no probe [cancel-tern]; did you mean [cancel-term]?; --list shows all";
        assert_eq!(known("cancel-tern"), Err(message.to_owned()));
    }
}
