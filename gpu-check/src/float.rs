//! The formulas of kernels in each number type.

use crate::Kernel;
pub use twin::Float;

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
