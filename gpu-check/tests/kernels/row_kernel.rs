//! Compares a kernel's results with those of its formula in Rust, bit by bit.

use std::fmt;

use gpu_check::rows::results;
use gpu_check::{Error, Float, Gpu, Pipeline};
use shaders::Library;

/// Largest number of differing cases that a tally stores as text.
const SHOWN: usize = 5;

/// The result of a comparison: the numbers of compared and of differing cases.
#[derive(Clone, Debug)]
pub struct Tally {
    /// The name of the kernel's module.
    pub kernel: &'static str,
    /// Number of compared cases.
    pub cases: usize,
    /// Number of compared results.
    pub numbers: usize,
    /// Number of cases whose first result is not zero. For kernels that distinguish hits from misses, these are the
    /// hits.
    pub nonzero: usize,
    /// Number of cases in which at least one result differs.
    pub differing: usize,
    /// The index of the first case in which a result differs.
    pub first: Option<usize>,
    /// Texts that describe the first differing cases, at most five.
    pub shown: Vec<String>,
}

/// A kernel that turns each case, a row of inputs, into a row of outputs, and its formula in Rust, both over `T`.
#[derive(Clone, Copy, Debug)]
pub struct RowKernel<T> {
    /// The name of the kernel's module in `shaders`.
    pub module: &'static str,
    /// Number of numbers in a case, which are the inputs of the formula.
    pub inputs: usize,
    /// Names of the numbers in a result, which are the outputs of the formula.
    pub outputs: &'static [&'static str],
    /// Computes the formula. Reads a case, and writes its result.
    pub formula: fn(&[T], &mut [T]),
}

impl<T: Float> RowKernel<T> {
    /// Compiles the kernel from `library`.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn compile(&self, gpu: &Gpu, library: &Library) -> Result<Pipeline, Error> {
        Pipeline::new(gpu, &library.compose(self.module, T::PRECISION)?, &[])
    }

    /// Returns the result of one case by the formula in Rust.
    #[must_use]
    pub fn expected(&self, case: &[T]) -> Vec<T> {
        let mut result = vec![T::of(0.0); self.outputs.len()];
        (self.formula)(case, &mut result);
        result
    }

    /// Runs the kernel for `cases`, and compares its results with those of the formula in Rust.
    ///
    /// # Errors
    /// The errors of [`Pipeline::run`].
    pub fn check(&self, gpu: &Gpu, pipeline: &Pipeline, cases: &[T]) -> Result<Tally, Error> {
        let (results, _) = results(gpu, pipeline, [self.inputs, self.outputs.len()], cases)?;
        let (kernel, names) = (self.module, self.outputs);
        let mut tally =
            Tally { kernel, cases: 0, numbers: 0, nonzero: 0, differing: 0, first: None, shown: Vec::new() };
        for (case, actual) in cases.chunks(self.inputs).zip(results.chunks(names.len())) {
            let expected = self.expected(case);
            tally.cases += 1;
            tally.numbers += actual.len();
            tally.nonzero += usize::from(expected[0].wide() != 0.0);
            if expected.iter().zip(actual).any(|(expected, actual)| !expected.same(*actual)) {
                tally.differing += 1;
                tally.first.get_or_insert(tally.cases - 1);
                if tally.shown.len() < SHOWN {
                    tally.shown.push(show(names, case, &expected, actual));
                }
            }
        }
        Ok(tally)
    }
}

/// Returns a text with the inputs of the case and the results that differ.
fn show<T: Float>(names: &[&str], case: &[T], expected: &[T], actual: &[T]) -> String {
    let mut text = format!("case {case:?}");
    for ((name, expected), actual) in names.iter().zip(expected).zip(actual) {
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
