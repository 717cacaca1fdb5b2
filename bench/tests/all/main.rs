//! Tests of the programs that measure. What needs a library that is missing is shown as ignored.

mod compare;
mod nearest;

use libtest_mimic::Arguments;

fn main() {
    let trials = compare::trials().into_iter().chain(nearest::trials()).collect();
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
