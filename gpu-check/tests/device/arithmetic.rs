//! Tests the comparison of f64 by integers with Rust's f64: it must notice every deliberate error of the arithmetic,
//! and report nothing if there is none.

use gpu_check::lowered::mutants::{MUTANTS, cases, notice};
use shaders::lower::Arithmetic;

use crate::common;

#[test]
fn every_mutant_of_the_arithmetic_is_noticed() {
    let gpu = common::gpu();
    let cases = cases();
    let mut survivors = Vec::new();
    for mutant in MUTANTS {
        let noticed = notice(&gpu, &mutant.arithmetic(), &cases);
        match noticed.unwrap_or_else(|error| panic!("{mutant:?}: {error}")) {
            Some(by) => println!("{}: [{}] => [{}] noticed by {by}", mutant.file, mutant.from, mutant.to),
            None => survivors.push(format!("{mutant:?}")),
        }
    }
    println!("{} mutants, {} noticed", MUTANTS.len(), MUTANTS.len() - survivors.len());
    assert!(survivors.is_empty(), "nothing notices\n{}", survivors.join("\n"));
    assert!(MUTANTS.len() >= 30);
    for file in Arithmetic::standard().names() {
        assert!(MUTANTS.iter().any(|mutant| mutant.file == file), "{file} has no mutant");
    }
}

#[test]
fn nothing_is_noticed_without_an_error() {
    let gpu = common::gpu();
    let noticed = notice(&gpu, &Arithmetic::standard(), &cases()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(noticed, None);
}
