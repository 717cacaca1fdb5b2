//! Compares f64 by integers with Rust's f64: every operation, every formula, and whole pictures.
//!
//! `RENDER_CASES` sets the number of cases of each operation.

pub mod operands;
pub mod operations;

use std::time::Duration;

use gpu_check::pipeline::Content;
use gpu_check::{Error, Form, Gpu, Picture, Pipeline, Renderer};
use shaders::lower::Arithmetic;
use shaders::{Composition, Features, Library, Precision};
use test_support::number_of;

use crate::common::{self, Accuracy};
use crate::kernels::kernel::{Tally, compare};
use crate::pictures::Compared;
use crate::scenes;
use operands::draw;
use operations::{BASIC, COMPOSITE, Operation};

/// Number of cases of each operation, unless `RENDER_CASES` sets another, and the largest number of them in memory.
const CASES: u64 = 1_000_000;
/// Number of random scenes.
const RANDOM_SCENES: u64 = 30;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 1_500_000;

/// Compares the results of `operation` for `cases` with Rust's. Integers calculate it, by `arithmetic`.
///
/// # Errors
/// The errors of lowering, of [`Pipeline::new`] and of [`Pipeline::run`].
pub fn check(gpu: &Gpu, operation: &Operation, arithmetic: &Arithmetic, cases: &[f64]) -> Result<Tally, Error> {
    let (wgsl, truth) = operation;
    let kernel = format!(
        "struct Case {{ a: f64, b: f64, c: f64, word: u32, unused: u32 }}\n\
         @group(0) @binding(0) var<storage, read> cases: array<Case>;\n\
         @group(0) @binding(1) var<storage, read_write> results: array<f64>;\n\
         @compute @workgroup_size(64)\n\
         fn operation(@builtin(global_invocation_id) id: vec3<u32>) {{\n    \
         if id.x >= arrayLength(&cases) {{ return; }}\n    \
         let a = cases[id.x].a;\n    let b = cases[id.x].b;\n    let c = cases[id.x].c;\n    \
         let word = cases[id.x].word;\n    results[id.x] = {wgsl};\n}}\n"
    );
    let composition = Composition::of_file(wgsl, kernel, Precision::F64).lowered(arithmetic)?;
    let pipeline = Pipeline::new(gpu, &composition, &[])?;
    compare(gpu, &pipeline, (wgsl, 4), cases, |case| {
        let [numbers @ .., word] = case else { unreachable!("a case has four numbers") };
        vec![Some(truth([numbers[0], numbers[1], numbers[2]], word.to_bits() as u32))]
    })
}

