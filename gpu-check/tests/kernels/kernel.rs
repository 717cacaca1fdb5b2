//! A kernel: a formula in Rust, its module in WGSL, and the cases for which both are compared.
//!
//! A case is a row of numbers, and so is the result of a case. Flags are stored as numbers too, so that one function
//! can compare all kernels.

use cpu::internals::math::real::Real;
use cpu::internals::sampling::uniform::Uniform;
use gpu_check::Float;
use gpu_check::reader::Reader;

use super::row_kernel::RowKernel;
use super::running::Running;
use super::special::Row;

/// A formula of `cpu`, and the kernel of `shaders` that should give its bits.
pub trait Formula {
    /// The name of the kernel's module.
    const MODULE: &'static str;
    /// Number of numbers in a case, which are the inputs of the formula.
    const INPUTS: usize;
    /// Names of the numbers in a result, which are the outputs of the formula.
    const OUTPUTS: &'static [&'static str];

    /// Computes the formula with the code of `cpu`. Reads the inputs from `case` and writes the outputs to `result`.
    fn evaluate<T: Real<Mask = bool>>(case: Reader<'_, T>, result: &mut [T]);
    /// Appends the edge cases to `rows`. At these a decision changes, or a number overflows or underflows.
    fn edges(rows: &mut Row);
    /// Appends random inputs of one case, from the generator `draws`, to `row`.
    fn random(draws: &mut Uniform, row: &mut Row);
}

/// A [`Formula`] as a value, so that an array can list kernels.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// The name of the kernel's module in `shaders`.
    pub module: &'static str,
    /// Number of numbers in a case, which are the inputs of the formula.
    pub inputs: usize,
    /// Names of the numbers in a result, which are the outputs of the formula.
    pub outputs: &'static [&'static str],
    wide: fn(&[f64], &mut [f64]),
    single: fn(&[f32], &mut [f32]),
    /// Computes the formula with a bound of the error that `f32` has.
    pub running: fn(&[Running], &mut [Running]),
    edges: fn(&mut Row),
    random: fn(&mut Uniform, &mut Row),
}

impl Kernel {
    /// Returns the kernel of the formula `F`.
    #[must_use]
    pub const fn of<F: Formula>() -> Self {
        Self {
            module: F::MODULE,
            inputs: F::INPUTS,
            outputs: F::OUTPUTS,
            wide: |case, result| F::evaluate(Reader(case), result),
            single: |case, result| F::evaluate(Reader(case), result),
            running: |case, result| F::evaluate(Reader(case), result),
            edges: F::edges,
            random: F::random,
        }
    }

    /// Returns the kernel in the precision of `T`.
    #[must_use]
    pub fn rows<T: Formulas>(&self) -> RowKernel<T> {
        let Self { module, inputs, outputs, .. } = *self;
        RowKernel { module, inputs, outputs, formula: T::formula(self) }
    }

    /// Returns the inputs of all edge cases: a row of [`Self::inputs`] numbers for each case.
    #[must_use]
    pub fn edge_cases<T: Float>(&self) -> Vec<T> {
        let mut rows = Row::default();
        (self.edges)(&mut rows);
        rows.0.into_iter().map(T::of).collect()
    }

    /// Returns `count` random cases, row after row. Equal seeds give equal cases.
    #[must_use]
    pub fn random_cases<T: Float>(&self, count: usize, seed: u64) -> Vec<T> {
        let (mut draws, mut rows) = (Uniform::new(seed), Row::default());
        for _ in 0..count {
            (self.random)(&mut draws, &mut rows);
        }
        assert_eq!(rows.0.len(), count * self.inputs, "{}", self.module);
        rows.0.into_iter().map(T::of).collect()
    }
}

/// A number type in which the formulas of kernels can calculate.
pub trait Formulas: Float {
    /// Returns the function that computes the kernel's formula in this precision.
    fn formula(kernel: &Kernel) -> fn(&[Self], &mut [Self]);
}

impl Formulas for f32 {
    fn formula(kernel: &Kernel) -> fn(&[Self], &mut [Self]) {
        kernel.single
    }
}

impl Formulas for f64 {
    fn formula(kernel: &Kernel) -> fn(&[Self], &mut [Self]) {
        kernel.wide
    }
}
