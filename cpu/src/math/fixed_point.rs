//! Logarithm, sine and cosine with any number of bits, as integers with a bound of their error.
//!
//! A fixed-point number is an integer `n` that stands for `n / 2^bits`. Each operation truncates, so it is wrong by
//! less than one unit `2^-bits`, and `tests/stability/src/proof/series.rs` adds up the errors of a series. The
//! functions are slow: they decide the few roundings for which faster arithmetic is uncertain.

use crate::math::dyadic::{Dyadic, of_finite};
use crate::math::limbs::{product, quotient, shifted, shifted_right, sum};

/// A factor in the error bound of a series. A series that is summed with `bits` fraction bits has an error of at most
/// `UNITS_PER_BIT * bits * 2^-bits` (docs/margins.md). [`logarithm`] adds several series, and returns its own bound.
pub const UNITS_PER_BIT: f64 = 2.0;

/// A fixed-point number, which is not negative. The series are generic over it, so that a proof can bound their errors.
pub trait Units: Sized {
    /// Returns `integer 2^shift` units.
    fn of(integer: u64, shift: usize) -> Self;
    /// Returns the product.
    fn times(&self, other: &Self, bits: usize) -> Self;
    /// Returns the quotient.
    fn over(&self, divisor: u64) -> Self;
    /// Returns the sum.
    fn plus(&self, other: &Self) -> Self;
    /// Whether the number is zero.
    fn is_zero(&self) -> bool;
}

impl Units for Vec<u64> {
    fn of(integer: u64, shift: usize) -> Self {
        shifted(&[integer], shift as u64)
    }
    fn times(&self, other: &Self, bits: usize) -> Self {
        shifted_right(&product(self, other), bits)
    }
    fn over(&self, divisor: u64) -> Self {
        quotient(self, divisor)
    }
    fn plus(&self, other: &Self) -> Self {
        sum(self.clone(), other)
    }
    fn is_zero(&self) -> bool {
        self.is_empty()
    }
}

/// Returns `2 atanh(numerator / denominator) 2^bits`, the logarithm of `(denominator + numerator) / (denominator -
/// numerator)`.
///
/// The quotient `s` must be at most 1/3. The series is `2 (s + s^3 / 3 + s^5 / 5 + ...)`.
pub fn two_atanh<N: Units>(numerator: u64, denominator: u64, bits: usize) -> N {
    debug_assert!(numerator <= denominator / 3);
    let mut power = N::of(numerator, bits).over(denominator);
    let square = power.times(&power, bits);
    let (mut total, mut divisor) = (N::of(0, 0), 1);
    while !power.is_zero() {
        total = total.plus(&power.over(divisor));
        power = power.times(&square, bits);
        divisor += 2;
    }
    total.plus(&total)
}

/// Returns the natural logarithm of `integer 2^exponent`, for a positive integer below 2^62, and the bound of its
/// error.
///
/// With `integer = m 2^k` and `1 <= m < 2` it is `(exponent + k) ln 2 + ln m`.
pub(crate) fn logarithm(integer: u64, exponent: i64, bits: usize) -> (Dyadic, Dyadic) {
    let k = integer.ilog2();
    let (one, power) = (1 << k, exponent + i64::from(k));
    let of_units = |units| Dyadic::of_limbs(units, -(bits as i64));
    let two = of_units(two_atanh(1, 3, bits));
    let mantissa = of_units(two_atanh(integer - one, integer + one, bits));
    let error_bound = (power.unsigned_abs() + 1) as f64 * UNITS_PER_BIT * bits as f64;
    (&(&of_finite(power as f64) * &two) + &mantissa, of_finite(error_bound).times_power_of_two(-(bits as i64)))
}

/// Returns sine and cosine of `integer 2^exponent`, and the bound of the error of each. The angle must be from 0 to
/// 1.58, and a multiple of `2^-bits`.
pub(crate) fn sine_and_cosine(integer: u64, exponent: i64, bits: usize) -> ([Dyadic; 2], Dyadic) {
    debug_assert!(exponent + bits as i64 >= 0 && integer as f64 * 2.0_f64.powi(exponent as i32) <= 1.58);
    let angle: Vec<u64> = Units::of(integer, (exponent + bits as i64) as usize);
    let [cosine, sine, minus_cosine, minus_sine] =
        quarters(&angle, bits).map(|units| Dyadic::of_limbs(units, -(bits as i64)));
    (
        [&sine - &minus_sine, &cosine - &minus_cosine],
        of_finite(UNITS_PER_BIT * bits as f64).times_power_of_two(-(bits as i64)),
    )
}

/// Returns the sums of the terms `angle^k / k!` with `k` = 0, 4, 8, ..., of those with `k` = 1, 5, ..., and so on.
/// Cosine and sine are the first and second sum less the third and fourth one.
pub fn quarters<N: Units>(angle: &N, bits: usize) -> [N; 4] {
    let mut term = N::of(1, bits);
    let mut sums = [(); 4].map(|()| N::of(0, 0));
    for k in 0.. {
        if term.is_zero() {
            break;
        }
        sums[k % 4] = sums[k % 4].plus(&term);
        term = term.times(angle, bits).over(k as u64 + 1);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{E, LN_2};

    #[test]
    fn the_series_have_the_known_sums() {
        const BITS: usize = 40;
        let number = |units: Vec<u64>| units[0] as f64 / (1_u64 << BITS) as f64;
        let is_near = |sum: f64, expected: f64| (sum - expected).abs() < UNITS_PER_BIT * 1e-10;
        assert!(is_near(number(two_atanh(1, 3, BITS)), LN_2));
        let one: Vec<u64> = Units::of(1, BITS);
        let [cosine, sine, minus_cosine, minus_sine] = quarters(&one, BITS).map(number);
        assert!(is_near(cosine + sine + minus_cosine + minus_sine, E));
        assert!(is_near(cosine - minus_cosine, 0.540_302_305_868_139_8), "the cosine of 1");
        assert!(is_near(sine - minus_sine, 0.841_470_984_807_896_5), "the sine of 1");
    }
}
