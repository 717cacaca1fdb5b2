//! Holds the device to IEEE 754 and WGSL with the probes of `tests/common/conformance`. This command prints the table
//! of verdicts for a device, in the form of `docs/gpu/probes.csv`:
//!
//!     cargo test -p gpu-check --test device conformance -- --nocapture

use std::collections::BTreeSet;

use gpu_check::Form;
use test_support::project_root;

use crate::common::{self, conformance::Probe, conformance::Value, conformance::all};

#[test]
fn the_verdicts_on_lavapipe_are_the_documented_ones() {
    let gpu = common::gpu();
    let forms = [Form::AsWritten, Form::AsDriverLikes];
    let text = std::fs::read_to_string(project_root().join("docs/gpu/probes.csv")).expect("it is committed");
    let table: Vec<Vec<&str>> = text.lines().map(|line| line.trim_matches('"').split("\",\"").collect()).collect();
    assert_eq!(table.len(), 1 + all().len(), "the documented table has a line for each probe");
    let gpus = forms.map(|form| common::gpu().with_form(form));
    let driver = |form: Form| format!("{}; {}, {form}", gpu.name(), gpu.driver());
    println!("\"probe\",\"program\",{:?},{:?}", driver(forms[0]), driver(forms[1]));
    let mut compared = 0;
    for (probe, row) in all().iter().zip(&table[1..]) {
        assert_eq!([&*probe.name, probe.result], row[..2]);
        let found = gpus.each_ref().map(|gpu| probe.verdict(gpu));
        println!("{:?},{:?},{:?},{:?}", probe.name, probe.result, found[0], found[1]);
        for (form, found) in forms.iter().zip(found).filter(|_| gpu.is_lavapipe()) {
            let is_column = |head: &&str| head.starts_with("llvmpipe") && head.contains(&format!(", {form};"));
            let column = table[0].iter().position(is_column).expect("lavapipe has a column for each form");
            // The number of wrong cases is not compared: it depends on how many invocations a driver runs at once.
            let both_fail = [&*found, row[column]].iter().all(|verdict| verdict.starts_with("failure"));
            assert!(both_fail || found == row[column], "{}: {found} instead of {}, {form}", probe.name, row[column]);
            compared += 1;
        }
    }
    assert!(!gpu.is_lavapipe() || compared == 128, "{compared} verdicts compared");
}

#[test]
fn every_probe_is_a_short_valid_program_with_a_name_of_its_own() {
    let probes = all();
    let names: BTreeSet<_> = probes.iter().map(|probe| &probe.name).collect();
    assert_eq!((names.len(), probes.len()), (64, 64));
    for Probe { name, text, .. } in &probes {
        assert!(text.lines().count() <= 20, "{name}: {} lines\n{text}", text.lines().count());
    }
    assert!(probes.iter().all(|probe| probe.composition().validate().is_ok()));
}

#[test]
fn results_that_follow_a_reading_get_its_verdict_and_one_wrong_result_is_a_failure() {
    for probe in all() {
        assert_eq!(probe.readings[0].0, "as written");
        for (name, results) in &probe.readings {
            // Two readings that the inputs do not tell apart would make a verdict without meaning.
            assert_eq!((probe.judge)(results), *name, "{}", probe.name);
        }
        let good = &probe.readings[0].1;
        let width = if probe.text.contains("output: array<f64>") { 8 } else { 4 };
        for last in (width - 1..good.len()).step_by(width) {
            let mut results = good.clone();
            // Changes sign and exponent of a floating-point number, and the highest bits of an integer.
            results[last] ^= 0b1010_0101;
            let verdict = (probe.judge)(&results);
            assert!(verdict.starts_with("failure: 1 of "), "{}, byte {last}: {verdict}", probe.name);
        }
    }
}

/// Checks that the results of a wrong formula are a failure: they are neither as written nor an allowed rewriting.
#[track_caller]
fn fails<I: Value, O: Value, const N: usize>(name: &str, wrong: impl Fn([I; N]) -> O) {
    let probe = all().into_iter().find(|probe| probe.name == name).expect("there is a probe of this name");
    let inputs: Vec<I> = bytemuck::pod_collect_to_vec(&probe.input);
    let results: Vec<O> = inputs.chunks(N).map(|case| wrong(std::array::from_fn(|index| case[index]))).collect();
    let verdict = (probe.judge)(bytemuck::cast_slice(&results));
    assert!(verdict.starts_with("failure: "), "{name}: {verdict}");
}

#[test]
fn results_of_wrong_formulas_are_failures() {
    // A test that only compares with the formula as written would take the first formula for a rewriting.
    fails("cancel-term", |[a, b]: [f32; 2]| (a + b) + a);
    fails("error-of-sum-f64", |[a, b]: [f64; 2]| -(a - ((a + b) - b)));
    fails("contract", |[a, b, c]: [f32; 3]| a * b - c);
    fails("factor-out-f64", |[a, b, c]: [f64; 3]| b * (a + c));
    fails("multiply-by-zero", |[a]: [f32; 1]| a);
    fails("negate-difference", |[a, b]: [f32; 2]| a - b);
    fails("sum", |[a, b]: [f32; 2]| (a + b).next_up().next_up());
    fails("divide", |[a, b]: [f32; 2]| f32::from_bits((a / b).to_bits() + 4));
    fails("root", |[a]: [f32; 1]| f32::from_bits(a.sqrt().to_bits() + 12));
    fails("root-f64", |[a]: [f64; 1]| f64::from((a as f32).sqrt()));
    fails("f64-to-f32", |[a]: [f64; 1]| (a as f32).next_up().next_up());
    fails("compare-nan", |[_, _]: [f32; 2]| 64_u32);
    fails("select", |[a, b, c]: [f32; 3]| a + f32::from(u8::from(c < 0.0)) * (b - a));
    fails("subnormal-copy", |[a]: [f32; 1]| if a.is_subnormal() { 0.0 } else { a });
    fails("subnormal-sum", |[a, b]: [f32; 2]| a - b);
    fails("shift-left", |[a, b]: [u32; 2]| a.checked_shl(b).unwrap_or(0));
    fails("loop-limit", |[a]: [u32; 1]| (0..a.min(65_535)).fold(1_u32, |sum, i| (sum ^ i).wrapping_mul(0x0100_0193)));
    // Results as written and rewritten do not mix.
    let mixed = |[a, b]: [f32; 2]| if a < b { (a + b) - a } else { b };
    fails("cancel-term", mixed);
}

#[test]
fn the_report_to_mesa_contains_its_program() {
    let page = std::fs::read_to_string(project_root().join("docs/upstream/lavapipe-loop-limit.md"));
    let probe = all().into_iter().find(|probe| probe.name == "loop-limit").expect("it exists");
    let program: String = probe.text.lines().map(|line| format!("    {line}\n")).collect();
    assert!(page.expect("it is committed").contains(&program), "{program}");
}
