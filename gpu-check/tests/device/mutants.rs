//! Tests the checks themselves: they must notice every deliberate error in the WGSL, and report nothing if there is
//! none.

use gpu_check::mutants::{self, Examiner};
use shaders::Library;
use shaders::module::MODULES;

use crate::common;

#[test]
fn every_mutant_is_noticed() {
    let gpu = common::gpu();
    // The examiner follows it, so it must be right.
    common::accuracy(&gpu);
    let examiner = Examiner::new(&gpu).unwrap_or_else(|error| panic!("{error}"));
    let (mut count, mut survivors) = (0, Vec::new());
    for mutant in mutants::all() {
        count += 1;
        match examiner.notice(mutant).unwrap_or_else(|error| panic!("{mutant:?}: {error}")) {
            Some(by) => println!("{}: [{}] => [{}] noticed by {by}", mutant.module, mutant.from, mutant.to),
            None => survivors.push(format!("{mutant:?}")),
        }
    }
    println!("{count} mutants, {} noticed", count - survivors.len());
    assert!(survivors.is_empty(), "nothing notices\n{}", survivors.join("\n"));
    assert!(count >= 25);
}

#[test]
fn nothing_is_noticed_without_a_fault() {
    let gpu = common::gpu();
    // The examiner follows it, so it must be right.
    common::accuracy(&gpu);
    let examiner = Examiner::new(&gpu).unwrap_or_else(|error| panic!("{error}"));
    for module in MODULES {
        let noticed = examiner.examine(&Library::standard(), module.name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(noticed, None, "{}", module.name);
    }
}
