//! Compares two records of times, case by case.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use measure::statistics::Median;
use serde::Serialize;
use serde_json::Value;

use super::commands::Record;
use super::machine::Machine;
use super::results::check::Total;
use super::results::{Results, Timing};
use crate::format::hint::Language;
use crate::{Failure, terminal};

/// The times of a record: the machines, and the medians by the name of their case.
#[derive(Clone, Debug)]
pub struct Times {
    machines: Vec<Machine>,
    medians: BTreeMap<String, Median>,
}

/// A case whose time has changed beyond its spread.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// The new median divided by the old one.
    pub ratio: f64,
    /// The bounds of the ratio, from the bounds of both medians.
    pub bounds: [f64; 2],
    /// The old and the new median, in seconds.
    pub seconds: [f64; 2],
    /// What was measured.
    pub case: String,
}

/// The difference of two records.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Changes {
    /// Cases that take longer now, the worst first.
    pub slower: Vec<Change>,
    /// Cases that take less time now, the best first.
    pub faster: Vec<Change>,
    /// Number of cases whose change is within the spread.
    pub unchanged: usize,
    /// Number of cases with fewer than three times in a record, so that they have no spread.
    pub unknown: usize,
    /// Number of cases that only the old record has.
    pub only_old: usize,
    /// Number of cases that only the new record has.
    pub only_new: usize,
    /// Whether the records come from different processors, so that the times say little.
    pub other_processor: bool,
}

impl Times {
    /// Reads the times in a file of `render-lab bench` or `render-lab time --json`; `-` is standard input.
    ///
    /// # Errors
    /// The file cannot be read, or is no such record.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let value = Total::default().read(path)?;
        Ok(Self::of(value).map_err(|error| format!("{}: {error}", terminal::name(path)))?)
    }

    fn of(value: Value) -> Result<Self, String> {
        let (machines, times): (_, Vec<_>) = if value.get("commands").is_some() {
            let record: Record = serde_json::from_value(value).map_err(|error| error.to_string())?;
            let times = record.commands.into_iter().map(|timed| (timed.command, timed.elapsed));
            (vec![record.machine], times.collect())
        } else {
            let results: Results = serde_json::from_value(value).map_err(|error| error.to_string())?;
            (results.machines, results.timings.into_iter().map(named).collect())
        };
        let mut medians = BTreeMap::new();
        for (case, seconds) in times {
            if seconds.is_empty() {
                return Err(format!("{case} has no times; measure it again"));
            }
            if medians.insert(case.clone(), Median::of(&seconds)).is_some() {
                return Err(format!("{case} was measured twice; measure again, and give each command another text"));
            }
        }
        Ok(Self { machines, medians })
    }
}

fn named(Timing { setting, seconds, .. }: Timing) -> (String, Vec<f64>) {
    let value = crate::report::style::setting(&setting.parameter, setting.value, Language::English);
    (format!("{} {}, {value}, {}", setting.suite, setting.scene, setting.engine), seconds)
}

impl Changes {
    /// Compares `new` with `old`. A case has changed if its ratio differs from 1 by more than `least`, and the bounds
    /// of the two medians do not meet.
    pub fn between(old: &Times, new: &Times, least: f64) -> Self {
        // Older records lack the family.
        let name = |machine: &Machine| machine.processor.split(", family ").next().unwrap_or_default().to_owned();
        let processor = |times: &Times| times.machines.iter().map(name).collect::<BTreeSet<_>>();
        let mut changes = Self { other_processor: processor(old) != processor(new), ..Self::default() };
        for (case, was) in &old.medians {
            let Some(is) = new.medians.get(case) else {
                changes.only_old += 1;
                continue;
            };
            let (ratio, bounds) = (is.median / was.median, [is.low / was.high, is.high / was.low]);
            let change = Change { ratio, bounds, seconds: [was.median, is.median], case: case.clone() };
            // The clock of user time may count nothing for a short command.
            let is_measured = |times: &Median| times.is_bounded() && times.low > 0.0;
            if !(is_measured(was) && is_measured(is)) {
                changes.unknown += 1;
            } else if bounds[0] > 1.0 && ratio > 1.0 + least {
                changes.slower.push(change);
            } else if bounds[1] < 1.0 && ratio < 1.0 / (1.0 + least) {
                changes.faster.push(change);
            } else {
                changes.unchanged += 1;
            }
        }
        changes.only_new = new.medians.keys().filter(|case| !old.medians.contains_key(*case)).count();
        changes.slower.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
        changes.faster.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
        changes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(cases: &[(&str, &[f64])]) -> Times {
        let medians = cases.iter().map(|(case, times)| ((*case).to_owned(), Median::of(times))).collect();
        Times { machines: Vec::new(), medians }
    }

    #[test]
    fn only_what_is_beyond_the_spread_has_changed() {
        let old =
            times(&[("a", &[1.0, 1.1, 1.2]), ("b", &[1.0; 3]), ("c", &[2.0; 3]), ("d", &[1.0]), ("e", &[1.0; 3])]);
        let new = times(&[("a", &[1.15, 1.3, 1.4]), ("b", &[1.01; 3]), ("c", &[1.0; 3]), ("d", &[9.0]), ("f", &[1.0])]);
        let changes = Changes::between(&old, &new, 0.02);
        assert_eq!((changes.unchanged, changes.unknown, changes.slower.len()), (2, 1, 0), "{changes:?}");
        assert_eq!((changes.only_old, changes.only_new), (1, 1));
        let [faster] = &changes.faster[..] else { panic!("{:?}", changes.faster) };
        assert_eq!((faster.ratio, faster.bounds, &*faster.case), (0.5, [0.5; 2], "c"));
        assert_eq!(Changes::between(&new, &old, 0.02).slower[0].ratio, 2.0);
    }
}
