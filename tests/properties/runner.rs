//! Runs a property on random cases. Environment variables can set the number and the seed of the cases.

use std::cell::Cell;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngSeed, TestCaseResult, TestRunner};

/// Checks `property` for `cases` random values of `strategy`. If the variable `RENDER_PROPERTY_CASES` is set, its
/// number replaces `cases`.
pub fn check<S: Strategy>(cases: u32, strategy: S, property: impl Fn(S::Value) -> TestCaseResult) {
    let cases =
        from_environment("RENDER_PROPERTY_CASES").map_or(cases, |cases| u32::try_from(cases).unwrap_or(u32::MAX));
    let seed = from_environment("RENDER_PROPERTY_SEED").unwrap_or(1);
    assert!(cases > 0, "no case would be tried");
    let config = Config {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        // The seed reproduces a failure, so old failures need no file.
        failure_persistence: None,
        max_shrink_iters: 2_000,
        ..Config::default()
    };
    let tried = Cell::new(0);
    let result = TestRunner::new(config).run(&strategy, |value| {
        tried.set(tried.get() + 1);
        property(value)
    });
    if let Err(failure) = result {
        panic!("with RENDER_PROPERTY_SEED={seed} RENDER_PROPERTY_CASES={cases}: {failure}");
    }
    assert_eq!(tried.get(), cases);
}

fn from_environment(name: &str) -> Option<u64> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name}={text} is not a number")))
}
