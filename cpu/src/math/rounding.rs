//! The traits of arithmetic whose rounding errors are known. Formulas with an error bound are generic over them.

use crate::math::real::Real;

/// Arithmetic of known precision: that of f64, unless it states another.
pub trait Rounding: Real {
    /// The largest relative error of an operation.
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
    /// How many times larger than in f64 the condition number of an accepted root may be.
    const LENIENCE: f64 = 1.0;
}

/// Fused multiply-add.
pub trait MulAdd: Rounding {
    /// `self * factor + term`, rounded once. Code that is compiled for a machine without the instruction calls a
    /// function instead, just as exact.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// `self * factor + term`, rounded once or twice, whichever is faster: for tests whose margins cover both.
    #[inline(always)]
    fn mul_add_loosely(self, factor: Self, term: Self) -> Self {
        self.mul_add(factor, term)
    }
}

impl Rounding for f64 {}

impl MulAdd for f64 {
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self.mul_add(factor, term)
    }
    // A machine without fused multiply-add would call a function, which is slow.
    #[inline(always)]
    fn mul_add_loosely(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}
