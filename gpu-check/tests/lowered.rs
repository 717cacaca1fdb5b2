//! Compares f64 by integers with Rust's f64: every operation, every formula, and whole pictures.
//!
//! The variable `LOWERED_CASES` sets the number of cases of each operation.

mod common;

use gpu_check::lowered::{check, operations};

/// Number of cases of each operation, unless `LOWERED_CASES` sets another.
const CASES: usize = 1_000_000;

/// Returns the number of cases of each operation.
fn cases() -> usize {
    match std::env::var("LOWERED_CASES") {
        Ok(text) => text.parse().expect("LOWERED_CASES is a number"),
        Err(_) => CASES,
    }
}

#[test]
fn every_operation_gives_the_bits_of_rust() {
    let gpu = common::gpu();
    let count = cases();
    let mut faults = Vec::new();
    for operation in operations::all() {
        let tally = check(&gpu, operation, count, 30).unwrap_or_else(|error| panic!("{}: {error}", operation.wgsl));
        println!("{tally}");
        assert_eq!(tally.cases, count);
        assert!(tally.ordinary > count / 10, "too few ordinary results: {tally}");
        if tally.differing > 0 {
            faults.push(tally.to_string());
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
