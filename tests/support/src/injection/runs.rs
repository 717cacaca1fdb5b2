//! Counts the runs that a test makes, and the runs that it would make with all calls.

use std::env;
use std::fmt;
use std::iter::Sum;
use std::sync::{Mutex, PoisonError};

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

/// Numbers of runs of a program in which a call was disturbed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Runs {
    /// Number of runs that were made.
    pub made: usize,
    /// Number of runs that would be made if every call were disturbed.
    pub all: usize,
}

impl Sum for Runs {
    fn sum<I: Iterator<Item = Self>>(runs: I) -> Self {
        runs.fold(Self::default(), |sum, runs| Self { made: sum.made + runs.made, all: sum.all + runs.all })
    }
}

impl fmt::Display for Runs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {} runs", self.made, self.all)?;
        if self.made < self.all { write!(f, ", all with {VARIABLE}=all") } else { Ok(()) }
    }
}

/// The runs of this process so far. [`total`] returns them.
static TOTAL: Mutex<Runs> = Mutex::new(Runs { made: 0, all: 0 });

/// Adds `runs` to the total of this process.
pub(super) fn add(runs: Runs) {
    let mut total = TOTAL.lock().unwrap_or_else(PoisonError::into_inner);
    *total = [*total, runs].into_iter().sum();
}

/// Returns the runs of this process so far, for the last line of a test's output.
#[must_use]
pub fn total() -> Runs {
    *TOTAL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs the trials of a test, prints the number of runs that they made, and ends the process.
#[cfg(feature = "programs")]
pub fn run(trials: Vec<libtest_mimic::Trial>) -> ! {
    let conclusion = libtest_mimic::run(&libtest_mimic::Arguments::from_args(), trials);
    if conclusion.num_passed + conclusion.num_failed > 0 {
        println!("in all {}", total());
    }
    conclusion.exit()
}
