//! Tests of the device: the message if there is none, its faults as errors, and the rewritings of its driver.

mod common;

use std::process::Command;

use gpu_check::pipeline::{Content, Pipeline};
use gpu_check::{Error, Formulas, Gpu, Kernel, Picture, Renderer, check, kernels, rewrites};
use shaders::{Features, Library, Precision};

fn sphere_pipeline(gpu: &Gpu) -> (&'static Kernel, Pipeline) {
    let kernel = &kernels::KERNELS[0];
    (kernel, check::compile::<f64>(gpu, &Library::standard(), kernel).unwrap_or_else(|error| panic!("{error}")))
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
fn the_device_has_f64_and_names_its_driver() {
    let gpu = common::gpu();
    assert!(gpu.has_f64() && gpu.binding_limit() >= 128 << 20);
    let shown = gpu.to_string();
    assert!(shown.starts_with(gpu.name()) && shown.contains("driver") && shown.contains("with f64"), "{shown}");
}

#[test]
fn without_a_driver_the_suite_fails_with_the_line_that_says_what_to_install() {
    let nowhere = [("VK_DRIVER_FILES", "/nowhere.json"), ("VK_ICD_FILENAMES", "/nowhere.json")];
    let (passed, output) = test_with("the_device_has_f64_and_names_its_driver", &nowhere);
    assert!(!passed, "{output}");
    let line = output.lines().find(|line| line.starts_with("no GPU adapter")).unwrap_or_else(|| panic!("{output}"));
    assert!(line.contains("apt-get install mesa-vulkan-drivers") && line.contains("WGPU_ADAPTER_NAME"), "{line}");
}

#[test]
fn another_adapter_can_be_asked_for_and_the_message_names_a_missing_one() {
    let name = "the_device_has_f64_and_names_its_driver";
    let (passed, output) = test_with(name, &[("WGPU_ADAPTER_NAME", "no such adapter")]);
    assert!(!passed && output.contains("no GPU adapter has [no such adapter] in its name"), "{output}");
    if !common::gpu().is_lavapipe() {
        return;
    }
    let (passed, output) = test_with(name, &[("WGPU_ADAPTER_NAME", "LLVMpipe"), ("WGPU_BACKEND", "vulkan")]);
    assert!(passed, "{output}");
}

#[test]
fn a_lost_device_is_an_error() {
    let gpu = common::gpu();
    let (kernel, pipeline) = sphere_pipeline(&gpu);
    gpu.close();
    let error = check::results::<f64>(&gpu, &pipeline, kernel, &kernel.edge_cases()).expect_err("it is closed");
    assert!(matches!(error, Error::DeviceLost { .. }), "{error}");
}

#[test]
fn a_buffer_beyond_the_limit_is_an_error_that_says_so() {
    let gpu = common::gpu();
    let (_, pipeline) = sphere_pipeline(&gpu);
    let contents = [Content::Input(&[0; 160]), Content::Output(gpu.binding_limit() + 8)];
    let error = pipeline.run(&gpu, &contents, 1).expect_err("it is too large");
    assert!(error.to_string().starts_with("an output takes 134217736 bytes and the device binds at most 134217728"));

    let config = cpu::Config { max_depth: 100_000, image_width: 2, ..cpu::internals::input::config::Config::default() };
    let picture = Picture::<f64>::new(&config, &cpu::internals::input::scene::Scene::default())
        .expect("the configuration is valid");
    let renderer = Renderer::<f64>::new(&gpu, &Library::standard(), &Features::all(picture.max_depth));
    let error = renderer.and_then(|renderer| renderer.render(&picture)).expect_err("the path is too long");
    assert!(error.to_string().starts_with("0 objects to a depth of 100000 are more than one run can loop"), "{error}");
}

#[test]
fn numbers_that_a_kernel_does_not_write_are_noticed() {
    let gpu = common::gpu();
    let (kernel, pipeline) = sphere_pipeline(&gpu);
    let case = kernel.random_cases::<f64>(1, 1);
    let row = (kernel.outputs.len() * size_of::<f64>()) as u64;
    let contents = [Content::Input(bytemuck::cast_slice(&case)), Content::Output(3 * row)];
    let error = pipeline.run(&gpu, &contents, 3).expect_err("the kernel ends with its cases");
    assert_eq!(error.to_string(), "the kernel [kernels/sphere] did not write 20 of the numbers it should have written");
}

#[test]
fn a_fault_in_a_replaced_module_is_shown_where_it_stands() {
    let gpu = common::gpu();
    let mut library = Library::standard();
    let source = library.source("background").expect("it exists").replace("real(2.0)", "2.0 * m2");
    library.replace("background", "my/background.wgsl", source).expect("it exists");
    let error = Renderer::<f64>::new(&gpu, &library, &Features::all(5)).expect_err("m2 is nothing");
    let lines: Vec<_> = error.to_string().lines().map(str::to_owned).collect();
    assert!(lines[0].starts_with("my/background.wgsl:11:72: no definition in scope for identifier"), "{error}");
    assert!(lines[1].starts_with("11 |     let m = ") && lines[2].trim_start() == "^^", "{error}");
}

fn keeps_the_barrier<T: Formulas>(gpu: &Gpu) {
    let rewrites = rewrites::observe::<T>(gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}"));
    println!("{}: {rewrites}", T::PRECISION);
    rewrites::require_barrier::<T>(gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}"));

    // This checks the self-test: without the barrier, a driver that cancels terms must fail it.
    let mut without = Library::standard();
    let source = without.source("exact").expect("it exists").replace("a * one + b", "a + b");
    without.replace("exact", "without barrier", source).expect("it exists");
    let passes = rewrites::require_barrier::<T>(gpu, &without).is_ok();
    assert_eq!(passes, !rewrites.cancels_terms, "{rewrites}");
    if gpu.is_lavapipe() {
        // This fails if a new version of Mesa or naga stops rewriting. Then docs/gpu.md must be changed.
        let expected = rewrites::Rewrites {
            cancels_terms: true,
            factors_out: true,
            squares_roots: true,
            drops_zeros: true,
            forgets_nan: true,
        };
        assert_eq!(rewrites, expected);
    }
}

#[test]
fn sums_keep_their_rounding_errors_behind_the_barrier_and_not_without() {
    let gpu = common::gpu();
    assert_eq!(Precision::ALL.len(), 2);
    keeps_the_barrier::<f32>(&gpu);
    keeps_the_barrier::<f64>(&gpu);
}
