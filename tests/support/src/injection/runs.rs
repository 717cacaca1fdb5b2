//! Counts the runs that a test makes, and the runs that it would make with all calls.

use std::env;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Name of the environment variable that switches every run on.
const VARIABLE: &str = "RENDER_INJECTIONS";

/// Returns the number of calls with one name to disturb: `some`, or all calls if the variable `RENDER_INJECTIONS` is
/// `all`.
///
/// # Panics
/// If `RENDER_INJECTIONS` has another value.
#[must_use]
pub fn most(some: usize) -> usize {
    match env::var_os(VARIABLE) {
        None => some,
        Some(value) => {
            assert_eq!(value, "all", "{VARIABLE} may only be \"all\"");
            usize::MAX
        }
    }
}

/// The runs of this process so far, and the number of runs if every call were disturbed.
static RUNS: [AtomicUsize; 2] = [AtomicUsize::new(0), AtomicUsize::new(0)];

/// Adds runs to those of this process.
pub(super) fn add(made: usize, all: usize) {
    RUNS[0].fetch_add(made, Ordering::Relaxed);
    RUNS[1].fetch_add(all, Ordering::Relaxed);
}

/// Runs the trials of a test, prints the number of runs that they made, and ends the process.
#[cfg(feature = "programs")]
pub fn run(trials: Vec<libtest_mimic::Trial>) -> ! {
    let conclusion = libtest_mimic::run(&libtest_mimic::Arguments::from_args(), trials);
    let [made, all] = RUNS.each_ref().map(|runs| runs.load(Ordering::Relaxed));
    println!("{made} of {all} runs; all with {VARIABLE}=all");
    conclusion.exit()
}
