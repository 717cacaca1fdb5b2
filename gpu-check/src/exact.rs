//! Compares the exact intersections in WGSL with `cpu::exact`, step by step and bit by bit.
//!
//! The programs intersect by a plain formula with an error bound, then by a compensated formula, and at last in dyadic
//! arithmetic. The first two steps exist in WGSL too (`shaders/wgsl/exact`). A kernel computes both for every ray, also
//! if the first one is certain. If both are uncertain, the kernel reports that, and the comparison demands that exactly
//! these rays are uncertain in Rust.
//!
//! The comparison needs f64: in f32 the constants of the bounds have no proof.

mod formulas;
mod rays;

use shaders::Library;

use crate::check::{Tally, compare_rows, rows_of_results};
use crate::{Error, Float, Gpu, Pipeline, methods};

/// A kernel over f64, with the function of `cpu` that must give its bits. It is like [`crate::Kernel`], whose formulas
/// exist in every precision.
#[derive(Clone, Copy, Debug)]
pub struct ExactKernel {
    /// The name of the kernel's module in `shaders`.
    pub module: &'static str,
    /// Number of numbers in a case, which are the inputs.
    pub inputs: usize,
    /// Names of the numbers in a result, which are the outputs.
    pub outputs: &'static [&'static str],
    formula: fn(&[f64], &mut [f64]),
    cases: fn(usize, u64) -> Vec<f64>,
}

/// Names of the numbers of an `ExactReport`, in the order of `kernels/exact_report.wgsl`.
const REPORT: &[&str] =
    &["step", "some", "lambda", "part", "plain", "plain lambda", "compensated", "compensated lambda"];

/// The multiply-add that rounds once, and the products with their rounding errors.
pub const MUL_ADD: ExactKernel = ExactKernel {
    module: "kernels/mul_add",
    inputs: 3,
    outputs: &["product", "error", "mul_add"],
    formula: formulas::mul_add,
    cases: rays::products,
};
/// The exact intersection of a ray with a sphere.
pub const SPHERE: ExactKernel = ExactKernel {
    module: "kernels/exact_sphere",
    inputs: 10,
    outputs: REPORT,
    formula: formulas::sphere,
    cases: rays::spheres,
};
/// The exact intersection of a ray with a cylinder.
pub const CYLINDER: ExactKernel = ExactKernel {
    module: "kernels/exact_cylinder",
    inputs: 13,
    outputs: REPORT,
    formula: formulas::cylinder,
    cases: rays::cylinders,
};

/// Which of two spheres a ray hits first.
pub const ORDER: ExactKernel = ExactKernel {
    module: "kernels/exact_order",
    inputs: 14,
    outputs: &["order"],
    formula: formulas::order,
    cases: rays::two_spheres,
};

/// Returns the name and `count` cases of each kind of cylinders that the compensated formulas serve: long, wide and far
/// ones. [`ExactKernel::cases`] of [`CYLINDER`] has these cases too, for equal arguments.
pub fn compensated_cylinders(count: usize, seed: u64) -> impl Iterator<Item = (&'static str, Vec<f64>)> {
    rays::COMPENSATED.iter().map(move |regime| (regime.name, methods::rows(&regime.cases(seed, count))))
}

/// All exact kernels.
pub const EXACT_KERNELS: [ExactKernel; 4] = [MUL_ADD, SPHERE, CYLINDER, ORDER];

impl ExactKernel {
    /// Returns edge cases, and `count` random cases of each kind. The kinds are the random cases of the plain formula,
    /// the regimes of `stability`, and [`compensated_cylinders`]. Equal seeds give equal cases.
    #[must_use]
    pub fn cases(&self, count: usize, seed: u64) -> Vec<f64> {
        (self.cases)(count, seed)
    }

    /// Compiles the kernel from `library`, in f64.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn compile(&self, gpu: &Gpu, library: &Library) -> Result<Pipeline, Error> {
        Pipeline::new(gpu, &library.compose(self.module, f64::PRECISION)?, &[])
    }

    /// Returns the result of one case by the functions of `cpu`.
    #[must_use]
    pub fn expected(&self, case: &[f64]) -> Vec<f64> {
        let mut result = vec![0.0; self.outputs.len()];
        (self.formula)(case, &mut result);
        result
    }

    /// Runs the kernel for `cases`, and compares its results with those of `cpu`.
    ///
    /// # Errors
    /// The errors of [`Pipeline::run`].
    pub fn check(&self, gpu: &Gpu, pipeline: &Pipeline, cases: &[f64]) -> Result<Tally, Error> {
        let (results, _) = rows_of_results(gpu, pipeline, [self.inputs, self.outputs.len()], cases)?;
        Ok(compare_rows(self.module, self.inputs, self.outputs, self.formula, cases, &results))
    }
}
