//! Compares every formula in WGSL with its twin in Rust, bit by bit, for 262,144 random cases (with `RENDER_ALL=1` for
//! 1,048,576) and for the edge cases.

mod common;
#[path = "kernels/mod.rs"]
mod kernels;

use gpu_check::Float;
use gpu_check::first_difference::twins::twin;
use gpu_check::reader::Reader;
use shaders::{Library, Precision};
use test_support::everything;

use common::Accuracy;

const FEWEST_EDGES: usize = 400;

fn every_kernel_gives_the_bits_of_its_twin<T: Float>() {
    let (gpu, mut compared) = (common::gpu(), 0);
    let random_cases = if everything() { 1 << 20 } else { 1 << 18 };
    for kernel in kernels::all::<T>() {
        let pipeline = kernel.compile(&gpu, &Library::standard());
        let tally = pipeline.and_then(|pipeline| kernel.check(&gpu, &pipeline, &kernel.rows(random_cases, 42)));
        let tally = tally.unwrap_or_else(|error| panic!("{error}"));
        println!("{} {tally}", T::PRECISION);
        assert_eq!(tally.differing, 0, "{tally}");
        assert!(tally.cases >= random_cases - 9 + FEWEST_EDGES, "too few cases: {tally}");
        assert!(tally.ordinary > tally.cases / 10, "too few hits: {tally}");
        compared += tally.numbers;
    }
    println!("{}: {compared} numbers compared", T::PRECISION);
    assert!(compared > 28 * random_cases);
}

#[test]
fn f64_and_f32_where_it_can_give_the_bits_of_the_twins() {
    every_kernel_gives_the_bits_of_its_twin::<f64>();
    match common::accuracy(&common::gpu()) {
        Accuracy::Ieee => every_kernel_gives_the_bits_of_its_twin::<f32>(),
        Accuracy::Wgsl => println!("f32: not compared; the pictures of `device` have bounds"),
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
    for kernel in kernels::all::<f64>().iter().map(|kernel| kernel.module).chain(pictures) {
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
