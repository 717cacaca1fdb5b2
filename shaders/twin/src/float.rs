//! The number types in which the shaders and their twins calculate.

use std::fmt::{Debug, Display};

use crate::Precision;
use cpu::internals::math::real::Real;

/// A number type whose values can be put into buffers: `f32` or `f64`.
pub trait Float: Real<Mask = bool> + bytemuck::Pod + PartialOrd + Display + Debug + Send + Sync {
    /// The precision of a composition in which `real` stands for this type.
    const PRECISION: Precision;
    /// The largest number below 1, as in `real_f32.wgsl` and `real_f64.wgsl`.
    const BELOW_ONE: Self;

    /// Returns the bits of the number. The bits of an `f32` are in the lower half.
    fn bits(self) -> u64;

    /// Returns the number as `f64`, which is exact.
    fn wide(self) -> f64;

    /// Whether both numbers have the same bits, or both are NaN. All NaN are equal here, because IEEE 754 does not tell
    /// which bit pattern of NaN an operation returns.
    fn same(self, other: Self) -> bool {
        self.bits() == other.bits() || (self.wide().is_nan() && other.wide().is_nan())
    }
}

impl Float for f32 {
    const PRECISION: Precision = Precision::F32;
    const BELOW_ONE: Self = 1.0_f32.next_down();

    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }

    fn wide(self) -> f64 {
        f64::from(self)
    }
}

impl Float for f64 {
    const PRECISION: Precision = Precision::F64;
    const BELOW_ONE: Self = 1.0_f64.next_down();

    fn bits(self) -> u64 {
        self.to_bits()
    }

    fn wide(self) -> f64 {
        self
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
