//! Tests of the device: the message if there is none, its faults as errors, and the forms of its shaders.

use std::process::Command;

use gpu_check::pipeline::{Content, Pipeline};
use gpu_check::rows::results;
use gpu_check::{Error, Float, Form, Gpu};
use shaders::{Composition, Library, Precision};

use crate::common;
use crate::kernels;
use crate::pictures::prepared;
use crate::scenes::Case;

/// Returns the pipeline of `kernels/sphere`, which turns 10 numbers into 10, and a case for it.
fn sphere_pipeline(gpu: &Gpu) -> (Pipeline, Vec<f64>) {
    let [sphere, ..] = kernels::all::<f64>();
    (
        sphere.compile(gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}")),
        sphere.rows(0, 1)[..10].to_vec(),
    )
}

/// Runs the test `name` of this file in a new process, with these environment variables. Returns whether it passes, and
/// its output.
fn test_with(name: &str, variables: &[(&str, &str)]) -> (bool, String) {
    let program = std::env::current_exe().expect("a test knows its own name");
    let output = Command::new(program)
        .args(["--exact", name, "--nocapture"])
        .envs(variables.iter().copied())
        .output()
        .expect("the test starts again");
    (output.status.success(), String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned())
}

#[test]
fn the_device_names_its_driver_and_whether_it_has_f64() {
    let gpu = common::gpu();
    assert!(gpu.has_f64() || !gpu.is_lavapipe());
    assert!(gpu.binding_limit() >= 128 << 20);
    let (shown, f64) = (gpu.to_string(), if gpu.has_f64() { ", with f64, " } else { ", without f64, " });
    assert!(shown.starts_with(gpu.name()) && shown.contains("driver") && shown.contains(f64), "{shown}");
}

#[test]
fn without_a_driver_the_suite_fails_with_the_line_that_says_what_to_install() {
    let nowhere = [("VK_DRIVER_FILES", "/nowhere.json"), ("VK_ICD_FILENAMES", "/nowhere.json")];
    let (passed, output) = test_with("gpu::the_device_names_its_driver_and_whether_it_has_f64", &nowhere);
    assert!(!passed, "{output}");
    let line = output.lines().find(|line| line.starts_with("no GPU adapter")).unwrap_or_else(|| panic!("{output}"));
    assert!(line.contains("apt-get install mesa-vulkan-drivers") && line.contains("WGPU_ADAPTER_NAME"), "{line}");
}

#[test]
fn a_lost_device_is_an_error() {
    let gpu = common::gpu();
    let (pipeline, case) = sphere_pipeline(&gpu);
    gpu.close();
    let error = results(&gpu, &pipeline, [10, 10], &case).expect_err("it is closed");
    assert!(matches!(error, Error::DeviceLost { .. }), "{error}");
}

#[test]
fn a_buffer_beyond_the_limit_is_an_error_that_says_so() {
    let gpu = common::gpu();
    let (pipeline, _) = sphere_pipeline(&gpu);
    let contents = [Content::Input(&[0; 160]), Content::Output(gpu.binding_limit() + 8)];
    let error = pipeline.run(&gpu, &contents, 1).expect_err("it is too large");
    assert!(error.to_string().starts_with("an output takes 134217736 bytes and the device binds at most 134217728"));

    let config = cpu::Config { max_depth: 100_000, image_width: 2, ..cpu::Config::default() };
    let case = Case { name: "a long path".to_owned(), config, scene: cpu::Scene::default() };
    let (renderer, picture) = prepared::<f64>(&gpu, &Library::standard(), &case).expect("it compiles");
    let error = renderer.render(&picture).expect_err("the path is too long");
    assert!(error.to_string().starts_with("0 objects to a depth of 100000 are more than one run can loop"), "{error}");
}

#[test]
fn numbers_that_a_kernel_does_not_write_are_noticed() {
    let gpu = common::gpu();
    let (pipeline, case) = sphere_pipeline(&gpu);
    let contents = [Content::Input(bytemuck::cast_slice(&case)), Content::Output(3 * 80)];
    let error = pipeline.run(&gpu, &contents, 3).expect_err("the kernel ends with its cases");
    assert_eq!(error.to_string(), "the kernel [kernels/sphere] did not write 20 of the numbers it should have written");
}

