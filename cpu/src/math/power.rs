//! The power `x^y`, correctly rounded, so that it has the same bits on every system.
//!
//! [`quick`] computes the power in [double-double](crate::math::double_double) arithmetic with a bound of its error.
//! The bound leaves the rounding uncertain for about one power in 2^30. Then the power is compared with the midpoints
//! of neighbouring `f64` by logarithms of as many bits as are needed.

pub mod quick;
pub mod tables;

use std::cmp::Ordering;

use crate::math::dyadic::{exact, integer_and_exponent};
use crate::math::fixed_point::logarithm;
use crate::math::nearest::{Midpoint, certain_sign, nearest};
use crate::math::power::quick::Quick;

/// Returns `base^exponent`, correctly rounded, if the exponent is positive. A base that is zero, negative, infinite or
/// NaN then gives what `pow` of C gives (C17, F.10.4.4). If the exponent is zero, negative or NaN, the result is NaN,
/// unlike that of C. The renderer has no such exponent: its exponents are gamma and `1 / gamma`, which are positive.
#[inline(always)]
pub fn power(base: f64, exponent: f64) -> f64 {
    if base > 0.0 && base < f64::INFINITY && exponent > 0.0 && exponent < f64::INFINITY {
        match quick::power(base, exponent) {
            Quick::Certain(power) => power,
            Quick::Candidate(candidate) => decided(base, exponent, candidate),
        }
    } else {
        special(base, exponent)
    }
}

/// Returns the result of [`power`] if a number is not finite, or if the base or the exponent is not positive.
#[cold]
#[inline(never)]
fn special(base: f64, exponent: f64) -> f64 {
    // From 2^53 on every number is an even integer.
    let is_large = exponent >= 2.0_f64.powi(53);
    let integer = exponent as i64;
    let is_integer = is_large || integer as f64 == exponent;
    let sign = if !is_large && is_integer && integer % 2 == 1 { base.signum() } else { 1.0 };
    let magnitude = base.abs();
    if exponent.is_nan() || exponent <= 0.0 || base.is_nan() {
        f64::NAN
    } else if magnitude == 0.0 || magnitude == f64::INFINITY {
        sign * magnitude
    } else if exponent == f64::INFINITY {
        if magnitude == 1.0 {
            1.0
        } else if magnitude < 1.0 {
            0.0
        } else {
            f64::INFINITY
        }
    } else if is_integer {
        sign * power(magnitude, exponent)
    } else {
        f64::NAN
    }
}

/// Returns `base^exponent` for positive finite numbers, correctly rounded. `candidate` is a number near the power.
#[cold]
#[inline(never)]
fn decided(base: f64, exponent: f64, candidate: f64) -> f64 {
    let mut bits = 192;
    loop {
        if let Some(power) = nearest(candidate, |midpoint| compare(base, exponent, midpoint, bits)) {
            return power;
        }
        bits *= 2;
    }
}

/// Compares `base^exponent` with a midpoint by logarithms of `bits` bits. The result is `None` if the errors of the
/// logarithms are too large to decide.
///
/// If the two are not equal, neither are their logarithms, and enough bits decide. If they are equal, no number of bits
/// does, so integers decide.
fn compare(base: f64, exponent: f64, midpoint: Midpoint, bits: usize) -> Option<Ordering> {
    if is_equal(base, exponent, midpoint) {
        return Some(Ordering::Equal);
    }
    let (base, power_of_two) = odd_part(base);
    let (base, base_error) = logarithm(base, power_of_two, bits);
    let (midpoint, midpoint_error) = logarithm(midpoint.integer, midpoint.exponent, bits);
    let exponent = exact(exponent);
    certain_sign(&(&(&exponent * &base) - &midpoint), &(&(&exponent * &base_error) + &midpoint_error))
}

/// Whether `base^exponent` equals a midpoint.
///
/// With the base `m 2^e` and the exponent `n 2^f`, `m` and `n` odd, the power has the odd part `m^(n 2^f)` and the
/// power of two `e n 2^f`. If `f` is negative, `m` must be the `2^-f`-th power of an integer, since `n` is odd.
fn is_equal(base: f64, exponent: f64, midpoint: Midpoint) -> bool {
    let ((mut root, e), (n, f)) = (odd_part(base), odd_part(exponent));
    for _ in f..0 {
        let next = root.isqrt();
        if next * next != root {
            return false;
        }
        root = next;
    }
    let odd = if root == 1 {
        Some(1)
    } else if n <= 34 && f <= 5 {
        root.checked_pow((n << f.max(0)) as u32)
    } else {
        // Even the power of 3 has more than 54 bits.
        None
    };
    let power_of_two = &exact(exponent) * &exact(e as f64);
    odd == Some(midpoint.integer) && (&power_of_two - &exact(midpoint.exponent as f64)).sign() == Ordering::Equal
}

/// Returns `(odd, power)`, so that the positive finite `number` is `odd 2^power` with an odd integer.
fn odd_part(number: f64) -> (u64, i64) {
    let (integer, power) = integer_and_exponent(number);
    let zeros = integer.trailing_zeros();
    (integer >> zeros, power + i64::from(zeros))
}

#[cfg(test)]
mod tests;