#[test]
fn every_operation_gives_the_bits_of_rust() {
    let gpu = common::gpu();
    let count = number_of("RENDER_CASES").unwrap_or(CASES);
    assert!(count > 0, "RENDER_CASES must be positive");
    let mut faults = Vec::new();
    for first in (0..count).step_by(CASES as usize) {
        let cases = (first..count.min(first + CASES)).flat_map(|index| draw(30, index)).collect::<Vec<_>>();
        for operation in BASIC.iter().chain(&COMPOSITE) {
            let tally = check(&gpu, operation, &Arithmetic::standard(), &cases);
            let tally = tally.unwrap_or_else(|error| panic!("{}: {error}", operation.0));
            println!("{tally}");
            assert!(tally.ordinary > tally.cases / 10, "too few ordinary results: {tally}");
            faults.extend((tally.differing > 0).then(|| tally.to_string()));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The numbers of `everything.wgsl` that use conversions to f32, or `dot`, `length`, `normalize`, `cross` and `fract`.
const OF_F32_OR_COMPOSITE: [usize; 6] = [6, 7, 9, 10, 11, 14];

#[test]
fn every_picture_is_the_references_to_the_bit() {
    let gpu = common::gpu().with_form(Form::ByIntegers);
    let mut compared = Compared::default();
    let cases = scenes::all(scenes::number_of_random(RANDOM_SCENES), TESTS);
    // A pipeline of so many instructions takes seconds to compile, so all scenes share one.
    let deepest = cases.iter().map(|case| case.config.max_depth as u32).max().expect("there are scenes");
    let renderer =
        Renderer::<f64>::new(&gpu, &Library::standard(), &Features::all(deepest), &[]).expect("the kernel is valid");
    for case in &cases {
        let picture = Picture::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let rendering = renderer.render(&picture).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        println!("{}: {:.1?}", case.name, rendering.time);
        compared.add(case, &rendering.pixels);
    }
    compared.check(150_000);
}

/// Runs a module with every construct, and returns its results and the time of the device.
fn run_everything(gpu: &Gpu, is_lowered: bool, items: &[u8], count: usize) -> Result<Vec<u64>, Error> {
    let source = include_str!("../../../shaders/tests/lowered/everything.wgsl").to_owned();
    let composition = Composition::of_file("everything.wgsl", source, Precision::F64);
    let composition = if is_lowered { composition.lowered(&Arithmetic::standard())? } else { composition };
    let pipeline = Pipeline::new(gpu, &composition, &[])?;
    let copies = items.len() as u64;
    let contents = [Content::Input(items), Content::Output((count * 128) as u64), Content::Scratch(copies)];
    Ok(bytemuck::pod_collect_to_vec(&pipeline.run(gpu, &contents, count as u64)?.outputs.concat()))
}

#[test]
fn every_construct_gives_the_bits_of_the_devices_f64() {
    let gpu = common::gpu();
    // An item has 320 bytes. Numbers of moderate size stand at every place where one can be.
    let (size, count) = (320, 64 * 64);
    let draws = (0..size / 8 * count).map(|index| draw(33, index as u64)[0]);
    let moderate =
        |number: f64| if number.is_nan() || number.abs() > 1e6 { number.to_bits() as f64 / 1e16 } else { number };
    let numbers: Vec<_> = draws.map(moderate).collect();
    let items = bytemuck::cast_slice(&numbers);
    let [native, lowered] = [false, true]
        .map(|is_lowered| run_everything(&gpu, is_lowered, items, count).unwrap_or_else(|error| panic!("{error}")));
    let same = |(a, b): (&u64, &u64)| a == b || [a, b].iter().all(|bits| f64::from_bits(**bits).is_nan());
    let mut by_place = [0; 16];
    for (index, pair) in native.iter().zip(&lowered).enumerate() {
        by_place[index % 16] += usize::from(!same(pair));
    }
    println!("{} numbers compared; differing by place in a row: {by_place:?}", native.len());
    assert_eq!((native.len(), lowered.len()), (16 * count, 16 * count));
    if common::accuracy(&gpu) == Accuracy::Wgsl {
        // Such a device may flush conversions to f32, and calculate composite functions in its own order.
        assert!(by_place.iter().all(|count_at_place| *count_at_place < count / 8), "{by_place:?}");
        OF_F32_OR_COMPOSITE.iter().for_each(|place| by_place[*place] = 0);
    }
    assert_eq!(by_place, [0; 16]);
    let different: std::collections::BTreeSet<_> = native.iter().collect();
    assert!(different.len() > count, "{} different numbers", different.len());
}

/// Returns the shortest time of three runs of 64 steps `step`, for each of 2^18 numbers.
fn time_of(gpu: &Gpu, step: &str, is_lowered: bool) -> Result<Duration, Error> {
    let source = format!(
        "@group(0) @binding(0) var<storage, read> numbers: array<vec2<f64>>;\n\
         @group(0) @binding(1) var<storage, read_write> results: array<f64>;\n\
         @compute @workgroup_size(64)\nfn steps(@builtin(global_invocation_id) id: vec3<u32>) {{\n\
         var x = numbers[id.x].x;\nlet b = numbers[id.x].y;\n\
         for (var i = 0u; i < 64u; i++) {{ {step} }}\nresults[id.x] = x;\n}}\n"
    );
    let composition = Composition::of_file("steps.wgsl", source, Precision::F64);
    let composition = if is_lowered { composition.lowered(&Arithmetic::standard())? } else { composition };
    let pipeline = Pipeline::new(gpu, &composition, &[])?;
    let count = 1_u32 << 18;
    let numbers: Vec<_> = (0..count).flat_map(|index| [1.0 + f64::from(index) * 1e-9, 0.999_999_9]).collect();
    let contents = [Content::Input(bytemuck::cast_slice(&numbers)), Content::Output(8 * u64::from(count))];
    let times = (0..3).map(|_| pipeline.run(gpu, &contents, count.into()).map(|run| run.time));
    Ok(times.collect::<Result<Vec<_>, _>>()?.into_iter().min().unwrap_or_default())
}

#[test]
#[ignore = "a measurement for docs/lowering.md"]
fn the_cost_of_integers_against_the_devices_f64() {
    let gpu = common::gpu();
    let steps = [
        ("sum", "x = x + b;"),
        ("product", "x = x * b;"),
        ("quotient", "x = x / b;"),
        ("square root", "x = sqrt(x);"),
        ("comparison", "x = select(x, b, x < b);"),
        ("floor", "x = floor(x);"),
    ];
    for (name, step) in steps {
        let [native, lowered] = [false, true]
            .map(|is_lowered| time_of(&gpu, step, is_lowered).unwrap_or_else(|error| panic!("{name}: {error}")));
        let nanoseconds = |time: Duration| time.as_secs_f64() * 1e9 / f64::from(64 << 18);
        let (native, lowered) = (nanoseconds(native), nanoseconds(lowered));
        println!("| {name} | {native:.2} ns | {lowered:.2} ns | {:.0} times |", lowered / native);
        assert!(native > 0.0 && lowered > 0.0);
    }
}