/// Returns the number of sums whose rounding error differs from Rust's.
fn wrong_errors<T: Float>(gpu: &Gpu) -> usize {
    let [.., sums] = kernels::all::<T>();
    let pipeline = sums.compile(gpu, &Library::standard());
    let tally = pipeline.and_then(|pipeline| sums.check(gpu, &pipeline, &sums.rows(4096, 7)));
    let tally = tally.unwrap_or_else(|error| panic!("{error}"));
    println!("{} {}: {tally}", T::PRECISION, gpu.form(T::PRECISION));
    tally.differing
}

#[test]
fn sums_keep_their_rounding_errors_as_written_and_by_integers() {
    let gpu = common::gpu();
    // Elsewhere, the driver takes WGSL alone, and may rewrite it.
    if gpu.form(Precision::F32) == Form::AsWritten {
        assert_eq!([wrong_errors::<f32>(&gpu), wrong_errors::<f64>(&gpu)], [0, 0]);
    }
    let gpu = gpu.with_form(Form::ByIntegers);
    assert_eq!(
        [Precision::F32, Precision::F64].map(|precision| gpu.form(precision)),
        [Form::AsWritten, Form::ByIntegers]
    );
    assert_eq!(wrong_errors::<f64>(&gpu), 0);
    // Where a driver rewrites, the decoration is what prevents it.
    let gpu = gpu.with_form(Form::AsDriverLikes);
    let probes = common::conformance::all();
    let cancels = probes.iter().find(|probe| probe.name == "cancel-term").expect("it exists");
    let rewrites = cancels.verdict(&gpu).starts_with("rewritten: ");
    assert_eq!(wrong_errors::<f32>(&gpu) > 0, rewrites);
    assert!(rewrites || !gpu.is_lavapipe(), "a new version of Mesa rewrites no more: change docs/gpu.md");
}

#[test]
fn integers_calculate_f64_by_themselves_where_the_device_has_none() {
    let gpu = Gpu::open_without_f64().unwrap_or_else(|error| panic!("{error}"));
    let shown = gpu.to_string();
    assert!(!gpu.has_f64() && shown.ends_with("without f64, f32 as written, f64 by integers"), "{shown}");
    assert_eq!(wrong_errors::<f64>(&gpu), 0);
}

#[test]
fn a_shader_without_floating_point_is_right_in_every_form() {
    let text = "@group(0) @binding(3) var<storage, read_write> results: array<u32>;
        @group(0) @binding(1) var<storage, read> cases: array<u32>;
        override factor: u32;
        override unused: f32 = 1.0;
        @compute @workgroup_size(64) fn kernel(@builtin(global_invocation_id) id: vec3<u32>) {
            results[id.x] = cases[id.x] * factor + cases[id.x + 1000u];
        }";
    let cases: Vec<u32> = (0..128).map(|case| case * case).collect();
    let results = Form::ALL.map(|form| {
        let gpu = common::gpu().with_form(form);
        let composition = Composition::of_text(text.to_owned(), Precision::F32);
        assert!(Pipeline::new(&gpu, &composition, &[("nothing", 1.0)]).is_err(), "{form}");
        let pipeline = Pipeline::new(&gpu, &composition, &[("factor", 3.0)]).expect("it is valid");
        let contents = [Content::Input(bytemuck::cast_slice(&cases)), Content::Output(4 * cases.len() as u64)];
        let run = pipeline.run(&gpu, &contents, cases.len() as u64).unwrap_or_else(|error| panic!("{error}"));
        bytemuck::pod_collect_to_vec::<u8, u32>(&run.outputs.concat())
    });
    // The index beyond the end is replaced by the last one, or the load gives 0.
    let last = cases[127];
    for results in &results {
        let is_right = |(case, result): (&u32, &u32)| [case * 3 + last, case * 3].contains(result);
        assert!(cases.iter().zip(results).all(is_right), "{results:?}");
    }
    assert!(results[0].iter().zip(&cases).all(|(result, case)| *result == case * 3 + last), "{results:?}");
}
