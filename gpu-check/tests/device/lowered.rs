//! Compares f64 by integers with Rust's f64: every operation, every formula, and whole pictures.
//!
//! The variable `LOWERED_CASES` sets the number of cases of each operation.

pub mod comparison;
pub mod operands;
pub mod operations;

use std::time::Duration;

use gpu_check::pipeline::Content;
use gpu_check::{Error, Form, Gpu, Picture, Pipeline, Renderer};
use shaders::lower::Arithmetic;
use shaders::{Composition, Features, Library, Precision};

use crate::common::{self, Accuracy};
use crate::kernels::KERNELS;
use crate::pictures::Compared;
use crate::scenes;
use comparison::check;

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

/// The numbers of `everything.wgsl` that use conversions to f32, or `dot`, `length`, `normalize`, `cross` and `fract`.
const OF_F32_OR_COMPOSITE: [usize; 6] = [6, 7, 9, 10, 11, 14];

/// Opens the device, and lets integers calculate in the place of its f64.
fn by_integers() -> Gpu {
    common::gpu().with_form(Form::ByIntegers)
}

#[test]
fn every_formula_gives_the_bits_of_cpu() {
    let gpu = by_integers();
    let mut compared = 0;
    for kernel in &KERNELS {
        let rows = kernel.rows::<f64>();
        let pipeline = rows.compile(&gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}"));
        for cases in [kernel.edge_cases::<f64>(), kernel.random_cases::<f64>(FORMULA_CASES, 42)] {
            let tally = rows.check(&gpu, &pipeline, &cases).unwrap_or_else(|error| panic!("{error}"));
            println!("{tally}");
            assert_eq!(tally.differing, 0, "{tally}");
            compared += tally.numbers;
        }
    }
    println!("{} kernels, {compared} numbers compared", KERNELS.len());
    assert!(compared > 5_000_000);
}

#[test]
fn every_picture_is_the_references_to_the_bit() {
    let gpu = by_integers();
    let mut compared = Compared::default();
    let cases = scenes::all(RANDOM_SCENES, TESTS);
    assert!(cases.len() >= 16 + RANDOM_SCENES as usize + scenes::edges().len(), "the repository has scenes");
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
    compared.check(40_000);
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
    let draws = (0..size / 8 * count).map(|index| operands::draw(33, index as u64).a);
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
