//! Compares a kernel's results with its formula in Rust, bit by bit.

use std::fmt;
use std::time::Duration;

use shaders::Library;

use crate::pipeline::{Content, MAX_INVOCATIONS};
use crate::{Error, Float, Gpu, Kernel, Pipeline};

/// Most cases in one run. The limit on a binding may allow fewer.
const BATCH: u64 = 1 << 18;
/// Most differing cases that a tally keeps as text.
const SHOWN: usize = 5;

/// How many results were compared, and those that differ.
#[derive(Clone, Debug)]
pub struct Tally {
    /// The kernel's module.
    pub kernel: &'static str,
    /// Cases compared.
    pub cases: usize,
    /// Numbers compared.
    pub numbers: usize,
    /// Cases whose first number is not zero: the hits, where a kernel tells hits from misses.
    pub nonzero: usize,
    /// Cases in which a number differs.
    pub differing: usize,
    /// The first of the differing cases, as text.
    pub shown: Vec<String>,
}

/// Compiles `kernel` from `library`.
///
/// # Errors
/// As [`Pipeline::new`].
pub fn compile<T: Float>(gpu: &Gpu, library: &Library, kernel: &Kernel) -> Result<Pipeline, Error> {
    Pipeline::new(gpu, &library.compose(kernel.module, T::PRECISION)?, None)
}

/// The kernel's results for `cases`, row after row, in batches that the device can bind.
///
/// # Errors
/// As [`Pipeline::run`].
pub fn results<T: Float>(gpu: &Gpu, pipeline: &Pipeline, kernel: &Kernel, cases: &[T]) -> Result<Vec<T>, Error> {
    Ok(timed_results(gpu, pipeline, kernel, cases)?.0)
}

/// The results as [`results`] gives them, and the time that the device took, without the transfers.
///
/// # Errors
/// As [`Pipeline::run`].
pub fn timed_results<T: Float>(
    gpu: &Gpu,
    pipeline: &Pipeline,
    kernel: &Kernel,
    cases: &[T],
) -> Result<(Vec<T>, Duration), Error> {
    let width = kernel.inputs.max(kernel.outputs.len()) * size_of::<T>();
    let batch = BATCH.min(gpu.binding_limit() / width as u64).min(MAX_INVOCATIONS) as usize;
    let mut results = Vec::with_capacity(cases.len() / kernel.inputs * kernel.outputs.len());
    let mut time = Duration::ZERO;
    for cases in cases.chunks(batch * kernel.inputs) {
        let rows = cases.len() / kernel.inputs;
        let output = (rows * kernel.outputs.len() * size_of::<T>()) as u64;
        let contents = [Content::Input(bytemuck::cast_slice(cases)), Content::Output(output)];
        let run = pipeline.run(gpu, &contents, rows as u64)?;
        time += run.time;
        for bytes in run.outputs {
            results.extend(bytemuck::pod_collect_to_vec::<u8, T>(&bytes));
        }
    }
    Ok((results, time))
}

/// Compares the kernel's results with the formula's.
#[must_use]
pub fn compare<T: Float>(kernel: &Kernel, cases: &[T], results: &[T]) -> Tally {
    let formula = T::formula(kernel);
    let mut expected = vec![T::of(0.0); kernel.outputs.len()];
    let mut tally = Tally { kernel: kernel.module, cases: 0, numbers: 0, nonzero: 0, differing: 0, shown: Vec::new() };
    for (case, actual) in cases.chunks(kernel.inputs).zip(results.chunks(kernel.outputs.len())) {
        formula(case, &mut expected);
        tally.cases += 1;
        tally.numbers += actual.len();
        tally.nonzero += usize::from(expected[0].wide() != 0.0);
        if expected.iter().zip(actual).any(|(expected, actual)| !expected.same(*actual)) {
            tally.differing += 1;
            if tally.shown.len() < SHOWN {
                tally.shown.push(show(kernel, case, &expected, actual));
            }
        }
    }
    tally
}

/// Runs the kernel for `cases` and compares its results with the formula's.
///
/// # Errors
/// As [`Pipeline::run`].
pub fn check<T: Float>(gpu: &Gpu, pipeline: &Pipeline, kernel: &Kernel, cases: &[T]) -> Result<Tally, Error> {
    Ok(compare(kernel, cases, &results(gpu, pipeline, kernel, cases)?))
}

/// The case and the numbers that differ in it, as text.
fn show<T: Float>(kernel: &Kernel, case: &[T], expected: &[T], actual: &[T]) -> String {
    let mut text = format!("case {case:?}");
    for ((name, expected), actual) in kernel.outputs.iter().zip(expected).zip(actual) {
        if !expected.same(*actual) {
            let bits = format!("{:#x} and {:#x}", expected.bits(), actual.bits());
            text.push_str(&format!("\n  {name}: {expected:?} in Rust, {actual:?} in WGSL ({bits})"));
        }
    }
    text
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kernel, cases, numbers, nonzero, differing, .. } = self;
        write!(f, "{kernel}: {cases} cases, {numbers} numbers, {nonzero} hits or first numbers not zero, ")?;
        write!(f, "{differing} cases differ")?;
        self.shown.iter().try_for_each(|shown| write!(f, "\n{shown}"))
    }
}
