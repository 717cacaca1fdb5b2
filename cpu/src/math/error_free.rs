//! Sums and products with their rounding errors. Each rounding error is itself a number of the arithmetic, so the pair
//! is exact.

use crate::math::rounding::{MulAdd, Rounding};

/// `a + b` and its rounding error (Knuth).
#[inline(always)]
pub fn two_sum<T: Rounding>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// `a b` and its rounding error.
#[inline(always)]
pub fn two_product<T: MulAdd>(a: T, b: T) -> (T, T) {
    let product = a * b;
    (product, a.mul_add(b, -product))
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
