//! Tests of the programs that measure. What needs a library that is missing is shown as ignored.

mod compare;
mod nearest;

fn main() {
    let trials = compare::trials().into_iter().chain(nearest::trials()).collect();
    test_support::run_trials(trials)
}
