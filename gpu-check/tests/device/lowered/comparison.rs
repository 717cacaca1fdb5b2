//! Compares operations on f64 that integers calculate (`shaders::lower`) with Rust's f64, bit by bit.
//!
//! - [`operations`] lists the operations: each in WGSL, and in Rust;
//! - [`operands`] draws operands that are hard for an implementation;
//! - [`mutants`] are deliberate errors of the arithmetic, which the comparison must notice.

use std::fmt;
use std::time::Duration;

use gpu_check::pipeline::Content;
use gpu_check::{Error, Gpu, Pipeline};
use shaders::lower::Arithmetic;
use shaders::{Composition, Precision};

use super::operands::{Operands, draw};
use super::operations::{Operation, Outcome};

/// Largest number of cases in one run: one workgroup less than a run may have, in a buffer of 96 MiB.
const BATCH: usize = 3 << 20;

/// The result of a comparison of one operation.
#[derive(Clone, Debug)]
pub struct Tally {
    /// The operation in WGSL.
    pub operation: &'static str,
    /// Number of compared cases.
    pub cases: usize,
    /// Number of cases whose results differ.
    pub differing: usize,
    /// Number of cases whose result is a number other than zero, infinity and NaN.
    pub ordinary: usize,
    /// Texts that describe the first differing cases, at most three.
    pub shown: Vec<String>,
    /// The time of the device, without the transfers.
    pub time: Duration,
}

/// Returns the text of a kernel that calculates `operation` for every case, in f64.
pub fn kernel(operation: &Operation) -> String {
    let result = match operation.outcome {
        Outcome::Number => "f64",
        Outcome::Word => "u32",
    };
    format!(
        "struct Case {{ a: f64, b: f64, c: f64, word: u32, unused: u32 }}\n\
         @group(0) @binding(0) var<storage, read> cases: array<Case>;\n\
         @group(0) @binding(1) var<storage, read_write> results: array<{result}>;\n\
         @compute @workgroup_size(64)\n\
         fn operation(@builtin(global_invocation_id) id: vec3<u32>) {{\n    \
         if id.x >= arrayLength(&cases) {{ return; }}\n    \
         let a = cases[id.x].a;\n    let b = cases[id.x].b;\n    let c = cases[id.x].c;\n    \
         let word = cases[id.x].word;\n    \
         results[id.x] = {};\n}}\n",
        operation.wgsl
    )
}

/// Compiles the kernel of `operation` with `arithmetic` in the place of f64. If `arithmetic` is `None`, the device's
/// f64 is used.
///
/// # Errors
/// The errors of lowering and of [`Pipeline::new`].
pub fn compile(gpu: &Gpu, operation: &Operation, arithmetic: Option<&Arithmetic>) -> Result<Pipeline, Error> {
    let composition = Composition::of_file(operation.wgsl, kernel(operation), Precision::F64);
    let composition = match arithmetic {
        Some(arithmetic) => composition.lowered(arithmetic)?,
        None => composition,
    };
    Pipeline::new(gpu, &composition, &[])
}

/// Runs the kernel of `operation` on a batch of operands, and adds the results to `tally`.
///
/// # Errors
/// The errors of [`Pipeline::run`].
pub fn compare(
    gpu: &Gpu,
    pipeline: &Pipeline,
    operation: &Operation,
    cases: &[Operands],
    tally: &mut Tally,
) -> Result<(), Error> {
    let output = (cases.len() * operation.outcome.size()) as u64;
    let packed: Vec<_> = cases.iter().map(Operands::packed).collect();
    let contents = [Content::Input(bytemuck::cast_slice(&packed)), Content::Output(output)];
    let run = pipeline.run(gpu, &contents, cases.len() as u64)?;
    tally.time += run.time;
    let bytes = run.outputs.concat();
    for (case, actual) in cases.iter().zip(bytes.chunks(operation.outcome.size())) {
        tally.add(operation, case, actual);
    }
    Ok(())
}

/// Draws `count` cases with the seed `seed`, and compares the results of `operation` for them.
///
/// # Errors
/// The errors of [`compile`] and [`compare`].
pub fn check(gpu: &Gpu, operation: &Operation, count: usize, seed: u64) -> Result<Tally, Error> {
    let pipeline = compile(gpu, operation, Some(&Arithmetic::standard()))?;
    let mut tally = Tally::new(operation);
    for first in (0..count).step_by(BATCH) {
        let cases: Vec<_> = (first..count.min(first + BATCH)).map(|index| draw(seed, index as u64)).collect();
        compare(gpu, &pipeline, operation, &cases, &mut tally)?;
    }
    Ok(tally)
}

impl Tally {
    /// Returns the comparison of `operation` without any case.
    pub fn new(operation: &Operation) -> Self {
        let (shown, time) = (Vec::new(), Duration::ZERO);
        Self { operation: operation.wgsl, cases: 0, differing: 0, ordinary: 0, shown, time }
    }

    /// Adds one case with the bytes of its result.
    pub fn add(&mut self, operation: &Operation, case: &Operands, actual: &[u8]) {
        let expected = (operation.truth)(case);
        let mut bytes = [0; 8];
        bytes[..actual.len()].copy_from_slice(actual);
        let actual = u64::from_le_bytes(bytes);
        self.cases += 1;
        let is_number = operation.outcome == Outcome::Number;
        let number = f64::from_bits(expected);
        self.ordinary += usize::from(!is_number || (number.is_finite() && number != 0.0));
        let are_nan = match operation.outcome {
            Outcome::Number => number.is_nan() && f64::from_bits(actual).is_nan(),
            Outcome::Word => {
                let nan = |bits: u64| f32::from_bits(bits as u32).is_nan();
                operation.is_single && nan(expected) && nan(actual)
            }
        };
        if expected != actual && !are_nan {
            self.differing += 1;
            if self.shown.len() < 3 {
                self.shown.push(format!("{case:?}: {expected:#x} in Rust, {actual:#x} by integers"));
            }
        }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { operation, cases, differing, ordinary, shown, time } = self;
        write!(f, "{operation}: {cases} cases in {time:.1?}, {ordinary} ordinary, {differing} differ")?;
        shown.iter().try_for_each(|shown| write!(f, "\n  {shown}"))
    }
}
