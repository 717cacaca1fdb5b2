//! Tests of results: what is joined, refused and derived. Other tests use the two functions.

use super::check::values;
use super::*;
use crate::bench::error::ErrorPoint;

pub fn timing(engine: &str, value: u64, seconds: &[f64]) -> Timing {
    let [suite, scene, parameter, engine] = ["scale", "grid", "samples", engine].map(str::to_owned);
    let setting = Setting { suite, scene, parameter, value, engine };
    Timing { setting, seconds: seconds.to_vec(), median: Median::of(seconds), digest: "d".to_owned() }
}

pub fn results(timings: Vec<Timing>) -> Results {
    Results { timings, machines: vec![Machine::here()], ..Results::default() }
}

#[test]
fn the_time_to_an_error_lies_between_measured_points() {
    let error = |samples, rmse| ErrorPoint { samples, linear: Median::of(&[rmse]), course: Median::of(&[1.0]) };
    let points = vec![error(1, 0.08), error(4, 0.04), error(16, 0.02)];
    let curve = ErrorCurve { scene: "grid".to_owned(), reference_samples: 99, reference_error: 0.0, points };
    let mut timings: Vec<_> = [1, 4, 16].map(|value| timing("a", value, &[value as f64])).to_vec();
    timings.iter_mut().for_each(|timing| timing.setting.suite = "error".to_owned());
    let mut results = Results { curves: vec![curve], ..results(timings) };
    results.complete();
    let seconds: Vec<_> = results.times_to_error.iter().map(|time| time.seconds).collect();
    // The error halves when the time grows fourfold. So the error 0.05, which is 0.08 / 1.6, takes 1.6² = 2.56 s.
    // The smallest measured error is 0.02, so the error 0.01 was not reached.
    assert!((seconds[0].expect("measured") - 2.56).abs() < 1e-9, "{seconds:?}");
    assert!((seconds[1].expect("measured") - 16.0).abs() < 1e-9, "{seconds:?}");
    assert_eq!(seconds[2], None);
}

#[test]
fn parts_are_joined_and_what_follows_is_computed() {
    let first = results(vec![timing("a", 4, &[4.0]), timing("a", 1, &[1.0])]);
    let second = results(vec![timing("a", 16, &[16.0]), timing("a", 4, &[6.0])]);
    let joined = Results::merge(vec![first, second]).expect("they fit");
    assert_eq!(joined.machines.len(), 1);
    let medians: Vec<_> = joined.timings.iter().map(|timing| (timing.setting.value, timing.median.median)).collect();
    assert_eq!(medians, [(1, 1.0), (4, 5.0), (16, 16.0)], "pooled, and in order");
    assert!((joined.growth[0].law.exponent - 1.0).abs() < 1e-12, "{:?}", joined.growth);
}

#[test]
fn what_does_not_belong_together_is_not_joined() {
    let part = || results(vec![timing("a", 1, &[1.0])]);
    let quick = Results { quick: true, ..part() };
    let mut other_picture = part();
    other_picture.timings[0].digest = "other".to_owned();
    let mut other_commit = part();
    other_commit.machines[0].commit = "other".to_owned();
    for other in [quick, other_picture, other_commit] {
        assert!(Results::merge(vec![part(), other]).is_err());
    }
}

#[test]
fn values_are_counted_in_lists_objects_and_the_file_itself() {
    for (json, expected) in [("1", 1), ("[]", 2), ("[1, 2]", 3), (r#"{"a": [1, {"b": 2}], "c": 3}"#, 6)] {
        let count = values(json.as_bytes());
        assert_eq!(count, expected, "{json}");
    }
}

#[test]
fn what_was_measured_without_a_time_is_named() {
    let mut without = timing("a", 1, &[1.0]);
    without.seconds.clear();
    let message = results(vec![without]).check().expect_err("there is no time");
    assert_eq!(message, "the list \"seconds\" of a for grid is empty; measure it again");
}
