//! Writes verdicts: as a table for the terminal, and as a text for the authors of a driver.

use std::fmt::Write;

use super::outcome::Outcome;
use super::probe::{NAMES, Probe};
use super::verdict::Verdict;

/// Largest number of cases that are shown. Cases that are wrong come first.
const SHOWN: usize = 12;

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

/// Returns the text about one probe that can be sent to the authors of a driver: the rule, the program, its readings,
/// and the verdict with inputs and results.
#[must_use]
pub fn details(probe: &Probe, run: &Run, index: usize) -> String {
    let names = std::iter::once(&probe.as_written).chain(&probe.others).map(|reading| reading.name);
    let readings = names.collect::<Vec<_>>().join("; ");
    let mut text =
        format!("{}\n\n{}\n\n{}\nAllowed readings: {readings}.\n", probe.name, indented(probe.rule), probe.text());
    let outcome = &run.outcomes[index];
    let _ = write!(text, "\n{}\n{}\n", run.driver, Verdict::of(probe, outcome));
    match outcome {
        Outcome::Results(results) => text.push_str(&cases(probe, results)),
        Outcome::Refused(message) | Outcome::Ended(message) => text.push_str(&indented(message)),
        Outcome::Unwritten(_) | Outcome::NotAvailable => {}
    }
    text
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("  {line}\n")).collect::<String>().trim_end().to_owned()
}

/// Returns inputs, results and expected results: first those that are wrong, then those that are not as written, and
/// then the others.
fn cases(probe: &Probe, results: &[f64]) -> String {
    let wrong = probe.nearest(results).1;
    let rewritten = probe.as_written.wrong(&probe.cases, results);
    let mut order: Vec<usize> = (0..results.len().min(probe.cases.len())).collect();
    order.sort_by_key(|index| (!wrong.contains(index), !rewritten.contains(index)));
    let mut text = String::new();
    for &index in order.iter().take(SHOWN) {
        let case = &probe.cases[index];
        let input = |(number, name): (&f64, _)| format!("{name} = {}", probe.input.show(*number));
        let inputs: Vec<_> = case.iter().zip(NAMES).map(input).collect();
        let expected = (probe.as_written.allowed)(case).show(probe.output);
        let mark = if wrong.contains(&index) { ", WRONG" } else { "" };
        let _ = writeln!(text, "  {}", inputs.join(", "));
        let _ = writeln!(text, "    result {}, as written {expected}{mark}", probe.output.show(results[index]));
    }
    if order.len() > SHOWN {
        let _ = writeln!(text, "  and {} more cases", order.len() - SHOWN);
    }
    text
}
