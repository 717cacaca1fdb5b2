//! Tests the checks themselves: they must notice every deliberate error in the WGSL and in the arithmetic of f64 by
//! integers, and report nothing if there is none.

use gpu_check::Error;
use gpu_check::lowered::mutants as lowered;
use gpu_check::mutants::{self, Examiner, Mutant};
use shaders::Library;
use shaders::lower::Arithmetic;
use shaders::module::MODULES;

use crate::common;

/// Fails if `notice` does not notice one of the mutants, or if there are fewer than `fewest`.
fn all_are_noticed<'a>(
    mutants: impl Iterator<Item = &'a Mutant>,
    fewest: usize,
    notice: impl Fn(&Mutant) -> Result<Option<String>, Error>,
) {
    let (mut count, mut survivors) = (0, Vec::new());
    for mutant in mutants {
        count += 1;
        match notice(mutant).unwrap_or_else(|error| panic!("{mutant:?}: {error}")) {
            Some(by) => println!("{}: [{}] => [{}] noticed by {by}", mutant.module, mutant.from, mutant.to),
            None => survivors.push(format!("{mutant:?}")),
        }
    }
    println!("{count} mutants, {} noticed", count - survivors.len());
    assert!(survivors.is_empty(), "nothing notices\n{}", survivors.join("\n"));
    assert!(count >= fewest);
}

#[test]
fn every_mutant_is_noticed_and_nothing_without_a_fault() {
    let gpu = common::gpu();
    // The examiner follows it, so it must be right.
    common::accuracy(&gpu);
    let examiner = Examiner::new(&gpu).unwrap_or_else(|error| panic!("{error}"));
    for module in MODULES {
        let noticed = examiner.examine(&Library::standard(), module.name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(noticed, None, "{}", module.name);
    }
    all_are_noticed(mutants::all(), 260, |mutant| examiner.notice(mutant));
}

#[test]
fn every_mutant_of_the_arithmetic_is_noticed_and_nothing_without_a_fault() {
    let (gpu, cases) = (common::gpu(), lowered::cases());
    let noticed = lowered::notice(&gpu, &Arithmetic::standard(), &cases).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(noticed, None);
    let mutants = lowered::MUTANTS;
    all_are_noticed(mutants.iter(), 30, |mutant| lowered::notice(&gpu, &lowered::arithmetic(mutant), &cases));
    for file in Arithmetic::standard().names() {
        assert!(mutants.iter().any(|mutant| mutant.module == file), "{file} has no mutant");
    }
}
