//! Compares f64 by integers with Rust's f64: every operation, every formula, and whole pictures.
//!
//! The variable `LOWERED_CASES` sets the number of cases of each operation.

mod common;

use cpu::{Scatter, reference};
use gpu_check::check::{check as check_kernel, compile};
use gpu_check::difference::difference;
use gpu_check::kernels::KERNELS;
use gpu_check::lowered::{check, operations};
use gpu_check::scenes::{self, Case};
use gpu_check::{Picture, Renderer};
use shaders::lower::Arithmetic;
use shaders::{Features, Library};

/// Number of cases of each operation, unless `LOWERED_CASES` sets another.
const CASES: usize = 1_000_000;
/// Number of random cases of each formula.
const FORMULA_CASES: usize = 1 << 16;
/// Number of random scenes.
const RANDOM_SCENES: u64 = 60;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 1_500_000;

/// Returns the number of cases of each operation.
fn cases() -> usize {
    match std::env::var("LOWERED_CASES") {
        Ok(text) => text.parse().expect("LOWERED_CASES is a number"),
        Err(_) => CASES,
    }
}

#[test]
fn every_operation_gives_the_bits_of_rust() {
    let gpu = common::gpu();
    let count = cases();
    let mut faults = Vec::new();
    for operation in operations::all() {
        let tally = check(&gpu, operation, count, 30).unwrap_or_else(|error| panic!("{}: {error}", operation.wgsl));
        println!("{tally}");
        assert_eq!(tally.cases, count);
        assert!(tally.ordinary > count / 10, "too few ordinary results: {tally}");
        if tally.differing > 0 {
            faults.push(tally.to_string());
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Returns the library whose compositions have integers in the place of f64.
fn library() -> Library {
    Library::standard().lowered(Arithmetic::standard())
}

#[test]
fn every_formula_gives_the_bits_of_cpu() {
    let gpu = common::gpu();
    let mut compared = 0;
    for kernel in &KERNELS {
        let pipeline = compile::<f64>(&gpu, &library(), kernel).unwrap_or_else(|error| panic!("{error}"));
        for cases in [kernel.edge_cases::<f64>(), kernel.random_cases::<f64>(FORMULA_CASES, 42)] {
            let tally = check_kernel(&gpu, &pipeline, kernel, &cases).unwrap_or_else(|error| panic!("{error}"));
            println!("{tally}");
            assert_eq!(tally.differing, 0, "{tally}");
            compared += tally.numbers;
        }
    }
    println!("{} kernels, {compared} numbers compared", KERNELS.len());
    assert!(compared > 5_000_000);
}

/// Returns all scenes of the repository, the edge cases, and random scenes.
fn pictures() -> Vec<Case> {
    let files = ["tests/cases", "scenes"].map(|folder| {
        scenes::in_folder(&scenes::repository(folder)).unwrap_or_else(|error| panic!("{error}"))
    });
    assert!(files.iter().flatten().count() >= 16, "the repository has scenes");
    let others = scenes::edges().into_iter().chain((0..RANDOM_SCENES).map(scenes::random));
    files.into_iter().flatten().chain(others).map(|case| case.within(TESTS)).collect()
}

#[test]
fn every_picture_is_the_references_to_the_bit() {
    let gpu = common::gpu();
    let (mut pixels, mut lit, mut faults) = (0, 0, Vec::new());
    let cases = pictures();
    // A pipeline of so many instructions takes seconds to compile, so all scenes share one.
    let deepest = cases.iter().map(|case| case.config.max_depth as u32).max().expect("there are scenes");
    let renderer = Renderer::<f64>::new(&gpu, &library(), &Features::all(deepest)).expect("the kernel is valid");
    for case in &cases {
        let picture = Picture::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let rendering = renderer.render(&picture).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        let mut expected = Vec::new();
        reference::render_linear(&case.config, &case.scene, Scatter::Deterministic, |_, mean| expected.push(mean))
            .unwrap_or_else(|error| panic!("{}: {error}", case.name));
        let found = difference(&rendering.pixels, &expected);
        pixels += found.pixels;
        lit += expected.iter().filter(|color| **color != cpu::Vec3::ZERO).count();
        println!("{}: {found}, {:.1?}", case.name, rendering.time);
        if found.differing > 0 {
            faults.push(format!("{}: {found}", case.name));
        }
    }
    println!("{} pictures, {pixels} pixels compared, {lit} of them not black", cases.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(lit > 40_000, "{lit} pixels with light are too few");
}
