//! Compares the exact intersections in WGSL with those of `cpu`: for every ray the decision of each step, and the bits
//! of its lambda.
//!
//! `RENDER_EXACT_CASES` sets the number of cases of each kind.

mod formulas;
pub mod kernels;
mod rays;

use gpu_check::Gpu;
use shaders::Library;

use crate::common;
use crate::kernels::row_kernel::RowKernel;
use kernels::{CYLINDER, ExactKernel, MUL_ADD, ORDER, SPHERE, compensated_cylinders};

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
fn compare(gpu: &Gpu, (kernel, cases): &ExactKernel) -> Vec<f64> {
    let cases = cases(count(), SEED);
    let pipeline = kernel.compile(gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}"));
    let tally = kernel.check(gpu, &pipeline, &cases).unwrap_or_else(|error| panic!("{error}"));
    println!("{tally}");
    assert_eq!(tally.differing, 0, "{tally}");
    assert!(tally.cases > count(), "{tally}");
    cases
}

/// Counts the cases that each step decides: dyadic arithmetic, which only the CPU has, the plain formula, and the
/// compensated one.
fn decided(kernel: &RowKernel<f64>, cases: &[f64]) -> [usize; 3] {
    let mut decided = [0; 3];
    for case in cases.chunks(kernel.inputs) {
        decided[kernel.expected(case)[0] as usize] += 1;
    }
    let [dyadic, plain, compensated] = decided;
    println!("plain {plain}, compensated {compensated}, left for dyadic {dyadic}");
    decided
}

/// Compares the kernel, and checks that each step decides some rays, and that some rays are left for dyadic arithmetic.
fn compare_steps(kernel: &ExactKernel) {
    let decided = decided(&kernel.0, &compare(&common::gpu(), kernel));
    assert!(decided.iter().all(|&count| count > 1000), "{decided:?}");
}

#[test]
fn products_and_multiply_adds_are_rounded_once() {
    compare(&common::gpu(), &MUL_ADD);
}

#[test]
fn every_step_for_spheres_has_the_bits_of_cpu() {
    compare_steps(&SPHERE);
}

#[test]
fn every_step_for_two_spheres_has_the_order_of_cpu() {
    let cases = compare(&common::gpu(), &ORDER);
    let mut orders = [0; 4];
    for case in cases.chunks(ORDER.0.inputs) {
        orders[ORDER.0.expected(case)[0] as usize] += 1;
    }
    println!("uncertain, first, second, not two hits: {orders:?}");
    assert!(orders[..3].iter().all(|&count| count > 1000), "{orders:?}");
}

#[test]
fn every_step_for_cylinders_has_the_bits_of_cpu() {
    compare_steps(&CYLINDER);
    for (name, cases) in compensated_cylinders(count(), SEED) {
        println!("{name}:");
        let [.., compensated] = decided(&CYLINDER.0, &cases);
        assert!(compensated > count() / 10, "{name}: {compensated}");
    }
}
