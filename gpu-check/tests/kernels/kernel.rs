//! A kernel, its twin in Rust, and the cases for which both are compared, bit by bit.
//!
//! A case is a row of numbers, and so is the result of a case. Flags are stored as numbers too, so that one function
//! can compare all kernels.

use std::fmt;

use gpu_check::first_difference::twins::{Numbers, Twin};
use gpu_check::reader::Reader;
use gpu_check::rows::results;
use gpu_check::{Error, Float, Gpu, Pipeline};
use shaders::Library;

/// Largest number of differing cases that a tally stores as text.
const SHOWN: usize = 5;

/// A kernel that turns each case, a row of inputs, into a row of outputs.
#[derive(Clone, Copy, Debug)]
pub struct Kernel<T> {
    /// The name of the kernel's module in `shaders`.
    pub module: &'static str,
    /// Number of numbers in a case, which are the inputs of the twin.
    pub inputs: usize,
    /// Computes the result in Rust.
    pub twin: Twin<T>,
    /// Returns the edge cases, and this number of random cases, row after row. At an edge case a decision changes, or a
    /// number overflows or underflows. Equal seeds give equal cases.
    pub cases: fn(usize, u64) -> Vec<f64>,
}

impl<T: Float> Kernel<T> {
    /// Returns the cases of [`Kernel::cases`] in this precision.
    pub fn rows(&self, count: usize, seed: u64) -> Vec<T> {
        (self.cases)(count, seed).into_iter().map(T::of).collect()
    }

    /// Compiles the kernel from `library`.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn compile(&self, gpu: &Gpu, library: &Library) -> Result<Pipeline, Error> {
        Pipeline::new(gpu, &library.compose(self.module, T::PRECISION)?, &[])
    }

    /// Returns the result of one case by the twin.
    pub fn expected(&self, case: &[T]) -> Numbers<T> {
        (self.twin)(None, Reader(case)).expect("the twin needs no picture")
    }

    /// Runs the kernel for `cases`, and compares its results with those of the twin.
    ///
    /// # Errors
    /// The errors of [`Pipeline::run`].
    pub fn check(&self, gpu: &Gpu, pipeline: &Pipeline, cases: &[T]) -> Result<Tally, Error> {
        compare(gpu, pipeline, (self.module, self.inputs), cases, |case| self.expected(case))
    }
}

/// The result of a comparison: the numbers of compared and of differing cases.
#[derive(Clone, Debug)]
pub struct Tally {
    /// The name of what was compared.
    pub name: &'static str,
    /// Number of compared cases.
    pub cases: usize,
    /// Number of compared results.
    pub numbers: usize,
    /// Number of cases whose first result is neither zero nor infinite nor NaN. For kernels that distinguish hits from
    /// misses, these are the hits.
    pub ordinary: usize,
    /// Number of cases for which WGSL and Rust have different results.
    pub differing: usize,
    /// Texts that describe the first differing cases, at most five.
    shown: Vec<String>,
}

/// Runs a kernel for `cases`, rows of `inputs` numbers, and compares its results with the expected ones. `name` is for
/// messages.
///
/// # Errors
/// The errors of [`Pipeline::run`].
pub fn compare<T: Float>(
    gpu: &Gpu,
    pipeline: &Pipeline,
    (name, inputs): (&'static str, usize),
    cases: &[T],
    expected: impl Fn(&[T]) -> Numbers<T>,
) -> Result<Tally, Error> {
    let outputs = expected(&cases[..inputs]).len();
    let (results, _) = results(gpu, pipeline, [inputs, outputs], cases)?;
    let mut tally = Tally { name, cases: 0, numbers: 0, ordinary: 0, differing: 0, shown: Vec::new() };
    for (case, actual) in cases.chunks(inputs).zip(results.chunks(outputs)) {
        let expected = expected(case);
        tally.cases += 1;
        tally.numbers += actual.len();
        tally.ordinary +=
            usize::from(expected[0].is_some_and(|number| number.wide() != 0.0 && number.wide().is_finite()));
        let is_same = |(expected, actual): (&Option<T>, &T)| expected.is_none_or(|expected| expected.same(*actual));
        if !expected.iter().zip(actual).all(is_same) {
            tally.differing += 1;
            if tally.shown.len() < SHOWN {
                tally.shown.push(format!("case {case:?}: {expected:?} in Rust, {actual:?} in WGSL"));
            }
        }
    }
    Ok(tally)
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, cases, numbers, ordinary, differing, shown } = self;
        write!(f, "{name}: {cases} cases, {numbers} numbers, {ordinary} hits or ordinary first numbers, ")?;
        write!(f, "{differing} cases differ")?;
        shown.iter().try_for_each(|shown| write!(f, "\n{shown}"))
    }
}
