//! The trait of arithmetic whose rounding errors are known. Formulas with an error bound are generic over it.

use crate::math::real::Real;

/// Arithmetic with the rounding errors of `f64`: `f64` itself, and its lanes. The exact intersections need this trait,
/// while the plain formulas need only [`Real`].
pub trait Rounding: Real {
    /// The largest relative error of one operation, `u` in the error bounds.
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

    /// Returns `self * factor + term`, rounded once. In code that is compiled for a machine without the instruction, a
    /// library function computes the same bits.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Returns `self * factor + term`, rounded once or twice, whichever is faster on the machine. Only tests whose
    /// margins cover both may use this function.
    #[inline(always)]
    fn mul_add_loosely(self, factor: Self, term: Self) -> Self {
        self.mul_add(factor, term)
    }
}

impl Rounding for f64 {
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
