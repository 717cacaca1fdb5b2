//! Compares every formula in WGSL with its twin in `cpu`, bit by bit, for a million random cases and for the edge
//! cases.

#[path = "kernels/bound.rs"]
mod bound;
mod common;
#[path = "kernels/mod.rs"]
mod kernels;

use gpu_check::first_difference::twins::twin;
use gpu_check::reader::Reader;
use gpu_check::rows::results;
use gpu_check::{Error, Gpu};
use shaders::{Library, Precision};

use bound::spread;
use common::Accuracy;
use kernels::KERNELS;
use kernels::kernel::{Formulas, Kernel};

const RANDOM_CASES: usize = 1 << 20;
const FEWEST_EDGES: usize = 400;

/// Compares the results of edge cases and random cases. Returns the number of compared results.
fn gives_the_bits_of_cpu<T: Formulas>(gpu: &Gpu, kernel: &Kernel) -> Result<usize, Error> {
    let rows = kernel.rows::<T>();
    let pipeline = rows.compile(gpu, &Library::standard())?;
    let (edges, random) = (kernel.edge_cases::<T>(), kernel.random_cases::<T>(RANDOM_CASES, 42));
    let mut compared = 0;
    for (cases, fewest) in [(edges, FEWEST_EDGES), (random, RANDOM_CASES)] {
        let tally = rows.check(gpu, &pipeline, &cases)?;
        println!("{} {tally}", T::PRECISION);
        assert_eq!(tally.differing, 0, "{tally}");
        assert!(tally.cases >= fewest, "too few cases: {tally}");
        assert!(tally.nonzero > tally.cases / 10, "too few hits: {tally}");
        compared += tally.numbers;
    }
    Ok(compared)
}

fn every_kernel_gives_the_bits_of_cpu<T: Formulas>() {
    let gpu = common::gpu();
    let compared: usize = KERNELS
        .iter()
        .map(|kernel| gives_the_bits_of_cpu::<T>(&gpu, kernel).unwrap_or_else(|error| panic!("{error}")))
        .sum();
    println!("{}: {} kernels, {compared} numbers compared", T::PRECISION, KERNELS.len());
    assert!(compared > 30_000_000);
}

#[test]
fn f64_gives_the_bits_of_cpu() {
    every_kernel_gives_the_bits_of_cpu::<f64>();
}

#[test]
fn f32_gives_the_bits_of_its_twin_on_a_device_with_the_arithmetic_of_ieee() {
    // Elsewhere the bounds of the last test hold.
    if common::accuracy(&common::gpu()) == Accuracy::Wgsl {
        return;
    }
    every_kernel_gives_the_bits_of_cpu::<f32>();
}

#[test]
fn f32_is_within_its_bound_of_f64() {
    let gpu = common::gpu();
    let accuracy = common::accuracy(&gpu);
    for kernel in &KERNELS {
        let cases = kernel.random_cases::<f32>(RANDOM_CASES, 43);
        let rows = kernel.rows::<f32>();
        let (results, _) = rows
            .compile(&gpu, &Library::standard())
            .and_then(|pipeline| results(&gpu, &pipeline, [rows.inputs, rows.outputs.len()], &cases))
            .unwrap_or_else(|error| panic!("{error}"));
        let found = spread(accuracy, kernel, &cases, &results);
        println!("{} {found}", kernel.module);
        assert_eq!(found.beyond, 0, "{} {found}", kernel.module);
        assert!(found.decided > RANDOM_CASES / 2, "too few: {} {found}", kernel.module);
        assert!(found.compared > found.decided && found.closest > 0.1, "too large a bound: {} {found}", kernel.module);

        // This checks the bound itself: results that are slightly too large must exceed it.
        let wrong: Vec<_> = results.iter().map(|number| number * 1.001 + 0.001).collect();
        let noticed = spread(accuracy, kernel, &cases, &wrong).beyond;
        assert!(noticed > RANDOM_CASES / 2, "{} notices {noticed}", kernel.module);
    }
}

/// Functions without a twin: parts of functions that have one, and functions that read buffers.
const WITHOUT: [&str; 20] = [
    "bounce_attenuated",
    "cylinder_closer",
    "cylinder_side",
    "cylinder_with_caps",
    "hit_report",
    "hit_report_none",
    "intersect_cylinder",
    "intersect_every_object",
    "intersect_sphere",
    "is_closer",
    "projected_crossings",
    "sample_camera_ray",
    "scatter_vector_in_cube",
    "scatter_vector_next",
    "scatter_vector_published",
    "scatter_word",
    "sphere_first_root",
    "surface_at",
    "tie_is_closer",
    "tie_rank",
];

#[test]
fn every_function_has_a_twin_with_as_many_numbers_or_is_listed() {
    let mut names = Vec::new();
    let pictures = ["kernels/image", "kernels/steps", "kernels/samples"];
    for kernel in KERNELS.iter().map(|kernel| kernel.module).chain(pictures) {
        let composition = Library::standard().compose(kernel, Precision::F64).expect("it exists");
        for function in composition.with_call_trace().expect("it is valid").functions {
            let Some(twin) = twin::<f64>(&function.name) else {
                names.push(function.name);
                continue;
            };
            let arguments = vec![0.5; function.arguments.len()];
            // Functions of a picture have no result without one.
            if let Some(numbers) = twin(None, Reader(&arguments)) {
                assert_eq!(numbers.len(), function.results.len(), "{}", function.name);
            }
        }
    }
    names.sort_unstable();
    names.dedup();
    assert_eq!(names, WITHOUT);
}
