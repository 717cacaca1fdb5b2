//! Writes verdicts: as a table for the terminal, and as a text for the authors of a driver.

mod details;

use std::fmt::Write;

use super::outcome::Outcome;
use super::probe::Probe;
use super::verdict::Verdict;

pub use details::details;

/// A driver, as reports name it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Driver {
    /// The name of the adapter.
    pub adapter: String,
    /// The name of the driver, with its version.
    pub driver: String,
    /// The program that compiles WGSL, with its version.
    pub compiler: String,
}

/// The outcomes of all probes on one driver.
#[derive(Clone, Debug)]
pub struct Run {
    /// The driver.
    pub driver: Driver,
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

impl std::fmt::Display for Driver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}; {}; {}", self.adapter, self.driver, self.compiler)
    }
}

/// Returns a table for the terminal: the drivers, a line for each probe with a verdict for each driver, and the numbers
/// of verdicts.
#[must_use]
pub fn table(probes: &[Probe], runs: &[Run]) -> String {
    let rows: Vec<Vec<String>> = rows(probes, runs);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..=runs.len()).map(width).collect();
    let mut text = String::new();
    for (number, run) in runs.iter().enumerate() {
        let _ = writeln!(text, "driver {}: {}", number + 1, run.driver);
    }
    let mut group = "";
    for (probe, row) in probes.iter().zip(&rows) {
        if probe.group != group {
            group = probe.group;
            let _ = writeln!(text, "\n{group}");
        }
        let cells: Vec<_> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}")).collect();
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

/// Returns the name of each probe with its verdicts.
fn rows(probes: &[Probe], runs: &[Run]) -> Vec<Vec<String>> {
    let verdicts: Vec<_> = runs.iter().map(|run| run.verdicts(probes)).collect();
    let row = |(index, probe): (usize, &Probe)| {
        let cells = verdicts.iter().map(|verdicts| verdicts[index].to_string());
        std::iter::once(probe.name.clone()).chain(cells).collect()
    };
    probes.iter().enumerate().map(row).collect()
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
