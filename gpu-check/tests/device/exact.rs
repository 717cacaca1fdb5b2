//! Compares the exact intersections in WGSL with those of `cpu`: for every ray the decision of each step, and the bits
//! of its lambda.
//!
//! `RENDER_EXACT_CASES` sets the number of cases of each kind.

use gpu_check::Gpu;
use gpu_check::exact::{CYLINDER, ExactKernel, MUL_ADD, ORDER, SPHERE};
use shaders::Library;

use crate::common;

/// Number of cases of each kind, unless the variable sets another one.
const CASES: usize = 20_000;
const SEED: u64 = 30;

fn count() -> usize {
    match std::env::var("RENDER_EXACT_CASES") {
        Ok(text) => text.parse().unwrap_or_else(|error| panic!("RENDER_EXACT_CASES: {error}")),
        Err(_) => CASES,
    }
}

/// Compares the kernel's results, and returns the cases.
fn compare(gpu: &Gpu, kernel: &ExactKernel) -> Vec<f64> {
    let cases = kernel.cases(count(), SEED);
    let pipeline = kernel.compile(gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}"));
    let tally = kernel.check(gpu, &pipeline, &cases).unwrap_or_else(|error| panic!("{error}"));
    println!("{tally}");
    assert_eq!(tally.differing, 0, "{tally}");
    assert!(tally.cases > count(), "{tally}");
    cases
}

/// Compares the kernel, and checks that each of the first `steps` steps decides some rays, and that some rays are left
/// for dyadic arithmetic.
fn compare_steps(kernel: &ExactKernel, steps: &[usize]) {
    let cases = compare(&common::gpu(), kernel);
    let mut decided = [0; 4];
    for case in cases.chunks(kernel.inputs) {
        decided[kernel.expected(case)[0] as usize] += 1;
    }
    let [dyadic, plain, compensated, doubled] = decided;
    println!("plain {plain}, compensated {compensated}, double-double {doubled}, left for dyadic {dyadic}");
    assert!(steps.iter().all(|&step| decided[step] > 1000), "{decided:?}");
}

#[test]
fn products_and_multiply_adds_are_rounded_once() {
    compare(&common::gpu(), &MUL_ADD);
}

#[test]
fn every_step_for_spheres_has_the_bits_of_cpu() {
    compare_steps(&SPHERE, &[0, 1, 2, 3]);
}

#[test]
fn every_step_for_two_spheres_has_the_order_of_cpu() {
    let cases = compare(&common::gpu(), &ORDER);
    let (mut plain, mut doubled) = ([0; 4], [0; 4]);
    for case in cases.chunks(ORDER.inputs) {
        let order = ORDER.expected(case);
        plain[order[0] as usize] += 1;
        doubled[order[1] as usize] += usize::from(order[0] == 0.0);
    }
    println!(
        "plain: uncertain, first, second, not two hits: {plain:?}; double-double, where that is uncertain: {doubled:?}"
    );
    assert!(plain[..3].iter().chain(&doubled[..3]).all(|&count| count > 1000), "{plain:?}, {doubled:?}");
}

#[test]
fn every_step_for_cylinders_has_the_bits_of_cpu() {
    compare_steps(&CYLINDER, &[0, 1, 2, 3]);
}
