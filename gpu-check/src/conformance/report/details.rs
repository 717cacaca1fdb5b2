//! The text about one probe that can be sent to the authors of a driver.

use std::fmt::Write;

use super::Run;
use crate::conformance::outcome::Outcome;
use crate::conformance::probe::{NAMES, Probe};
use crate::conformance::verdict::Verdict;

/// Largest number of cases that are shown. Cases that are wrong come first.
const SHOWN: usize = 12;

/// Returns the rule, the program, its readings, and the verdict with inputs and results.
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
