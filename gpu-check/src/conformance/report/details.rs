//! The text about one probe that can be sent to the authors of a driver.

use std::fmt::Write;

use super::Run;
use crate::conformance::outcome::Outcome;
use crate::conformance::probe::{NAMES, Probe};
use crate::conformance::verdict::{Failure, Verdict};

/// Largest number of cases that are shown. Cases that are wrong come first.
const SHOWN: usize = 12;

/// Returns the rule, the program, its readings, and for each driver the verdict with inputs and results.
#[must_use]
pub fn details(probe: &Probe, runs: &[Run], index: usize) -> String {
    let readings = probe.readings.iter().map(|reading| reading.name).collect::<Vec<_>>().join("; ");
    let mut text =
        format!("{}\n\n{}\n\n{}\nAllowed readings: {readings}.\n", probe.name, indented(probe.rule), probe.text());
    for run in runs {
        let outcome = &run.outcomes[index];
        let verdict = Verdict::of(probe, outcome);
        let _ = write!(text, "\n{}\n{verdict}\n", run.driver);
        match outcome {
            Outcome::Results(results) => text.push_str(&cases(probe, results, &verdict)),
            Outcome::Refused(message) | Outcome::Ended(message) => text.push_str(&indented(message)),
            Outcome::Unwritten(_) | Outcome::NotAvailable => {}
        }
    }
    text
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("  {line}\n")).collect::<String>().trim_end().to_owned()
}

/// Returns inputs, results and expected results: first those that are wrong, then those that are not as written, and
/// then the others.
fn cases(probe: &Probe, results: &[u64], verdict: &Verdict) -> String {
    let wrong = match verdict {
        Verdict::Failure(Failure::Wrong { cases, .. }) => &cases[..],
        _ => &[],
    };
    let as_written = |index: usize| {
        let allowed = probe.readings[0].allowed(&probe.cases[index]);
        allowed.contains(probe.output, results[index])
    };
    let mut order: Vec<usize> = (0..results.len().min(probe.cases.len())).collect();
    order.sort_by_key(|&index| (!wrong.contains(&index), as_written(index)));
    let mut text = String::new();
    for &index in order.iter().take(SHOWN) {
        let case = &probe.cases[index];
        let inputs: Vec<_> =
            case.iter().zip(NAMES).map(|(bits, name)| format!("{name} = {}", probe.input.show(*bits))).collect();
        let expected = probe.readings[0].allowed(case).show(probe.output);
        let mark = if wrong.contains(&index) { ", WRONG" } else { "" };
        let _ = writeln!(text, "  {}", inputs.join(", "));
        let _ = writeln!(text, "    result {}, as written {expected}{mark}", probe.output.show(results[index]));
    }
    if order.len() > SHOWN {
        let _ = writeln!(text, "  and {} more cases", order.len() - SHOWN);
    }
    text
}
