//! Tests of the probes and verdicts without a driver: made-up results must get the right verdict.

use std::collections::BTreeSet;

use super::outcome::Outcome;
use super::probe::{MAX_LINES, Probe};
use super::probes;
use super::reading::{Allowed, Kind, Reading};
use super::value::{Type, Value};
use super::verdict::Verdict;

fn verdict(probe: &Probe, results: Vec<f64>) -> Verdict {
    Verdict::of(probe, &Outcome::Results(results))
}

fn named(name: &str) -> Probe {
    probes::all().into_iter().find(|probe| probe.name == name).expect("there is a probe of this name")
}

/// Returns results for all cases of the probe that follow this reading. If there is a choice, the cases get all of the
/// allowed numbers in turn, or the largest number of a range.
fn following(probe: &Probe, reading: &Reading) -> Vec<f64> {
    let result = |(index, case): (usize, &Vec<f64>)| match ((reading.allowed)(case), probe.output) {
        (Allowed::OneOf(numbers), _) => numbers[(numbers.len() - 1 + index) % numbers.len()],
        (Allowed::Between(_, high), Type::F32) => match high as f32 {
            above if f64::from(above) > high => above.next_down().into(),
            number => number.into(),
        },
        (Allowed::Between(_, high), _) => high,
    };
    probe.cases.iter().enumerate().map(result).collect()
}

#[test]
fn every_probe_is_a_short_valid_program_with_inputs_and_a_rule() {
    let probes = probes::all();
    let names: BTreeSet<_> = probes.iter().map(|probe| probe.name.as_str()).collect();
    assert!(names.len() == probes.len() && probes.len() >= 50, "{} names, {} probes", names.len(), probes.len());
    for probe in &probes {
        let (name, text) = (&probe.name, probe.text());
        assert!(text.lines().count() <= MAX_LINES, "{name}: {} lines\n{text}", text.lines().count());
        probe.composition().validate().unwrap_or_else(|error| panic!("{name}:\n{text}\n{error}"));
        assert!(probe.cases.len() >= 3 && probe.rule.len() > 10 && !probe.group.is_empty(), "{name}");
        assert!(name.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-'));
        assert_eq!(probe.needs_f64(), text.contains("f64"), "{name}");
    }
}

#[test]
fn results_that_follow_a_reading_get_its_verdict_and_not_another() {
    for probe in probes::all() {
        let name = &probe.name;
        assert_eq!(verdict(&probe, following(&probe, &probe.as_written)), Verdict::AsWritten, "{name}");
        for reading in &probe.others {
            // Two readings that the inputs do not tell apart would make a verdict without meaning.
            let expected = match reading.kind {
                Kind::AsWritten => panic!("{name}: only the first reading is as written"),
                Kind::Rewriting => Verdict::Rewritten(reading.name),
                Kind::Error => Verdict::WithinError(reading.name),
            };
            assert_eq!(verdict(&probe, following(&probe, reading)), expected, "{name}");
        }
    }
}

#[test]
fn one_wrong_result_is_a_failure() {
    for probe in probes::all() {
        let good = following(&probe, &probe.as_written);
        for index in 0..good.len() {
            let mut results = good.clone();
            results[index] = if good[index].is_nan() { 1.5 } else { -good[index] - 1.5 };
            let expected = Verdict::Failure(format!("1 of {} wrong", good.len()));
            assert_eq!(verdict(&probe, results), expected, "{}: case {index}", probe.name);
        }
    }
}

#[test]
fn results_as_written_and_rewritten_do_not_mix() {
    let probe = named("cancel-term");
    let [written, rewritten] = [&probe.as_written, &probe.others[0]].map(|reading| following(&probe, reading));
    let half = written.len() / 2;
    assert!(verdict(&probe, [&written[..half], &rewritten[half..]].concat()).is_failure());
}

#[test]
fn outcomes_without_results_get_their_verdicts() {
    let [sum, sin] = ["sum", "sin-f64"].map(named);
    let refused = Outcome::Refused("no such function\nat line 3".to_owned());
    assert_eq!(Verdict::of(&sin, &refused), Verdict::Refused);
    let shown = |probe, outcome| Verdict::of(probe, &outcome).to_string();
    assert_eq!(shown(&sum, refused), "failure: refused: no such function");
    assert_eq!(shown(&sum, Outcome::Unwritten(3)), "failure: 3 not written");
    assert_eq!(shown(&sum, Outcome::Results(vec![0.5])), "failure: 1 results");
    assert_eq!(shown(&sin, Outcome::Ended("lost".to_owned())), "failure: the driver ends");
    assert_eq!(shown(&sin, Outcome::NotAvailable), "not available (f64)");
}

/// Checks that the results of a wrong formula are a failure: they are neither as written nor an allowed rewriting.
#[track_caller]
fn fails<I: Value, O: Value, const N: usize>(name: &str, wrong: impl Fn([I; N]) -> O) {
    let probe = named(name);
    assert_eq!((probe.input, probe.output, probe.cases[0].len()), (I::TYPE, O::TYPE, N), "{name}");
    let result = |case: &Vec<f64>| wrong(std::array::from_fn(|index| I::of_f64(case[index]))).to_f64();
    let verdict = verdict(&probe, probe.cases.iter().map(result).collect());
    assert!(verdict.is_failure(), "{name}: {verdict}");
}

#[test]
fn results_of_wrong_formulas_are_failures() {
    // A test that only compares with the formula as written would take the first formula for a rewriting.
    fails("cancel-term", |[a, b]: [f32; 2]| (a + b) + a);
    fails("error-of-sum-f64", |[a, b]: [f64; 2]| -(a - ((a + b) - b)));
    fails("contract", |[a, b, c]: [f32; 3]| a * b - c);
    fails("factor-out-f64", |[a, b, c]: [f64; 3]| b * (a + c));
    fails("multiply-by-zero", |[a]: [f32; 1]| a);
    fails("add-zero", |[a]: [f32; 1]| -a);
    fails("negate-difference", |[a, b]: [f32; 2]| a - b);
    fails("sum", |[a, b]: [f32; 2]| (a + b).next_up().next_up());
    fails("divide", |[a, b]: [f32; 2]| f32::from_bits((a / b).to_bits() + 4));
    fails("root", |[a]: [f32; 1]| f32::from_bits(a.sqrt().to_bits() + 12));
    fails("root-f64", |[a]: [f64; 1]| f64::from((a as f32).sqrt()));
    fails("sin-f64", |[a]: [f64; 1]| f64::from((a as f32).sin()));
    fails("f64-to-f32", |[a]: [f64; 1]| (a as f32).next_up().next_up());
    fails("compare-nan", |[_, _]: [f32; 2]| 64_u32);
    fails("select", |[a, b, c]: [f32; 3]| a + f32::from(u8::from(c < 0.0)) * (b - a));
    fails("subnormal-copy", |[a]: [f32; 1]| if a.is_subnormal() { 0.0 } else { a });
    fails("subnormal-sum", |[a, b]: [f32; 2]| a - b);
    fails("shift-left", |[a, b]: [u32; 2]| a.checked_shl(b).unwrap_or(0));
    fails("loop-limit", |[a]: [u32; 1]| (0..a.min(65_535)).fold(1_u32, |sum, i| (sum ^ i).wrapping_mul(0x0100_0193)));
}
