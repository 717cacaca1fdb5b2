//! Tests of the probes and verdicts without a driver: made-up results must get the right verdict.

mod fabricated;

use std::collections::BTreeSet;

use super::outcome::Outcome;
use super::probe::{MAX_LINES, Probe};
use super::probes;
use super::reading::{Allowed, Kind, Reading};
use super::value::{Bits, Type};
use super::verdict::{Failure, Verdict};

fn verdict(probe: &Probe, results: Vec<u64>) -> Verdict {
    Verdict::of(probe, &Outcome::Results(results))
}

/// Returns an allowed result for the case `index`. If there is a choice, the cases get all of the allowed numbers in
/// turn, or the largest number of a range.
fn unusual(allowed: &Allowed, of: Type, index: usize) -> u64 {
    match (allowed, of) {
        (Allowed::OneOf(numbers), _) => numbers[(numbers.len() - 1 + index) % numbers.len()],
        (Allowed::Between(_, high), Type::F64) => high.to_word(),
        (Allowed::Between(_, high), _) => match *high as f32 {
            above if f64::from(above) > *high => above.next_down().to_word(),
            number => number.to_word(),
        },
    }
}

/// Returns results for all cases of the probe that follow this reading.
fn following(probe: &Probe, reading: &Reading) -> Vec<u64> {
    let result = |(index, case): (usize, &Vec<u64>)| unusual(&reading.allowed(case), probe.output, index);
    probe.cases.iter().enumerate().map(result).collect()
}

#[test]
fn every_probe_is_a_short_valid_program_with_inputs_and_a_rule() {
    let probes = probes::all();
    let names: BTreeSet<_> = probes.iter().map(|probe| probe.name.as_str()).collect();
    assert_eq!(names.len(), probes.len(), "names are unique");
    assert!(probes.len() >= 50, "{}", probes.len());
    for probe in &probes {
        let (name, text) = (&probe.name, probe.text());
        assert!(text.lines().count() <= MAX_LINES, "{name}: {} lines\n{text}", text.lines().count());
        probe.composition().validate().unwrap_or_else(|error| panic!("{name}:\n{text}\n{error}"));
        assert!(probe.cases.len() >= 3 && probe.rule.len() > 10 && !probe.group.is_empty(), "{name}");
        assert!(name.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-'));
        assert_eq!(probe.readings[0].kind, Kind::AsWritten, "{name}");
        assert_eq!(probe.needs_f64(), text.contains("f64"), "{name}");
    }
}

#[test]
fn results_that_follow_a_reading_get_its_verdict_and_not_another() {
    let mut readings = 0;
    for probe in probes::all() {
        let name = &probe.name;
        assert_eq!(verdict(&probe, following(&probe, &probe.readings[0])), Verdict::AsWritten, "{name}");
        for reading in &probe.readings[1..] {
            let found = verdict(&probe, following(&probe, reading));
            // Two readings that the inputs do not tell apart would make a verdict without meaning.
            let expected = match reading.kind {
                Kind::AsWritten => panic!("{name}: only the first reading is as written"),
                Kind::Rewriting => Verdict::Rewritten(reading.name),
                Kind::Error => Verdict::WithinError(reading.name),
            };
            assert_eq!(found, expected, "{name}");
            readings += 1;
        }
    }
    assert!(readings >= 50, "{readings}");
}

#[test]
fn one_wrong_result_is_a_failure() {
    let mut tried = 0;
    for probe in probes::all() {
        let good = following(&probe, &probe.readings[0]);
        let mask = u64::MAX >> (64 - 8 * probe.output.size());
        for index in 0..probe.cases.len() {
            let mut results = good.clone();
            results[index] ^= mask;
            let found = verdict(&probe, results);
            let Verdict::Failure(Failure::Wrong { cases, .. }) = &found else {
                panic!("{}: case {index} is wrong, and the verdict is {found}", probe.name)
            };
            assert_eq!(cases, &[index], "{}", probe.name);
            tried += 1;
        }
    }
    assert!(tried > 5_000, "{tried}");
}

#[test]
fn results_as_written_and_rewritten_do_not_mix() {
    let probes = probes::all();
    let probe = probes.iter().find(|probe| probe.name == "cancel-term").expect("it exists");
    let [written, rewritten] = [0, 1].map(|index| following(probe, &probe.readings[index]));
    let half = written.len() / 2;
    let mixed = [&written[..half], &rewritten[half..]].concat();
    assert!(verdict(probe, mixed).is_failure());
}

#[test]
fn outcomes_without_results_get_their_verdicts() {
    let probes = probes::all();
    let named = |name: &str| probes.iter().find(|probe| probe.name == name).expect("it exists");
    let refused = Outcome::Refused("no such function\nat line 3".to_owned());
    assert_eq!(Verdict::of(named("sin-f64"), &refused), Verdict::Refused);
    let verdict = Verdict::of(named("sum"), &refused);
    assert!(verdict.is_failure());
    assert_eq!(verdict.to_string(), "failure: refused: no such function");
    assert!(Verdict::of(named("sum"), &Outcome::Unwritten(3)).is_failure());
    assert!(Verdict::of(named("sum"), &Outcome::Results(Vec::new())).is_failure());
    let ended = Verdict::of(named("sin-f64"), &Outcome::Ended("lost".to_owned()));
    assert!(ended.is_failure() && ended.to_string() == "failure: the driver ends");
    assert!(!Verdict::of(named("sin-f64"), &Outcome::NotAvailable).is_failure());
}
