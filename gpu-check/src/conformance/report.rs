//! Writes verdicts: as a table for the terminal, and as a text for the authors of a driver.

mod details;

use std::fmt::Write;

use super::outcome::Outcome;
use super::probe::Probe;
use super::verdict::Verdict;

pub use details::details;

/// The outcomes of all probes on one driver.
#[derive(Clone, Debug)]
pub struct Run {
    /// The adapter, the driver and the compiler of WGSL, with their versions.
    pub driver: String,
    /// The outcome of each probe, in the order of the probes.
    pub outcomes: Vec<Outcome>,
}

impl Run {
    /// Returns the verdict on each probe.
    #[must_use]
    pub fn verdicts(&self, probes: &[Probe]) -> Vec<Verdict> {
        probes.iter().zip(&self.outcomes).map(|(probe, outcome)| Verdict::of(probe, outcome)).collect()
    }
}

/// Returns a table for the terminal: the drivers, a line for each probe with a verdict for each driver, and the numbers
/// of verdicts.
#[must_use]
pub fn table(probes: &[Probe], runs: &[Run]) -> String {
    let names = probes.iter().map(|probe| probe.name.clone()).collect();
    let verdicts = |run: &Run| run.verdicts(probes).iter().map(Verdict::to_string).collect();
    let columns: Vec<Vec<String>> = std::iter::once(names).chain(runs.iter().map(verdicts)).collect();
    let width = |column: &Vec<String>| column.iter().map(|cell| cell.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = columns.iter().map(width).collect();
    let mut text = String::new();
    for (number, run) in runs.iter().enumerate() {
        let _ = writeln!(text, "driver {}: {}", number + 1, run.driver);
    }
    let mut group = "";
    for (row, probe) in probes.iter().enumerate() {
        if probe.group != group {
            group = probe.group;
            let _ = writeln!(text, "\n{group}");
        }
        let cell = |(column, width): (&Vec<String>, &usize)| format!("{:width$}", column[row]);
        let cells: Vec<_> = columns.iter().zip(&widths).map(cell).collect();
        let _ = writeln!(text, "  {}", cells.join("  ").trim_end());
    }
    text.push('\n');
    for (number, run) in runs.iter().enumerate() {
        let _ = writeln!(text, "driver {}: {}", number + 1, counts(&run.verdicts(probes)));
        for (probe, outcome) in probes.iter().zip(&run.outcomes) {
            if let Outcome::Ended(cause) = outcome {
                let _ = writeln!(text, "driver {}, {}: {cause}", number + 1, probe.name);
            }
        }
    }
    text
}

/// Returns the number of verdicts of each class.
fn counts(verdicts: &[Verdict]) -> String {
    let classes = ["as written", "rewritten", "within error", "refused", "not available", "failure"];
    let count = |class: &str| verdicts.iter().filter(|verdict| verdict.class() == class).count();
    let parts: Vec<_> = classes.iter().map(|class| format!("{} {class}", count(class))).collect();
    format!("{} probes: {}", verdicts.len(), parts.join(", "))
}

/// Returns the list of probes: name, program and rule of each.
#[must_use]
pub fn list(probes: &[Probe]) -> String {
    let width = probes.iter().map(|probe| probe.name.len()).max().unwrap_or(0);
    let line = |probe: &Probe| format!("{:width$}  {}\n{:width$}  {}\n", probe.name, probe.result, "", probe.rule);
    probes.iter().map(line).collect()
}
