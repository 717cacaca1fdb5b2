//! Sums and products with their rounding errors: what they are built of rounds once, so nothing is lost.

use crate::math::rounding::Rounding;

/// Arithmetic with a product and a sum that are rounded once, together.
pub trait Fused: Rounding {
    /// `self * factor + term`, rounded once. Code that is compiled for a machine without the instruction calls a
    /// function instead, just as exact.
    fn fused(self, factor: Self, term: Self) -> Self;
}

impl Fused for f64 {
    #[inline(always)]
    fn fused(self, factor: Self, term: Self) -> Self {
        self.mul_add(factor, term)
    }
}

/// `a + b` and its rounding error (Knuth).
#[inline(always)]
#[must_use]
pub fn two_sum<T: Rounding>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// `a b` and its rounding error.
#[inline(always)]
#[must_use]
pub fn two_product<T: Fused>(a: T, b: T) -> (T, T) {
    let product = a * b;
    (product, a.fused(b, -product))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0));
        assert_eq!(two_sum(1.0, 1e16), (1e16, 1.0));
        let x = 1.0 + f64::EPSILON;
        assert_eq!(two_product(x, x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
    }
}
