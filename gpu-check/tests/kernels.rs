//! Every formula in WGSL against its twin in `cpu`: a million random cases and the edges, bit by bit.

mod common;

use gpu_check::bound::spread;
use gpu_check::check::{check, compile, results};
use gpu_check::kernels::KERNELS;
use gpu_check::{Float, Kernel};
use shaders::Library;

const RANDOM_CASES: usize = 1 << 20;

/// Runs both kinds of cases and gives the number of comparisons.
fn gives_the_bits_of_cpu<T: Float>(kernel: &Kernel) -> usize {
    let gpu = common::gpu();
    let pipeline = compile::<T>(&gpu, &Library::standard(), kernel).unwrap_or_else(|error| panic!("{error}"));
    let mut compared = 0;
    for (kind, cases) in [("edges", kernel.edge_cases::<T>()), ("random", kernel.random_cases::<T>(RANDOM_CASES, 42))] {
        let tally = check(&gpu, &pipeline, kernel, &cases).unwrap_or_else(|error| panic!("{error}"));
        println!("{} {kind} {tally}", T::PRECISION);
        assert_eq!(tally.differing, 0, "{tally}");
        assert!(tally.cases >= if kind == "edges" { 400 } else { RANDOM_CASES }, "{tally}");
        assert!(tally.nonzero > tally.cases / 10, "too few hits: {tally}");
        compared += tally.numbers;
    }
    compared
}

#[test]
fn f64_gives_the_bits_of_cpu() {
    for kernel in &KERNELS {
        let t = std::time::Instant::now();
        gives_the_bits_of_cpu::<f64>(kernel);
        println!("{:?}", t.elapsed());
    }
}

#[test]
fn f32_gives_the_bits_of_cpu() {
    for kernel in &KERNELS {
        let t = std::time::Instant::now();
        gives_the_bits_of_cpu::<f32>(kernel);
        println!("{:?}", t.elapsed());
    }
}

#[test]
fn f32_is_within_its_bound_of_f64() {
    let gpu = common::gpu();
    for kernel in &KERNELS {
        let pipeline = compile::<f32>(&gpu, &Library::standard(), kernel).unwrap_or_else(|error| panic!("{error}"));
        let cases = kernel.random_cases::<f32>(RANDOM_CASES, 43);
        let results = results(&gpu, &pipeline, kernel, &cases).unwrap_or_else(|error| panic!("{error}"));
        let spread = spread(kernel, &cases, &results);
        println!("{} {spread}", kernel.module);
        assert_eq!(spread.beyond, 0, "{} {spread}", kernel.module);
    }
}
