//! Sums and products with their rounding errors. A rounding error is itself a floating-point number. So result and
//! rounding error together are exact, short of overflow and underflow.

use crate::math::rounding::{MulAdd, Rounding};

/// Returns the rounded `a + b` and its rounding error: the exact sum minus the rounded one (Knuth).
#[inline(always)]
pub fn two_sum<T: Rounding>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// Returns the rounded `a b` and its rounding error: the exact product minus the rounded one.
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
