//! Logarithm, sine and cosine with any number of bits, as integers with a bound of their error.
//!
//! A fixed-point number is an integer `n` that stands for `n / 2^bits`. Each operation truncates, so it is wrong by
//! less than one unit `2^-bits`, and the errors of a series can be counted. The functions are slow: they decide the
//! few roundings for which faster arithmetic is uncertain.

use crate::math::dyadic::{Dyadic, exact};
use crate::math::limbs::{product, quotient, shifted, shifted_right, sum};

/// A factor in the error bound of a series. A series that is summed with `bits` fraction bits has an error of at most
/// `UNITS_PER_BIT * bits * 2^-bits`. The functions that sum a series say why. [`logarithm`] adds several series, and
/// returns its own bound.
pub const UNITS_PER_BIT: f64 = 2.0;

/// Returns the product of two fixed-point numbers.
fn multiplied(a: &[u64], b: &[u64], bits: usize) -> Vec<u64> {
    shifted_right(&product(a, b), bits)
}

/// Returns `2 atanh(numerator / denominator) 2^bits`, the logarithm of `(denominator + numerator) / (denominator -
/// numerator)`.
///
/// The quotient `s` must be at most 1/3. The series is `2 (s + s^3 / 3 + s^5 / 5 + ...)`. A power of `s` is wrong by
/// less than 2 units: the error of the power before it is divided by 9, that of `s^2` by 3, and 1 is added. A term is
/// wrong by less than 2, and there are at most `bits / 3` terms before the power vanishes, since each has 3.17 bits
/// less. So the sum is wrong by less than `2 bits / 3` units, and the result by twice as much. This is less than
/// [`UNITS_PER_BIT`] times `bits`, and the difference covers the terms that are left out.
fn two_atanh(numerator: u64, denominator: u64, bits: usize) -> Vec<u64> {
    debug_assert!(numerator <= denominator / 3);
    let mut power = quotient(&shifted(&[numerator], bits as u64), denominator);
    let square = multiplied(&power, &power, bits);
    let (mut total, mut divisor) = (Vec::new(), 1);
    while !power.is_empty() {
        total = sum_of(&total, &quotient(&power, divisor));
        power = multiplied(&power, &square, bits);
        divisor += 2;
    }
    shifted(&total, 1)
}

/// Returns `a + b`. Either number may be the larger one.
fn sum_of(a: &[u64], b: &[u64]) -> Vec<u64> {
    if a.len() < b.len() { sum(b, a, false) } else { sum(a, b, false) }
}

/// Returns the natural logarithm of `integer 2^exponent`, for a positive integer below 2^62, and the bound of its
/// error.
///
/// With `integer = m 2^k` and `1 <= m < 2` it is `(exponent + k) ln 2 + ln m`.
pub fn logarithm(integer: u64, exponent: i64, bits: usize) -> (Dyadic, Dyadic) {
    let k = integer.ilog2();
    let (one, power) = (1 << k, exponent + i64::from(k));
    let of_units = |units: Vec<u64>| Dyadic::of_limbs(units, -(bits as i64));
    let two = of_units(two_atanh(1, 3, bits));
    let mantissa = of_units(two_atanh(integer - one, integer + one, bits));
    let error = (power.unsigned_abs() + 1) as f64 * UNITS_PER_BIT * bits as f64;
    (&(&exact(power as f64) * &two) + &mantissa, exact(error).scaled(-(bits as i64)))
}

/// Returns sine and cosine of `integer 2^exponent`, and the bound of the error of each. The angle must be from 0 to
/// 1.58, and a multiple of `2^-bits`.
///
/// The series is that of Taylor: term `k + 1` is term `k` times the angle divided by `k + 1`, and the signs alternate
/// in pairs. A term is wrong by less than 4 units: the error of the term before, times 1.58 and divided by `k + 1`, and
/// two truncations. For 128 bits and more there are at most `bits / 2` terms, because term 34 is below `2^-105` and
/// each further term is at least 4 bits smaller.
pub fn sine_and_cosine(integer: u64, exponent: i64, bits: usize) -> ([Dyadic; 2], Dyadic) {
    debug_assert!(exponent + bits as i64 >= 0 && integer as f64 * 2.0_f64.powi(exponent as i32) <= 1.58);
    let angle = shifted(&[integer], (exponent + bits as i64) as u64);
    let mut term = shifted(&[1], bits as u64);
    // The sums of the terms 0, 4, 8, ..., of the terms 1, 5, ..., and so on.
    let mut sums = [const { Vec::new() }; 4];
    for k in 0.. {
        if term.is_empty() {
            break;
        }
        sums[k % 4] = sum_of(&sums[k % 4], &term);
        term = quotient(&multiplied(&term, &angle, bits), k as u64 + 1);
    }
    let [cosine, sine, minus_cosine, minus_sine] = sums.map(|units| Dyadic::of_limbs(units, -(bits as i64)));
    ([&sine - &minus_sine, &cosine - &minus_cosine], exact(UNITS_PER_BIT * bits as f64).scaled(-(bits as i64)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cmp::Ordering;

    /// Whether the difference of two values is at most the bound.
    fn is_within(value: &Dyadic, other: &Dyadic, bound: &Dyadic) -> bool {
        let difference = value - other;
        let magnitude = if difference.sign() == Ordering::Less { -&difference } else { difference };
        (bound - &magnitude).sign() != Ordering::Less
    }

    #[test]
    fn more_bits_change_a_value_by_at_most_the_bound() {
        for integer in [1, 3, 5, 12345, (1 << 52) + 1, (1 << 53) - 1] {
            for bits in [128, 192] {
                let at = |bits| logarithm(integer, -7, bits);
                let ((value, error), (more, _)) = (at(bits), at(512));
                assert!(is_within(&value, &more, &error), "ln {integer}");
                let at = |bits| sine_and_cosine(integer, -53, bits);
                let ((values, error), (more, _)) = (at(bits), at(512));
                let within = [0, 1].map(|index| is_within(&values[index], &more[index], &error));
                assert_eq!(within, [true; 2], "sine and cosine of {integer}");
            }
        }
    }
}
