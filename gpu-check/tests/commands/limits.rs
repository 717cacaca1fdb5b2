//! Tests of the limits on memory and time for compiling and running a shader. A small limit must end the work, and a
//! larger one must not. The tests check only which limit ends the work, and no times.

use std::path::Path;
use std::time::Duration;

use gpu_check::guard::Limits;
use gpu_check::pipeline::Content;
use gpu_check::shader_lab::guard::check_within;
use gpu_check::{Error, Form, Gpu, Pipeline};
use shaders::{Composition, Precision};

use crate::common;

fn check(limits: Limits, text: String) -> Result<(), Error> {
    let program = Path::new(env!("CARGO_BIN_EXE_shader-lab"));
    check_within(program, limits, Form::AsWritten, &Composition::of_text(text, Precision::F32), &[])
}

/// Returns a kernel that computes a number for each invocation. `before` is the text before its function, and `body` a
/// part of the function's text.
fn kernel(before: &str, body: &str) -> String {
    format!(
        "@group(0) @binding(0) var<storage, read_write> numbers: array<f32>;\n{before}\n\
         @compute @workgroup_size(64)\nfn kernel(@builtin(global_invocation_id) id: vec3<u32>) {{\n\
         var x = f32(id.x);\n{body}\nnumbers[id.x] = x;\n}}\n"
    )
}

#[track_caller]
fn assert_ended(result: Result<(), Error>, how: &str) {
    let message = result.expect_err("a limit is exceeded").to_string();
    assert!(message.starts_with("the shader takes too much to compile: naga or the driver "), "{message}");
    assert!(message.contains(how), "{message}");
}

#[test]
fn compiling_ends_at_the_limit_on_memory() {
    // naga stores and compares elements of about 16 bytes each.
    let text = || kernel("const many = array<i32, 20000000>();\nconst_assert many == many;", "");
    let limits = |memory: u64| Limits { memory: memory << 20, ..Limits::STANDARD };
    assert_ended(check(limits(384), text()), "at most 384 MiB of memory");
    // naga refuses this text too, but `check` returns no error for that: the caller compiles the text again to report
    // it.
    check(limits(2048), text()).expect("this is enough");
}

#[test]
fn compiling_ends_at_the_limit_on_processor_time_in_the_driver_too() {
    // One long chain of operations, for which the driver needs several seconds and little memory.
    let slow = kernel("", &"x = sqrt(x * x + sin(x) / (x + 1.5));\n".repeat(2_900));
    assert_ended(check(Limits { seconds: 1, ..Limits::STANDARD }, slow), "ended by signal");
    check(Limits { seconds: 1, ..Limits::STANDARD }, kernel("", "x = sqrt(x);")).expect("this is quick");
}

#[test]
fn compiling_ends_at_the_limit_on_wall_clock_time() {
    let limits = Limits { patience: Duration::ZERO, ..Limits::STANDARD };
    assert_ended(check(limits, kernel("", "")), "of elapsed time, perhaps because the machine is busy");
    check(Limits::STANDARD, kernel("", "")).expect("this is enough");
}

#[test]
fn a_run_ends_at_the_limit_on_its_time() {
    let long = "for (var i = 0u; i < 3000000u; i++) { x = sqrt(x * x + 1.0); }";
    let run = |gpu: &Gpu, text: String| {
        let pipeline = Pipeline::new(gpu, &Composition::of_text(text, Precision::F32), &[])?;
        pipeline.run(gpu, &[Content::Output(64 * 1024 * 4)], 64 * 1024)
    };
    let gpu = common::gpu().with_patience(Duration::from_millis(1));
    let error = run(&gpu, kernel("", long)).expect_err("it takes longer");
    assert!(matches!(error, Error::Timeout { .. }), "{error}");
    run(&common::gpu(), kernel("", "x = sqrt(x);")).expect("it has time enough");
}
