//! Tests the checks themselves: they must notice every deliberate error in the WGSL and in the arithmetic of f64 by
//! integers, and report nothing if there is none. With `RENDER_ALL=1` all mutants are tried, as in tests/extensive.

mod crafted;
pub mod examiner;
pub mod mutant;

use gpu_check::{Error, Gpu};
use shaders::Library;
use shaders::lower::Arithmetic;
use shaders::module::MODULES;

use crate::common;
use crate::lowered::check;
use crate::lowered::operands::draw;
use crate::lowered::operations::BASIC;
use examiner::Examiner;
use mutant::{Mutant, of_arithmetic, of_modules};

/// One of this many mutants is tried, unless `RENDER_ALL` is 1: a mutant takes seconds.
const STEP: usize = 12;

/// Fails if `notice` does not notice one of the mutants that are tried, or if there are fewer than `fewest`.
fn all_are_noticed(mutants: &[Mutant], fewest: usize, notice: impl Fn(&Mutant) -> Result<Option<String>, Error>) {
    assert!(mutants.len() >= fewest, "{}", mutants.len());
    let tried: Vec<_> = mutants.iter().step_by(if test_support::everything() { 1 } else { STEP }).collect();
    let (count, mut survivors) = (tried.len(), Vec::new());
    for mutant in tried {
        match notice(mutant).unwrap_or_else(|error| panic!("{mutant:?}: {error}")) {
            Some(by) => println!("{}: [{}] => [{}] noticed by {by}", mutant.module, mutant.from, mutant.to),
            None => survivors.push(format!("{mutant:?}")),
        }
    }
    println!("{count} of {} mutants tried, {} noticed", mutants.len(), count - survivors.len());
    assert!(survivors.is_empty(), "nothing notices\n{}", survivors.join("\n"));
}

#[test]
fn every_mutant_is_noticed_and_nothing_without_a_fault() {
    let gpu = common::gpu();
    let examiner = Examiner::new(&gpu).unwrap_or_else(|error| panic!("{error}"));
    for library in [Library::standard(), Library::standard().in_hierarchy()] {
        let noticed = examiner.examine(&library, None).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(noticed, None);
    }
    all_are_noticed(&of_modules(), 260, |mutant| examiner.notice(mutant));
}

/// Returns the first operation whose results differ from Rust's with `arithmetic`, or `None` if no operation notices an
/// error.
fn notice(gpu: &Gpu, arithmetic: &Arithmetic, cases: &[f64]) -> Result<Option<String>, Error> {
    for operation in &BASIC {
        let tally = check(gpu, operation, arithmetic, cases)?;
        if tally.differing > 0 {
            return Ok(Some(format!("{}, {} of {} cases", tally.name, tally.differing, tally.cases)));
        }
    }
    Ok(None)
}

#[test]
fn every_mutant_of_the_arithmetic_is_noticed_and_nothing_without_a_fault() {
    let (gpu, mutants) = (common::gpu(), of_arithmetic());
    let cases: Vec<_> = (0..120_000).flat_map(|index| draw(31, index)).collect();
    assert_eq!(notice(&gpu, &Arithmetic::standard(), &cases).unwrap_or_else(|error| panic!("{error}")), None);
    all_are_noticed(&mutants, 30, |mutant| {
        let mut arithmetic = Arithmetic::standard();
        let changed = mutant.changed(arithmetic.source(&mutant.module).expect("the file exists"));
        arithmetic.replace(&mutant.module, changed);
        notice(&gpu, &arithmetic, &cases)
    });
    for file in Arithmetic::standard().names() {
        assert!(mutants.iter().any(|mutant| mutant.module == file), "{file} has no mutant");
    }
}

#[test]
fn every_module_with_a_formula_has_a_mutant() {
    // Kernels only pass numbers to a formula and back, and features.wgsl has only declarations.
    let formulas = MODULES.iter().filter(|module| !module.name.starts_with("kernels/") && module.name != "features");
    let mutants = of_modules();
    for module in formulas {
        assert!(mutants.iter().any(|mutant| mutant.module == module.name), "{} has none", module.name);
    }
}
