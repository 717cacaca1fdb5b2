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

/// Returns a table for the terminal: the driver, a line with the verdict on each probe, and the numbers of verdicts.
#[must_use]
pub fn table(probes: &[Probe], run: &Run) -> String {
    let width = probes.iter().map(|probe| probe.name.len()).max().unwrap_or(0);
    let verdicts = run.verdicts(probes);
    let mut text = format!("{}\n", run.driver);
    let mut group = "";
    for (probe, verdict) in probes.iter().zip(&verdicts) {
        if probe.group != group {
            group = probe.group;
            let _ = writeln!(text, "\n{group}");
        }
        let _ = writeln!(text, "  {:width$}  {verdict}", probe.name);
    }
    let _ = writeln!(text, "\n{}", counts(&verdicts));
    for (probe, outcome) in probes.iter().zip(&run.outcomes) {
        if let Outcome::Ended(cause) = outcome {
            let _ = writeln!(text, "{}: {cause}", probe.name);
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
