//! The number types that kernels and their formulas in Rust calculate in.

use std::fmt::{Debug, Display};

use cpu::internals::math::real::Real;
use shaders::Precision;

use crate::Kernel;

/// `f32` or `f64`: a number type of formulas whose values can be put into buffers.
pub trait Float: Real<Mask = bool> + bytemuck::Pod + PartialOrd + Display + Debug + Send + Sync {
    /// The precision of a composition with this type as `real`.
    const PRECISION: Precision;

    /// The bits of the number; those of an `f32` in the lower half.
    fn bits(self) -> u64;

    /// The same value as `f64`, exactly.
    fn wide(self) -> f64;

    /// The kernel's formula in this precision.
    fn formula(kernel: &Kernel) -> fn(&[Self], &mut [Self]);

    /// Whether both have the same bits, or both are NaN. IEEE 754 leaves open which of the many bit patterns of NaN an
    /// operation returns.
    fn same(self, other: Self) -> bool {
        self.bits() == other.bits() || (self.wide().is_nan() && other.wide().is_nan())
    }
}

impl Float for f32 {
    const PRECISION: Precision = Precision::F32;

    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }

    fn wide(self) -> f64 {
        f64::from(self)
    }

    fn formula(kernel: &Kernel) -> fn(&[Self], &mut [Self]) {
        kernel.single
    }
}

impl Float for f64 {
    const PRECISION: Precision = Precision::F64;

    fn bits(self) -> u64 {
        self.to_bits()
    }

    fn wide(self) -> f64 {
        self
    }

    fn formula(kernel: &Kernel) -> fn(&[Self], &mut [Self]) {
        kernel.wide
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_of_different_sign_differ_and_nans_do_not() {
        assert!(!0.0_f64.same(-0.0) && !1.0_f32.same(1.0_f32.next_up()));
        assert!(f64::NAN.same(-f64::NAN) && !f64::NAN.same(1.0) && 1.5_f32.same(1.5));
    }
}
