//! Compares the exact intersections in WGSL with `cpu::exact`, step by step and bit by bit.
//!
//! The programs intersect by a plain formula with an error bound, then by a compensated formula, and at last in dyadic
//! arithmetic. The first two steps exist in WGSL too (`shaders/wgsl/exact`). A kernel computes both for every ray, also
//! if the first one is certain. If both are uncertain, the kernel reports that, and the comparison demands that exactly
//! these rays are uncertain in Rust.
//!
//! The comparison needs f64: in f32 the constants of the bounds have no proof.

use gpu_check::methods;

use super::{formulas, rays};
use crate::kernels::row_kernel::RowKernel;

/// A kernel over f64, and its cases. The first number is how many random cases of each kind there are, beside the edge
/// cases; the second is a seed. The kinds are the random cases of the plain formula, the regimes of `stability`, and
/// [`compensated_cylinders`].
pub type ExactKernel = (RowKernel<f64>, fn(usize, u64) -> Vec<f64>);

/// Names of the numbers of an `ExactReport`, in the order of `kernels/exact_report.wgsl`.
const REPORT: &[&str] =
    &["step", "some", "lambda", "part", "plain", "plain lambda", "compensated", "compensated lambda"];

/// The product and sum with one rounding (fused multiply-add), and products with their rounding errors.
pub const MUL_ADD: ExactKernel =
    (kernel("kernels/mul_add", 3, &["product", "error", "mul_add"], formulas::mul_add), rays::products);
/// The exact intersection of a ray with a sphere.
pub const SPHERE: ExactKernel = (kernel("kernels/exact_sphere", 10, REPORT, formulas::sphere), rays::spheres);
/// The exact intersection of a ray with a cylinder.
pub const CYLINDER: ExactKernel = (kernel("kernels/exact_cylinder", 13, REPORT, formulas::cylinder), rays::cylinders);
/// Which of two spheres a ray hits first.
pub const ORDER: ExactKernel = (kernel("kernels/exact_order", 14, &["order"], formulas::order), rays::two_spheres);

/// All exact kernels.
pub const EXACT_KERNELS: [ExactKernel; 4] = [MUL_ADD, SPHERE, CYLINDER, ORDER];

const fn kernel(
    module: &'static str,
    inputs: usize,
    outputs: &'static [&'static str],
    formula: fn(&[f64], &mut [f64]),
) -> RowKernel<f64> {
    RowKernel { module, inputs, outputs, formula }
}

/// Returns the name and `count` cases of each kind of cylinders that the compensated formulas serve: long, wide and far
/// ones. The cases of [`CYLINDER`] have these cases too, for equal arguments.
pub fn compensated_cylinders(count: usize, seed: u64) -> impl Iterator<Item = (&'static str, Vec<f64>)> {
    rays::COMPENSATED.iter().map(move |regime| (regime.name, methods::rows(&regime.cases(seed, count))))
}
