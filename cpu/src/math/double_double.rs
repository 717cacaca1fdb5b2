//! Numbers of about 106 bits. Each is the unevaluated sum of two `f64`. The magnitude of the second is at most
//! half a unit in the last place of the first.
//!
//! Sum, product and quotient, with their bounds, are those of Joldes, Muller and Popescu, "Tight and rigorous error
//! bounds for basic building blocks of double-word arithmetic", ACM TOMS 44 (2017). Muller and Rideau proved the bounds
//! with Coq ("Formalization of double-word arithmetic", ACM TOMS 48, 2022). The square root is that of Lefevre,
//! Louvet, Muller, Picot and Rideau, "Accurate calculation of Euclidean norms using double-word arithmetic", ACM TOMS
//! 49 (2023). With u = 2^-53 the relative errors are at most 3u^2 for a sum (also under cancellation), 4u^2 for a
//! product, 15u^2 for a quotient and 25/8 u^2 for a square root.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::{error_free::two_product, error_free::two_sum, real::Real};

/// The number `high + low`. The magnitude of `low` is at most half a unit in the last place of `high`. Comparisons rely
/// on this, and all operations of this type keep it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    /// The f64 nearest to the number.
    pub high: f64,
    /// The number minus `high`.
    pub low: f64,
}

/// Returns `a + b` without a rounding error, if `|a| >= |b|` or `a = 0` (Dekker).
#[inline(always)]
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    DoubleDouble { high, low: b - (high - a) }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let sum = fast_two_sum(high, high_error + low);
        fast_two_sum(sum.high, sum.low + low_error)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.high, other.high);
        let low = self.high.mul_add(other.low, self.low * other.low);
        let low = self.low.mul_add(other.high, low);
        fast_two_sum(product, error + low)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisor: Self) -> Self {
        let high = self.high / divisor.high;
        let (product, error) = two_product(divisor.high, high);
        let product = fast_two_sum(product, divisor.low.mul_add(high, error));
        let remainder = (self.high - product.high) + (self.low - product.low);
        fast_two_sum(high, remainder / divisor.high)
    }
}

impl Real for DoubleDouble {
    type Mask = bool;

    #[inline(always)]
    fn of(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let high = self.high.sqrt();
        let remainder = (-high).mul_add(high, self.high) + self.low;
        fast_two_sum(high, remainder / (high + high))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self.high < other.high || (self.high == other.high && self.low < other.low)
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> bool {
        self.high < other.high || (self.high == other.high && self.low <= other.low)
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(high: f64, low: f64) -> DoubleDouble {
        fast_two_sum(high, low)
    }

    #[test]
    fn what_is_below_the_last_place_survives_cancellation() {
        let tiny = 2.0_f64.powi(-90);
        assert_eq!(number(1.0, tiny) - DoubleDouble::of(1.0), DoubleDouble::of(tiny));
        assert_eq!(number(1e16, 1.0) * DoubleDouble::of(3.0) - DoubleDouble::of(3e16), DoubleDouble::of(3.0));
    }

    #[test]
    fn quotients_and_roots_undo_products() {
        for value in [number(2.0, 1e-17), number(3e100, 1e83), number(7e-120, 0.0)] {
            let (product, square) = (value * DoubleDouble::of(5.0), value * value);
            for (actual, expected) in [(product / DoubleDouble::of(5.0), value), (square.sqrt(), value)] {
                let error = (actual - expected).abs().high / expected.high;
                assert!(error <= 20.0 * 2.0_f64.powi(-106), "{value:?}: {error:e}");
            }
        }
        assert_eq!(DoubleDouble::of(0.0).sqrt(), DoubleDouble::of(0.0));
        assert!(DoubleDouble::of(-1.0).sqrt().high.is_nan());
    }

    #[test]
    fn comparisons_see_the_low_part() {
        let (one, more) = (DoubleDouble::of(1.0), number(1.0, 1e-30));
        assert!(one.less(more) && !more.less(one) && !one.less(one));
        assert!(one.less_equal(one) && one.less_equal(more) && !more.less_equal(one));
        assert!((-more).less(-one) && (-more).abs() == more);
        let nan = DoubleDouble::of(f64::NAN);
        assert!(!nan.less(one) && !nan.less_equal(nan));
    }
}
