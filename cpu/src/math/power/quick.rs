//! The power in double-double arithmetic, with a bound of its error.
//!
//! `x^y = e^(y ln x)`. With `u = 2^-53`, a sum or product has a relative error of at most `3 u^2` or `4 u^2`
//! ([`double_double`](crate::math::double_double)).
//!
//! 1. `x = m 2^e` with `sqrt(1/2) <= m < sqrt 2`. With the integer `k` nearest to `128 / m`, `z = m k / 128 - 1` is
//!    exact and at most `2^-7.5`. Then `ln x = e ln 2 + ln(128 / k) + ln(1 + z)`.
//! 2. `ln(1 + z)` is a Taylor polynomial of degree 14. What is left out is at most `2^-109` of it. Terms from degree 7
//!    on are computed in `f64`, which costs `2^-99`, the others in double-double, which costs `2^-102`.
//! 3. The terms of `ln x` cancel little: `|e| ln 2` is at least twice the others, and `ln(128 / k)` is at most twice
//!    the sum. So the relative error of `ln x` is below `2^-96`. That of `t = y ln x` is below `2^-95.9`, and `|t| <
//!    746`, so its absolute error is below `2^-86.3`.
//! 4. `t = n ln 2 + j / 64 + r` with `|r| <= 2^-7` and a little more. `n ln 2` is wrong by less than `2^-93`.
//! 5. `e^r` is a Taylor polynomial of degree 12, wrong by less than `2^-101`, and `e^t = 2^n e^(j / 64) e^r`.
//!
//! All in all the relative error is below `2^-86`. [`ERROR`] is eight times as large.

use crate::math::double_double::DoubleDouble;
use crate::math::dyadic::power_of_two;
use crate::math::power::tables::{LN_2, exponential, logarithm, reciprocal};
use crate::math::real::Real;

/// An upper bound of the relative error of a power in double-double arithmetic. The documentation of [this
/// module](self) derives it.
const ERROR: f64 = 1.0 / (1_u128 << 83) as f64;

/// The result of [`power`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quick {
    /// The power, correctly rounded.
    Certain(f64),
    /// A number near the power. It is uncertain which `f64` is nearest to the power.
    Candidate(f64),
}

/// Computes `base^exponent` for positive finite numbers in double-double arithmetic. The result tells whether its
/// rounding is certain.
#[inline(always)]
pub fn power(base: f64, exponent: f64) -> Quick {
    let logarithm = ln(base);
    let rough = exponent * logarithm.high;
    // The power is beyond the largest number, below half of the smallest, or nearer to 1 than half a unit in the last
    // place.
    if rough > 710.0 {
        return Quick::Certain(f64::INFINITY);
    }
    if rough < -746.0 {
        return Quick::Certain(0.0);
    }
    if rough.abs() < 1.0 / (1_u64 << 55) as f64 {
        return Quick::Certain(1.0);
    }
    let (fraction, power) = exp(DoubleDouble::of(exponent) * logarithm);
    let error = fraction.high * ERROR;
    let [low, high] = [fraction.low - error, fraction.low + error].map(|low| fraction.high + low);
    let candidate = power_of_two(high, power);
    // A subnormal number has fewer bits, so this rounding is not the final one.
    if low == high && power >= -1021 { Quick::Certain(candidate) } else { Quick::Candidate(candidate) }
}

/// Returns the natural logarithm of a positive finite number.
#[inline(always)]
fn ln(x: f64) -> DoubleDouble {
    const FRACTION: u64 = (1 << 52) - 1;
    let (x, extra) = if x < f64::MIN_POSITIVE { (x * (1_u64 << 54) as f64, 54) } else { (x, 0) };
    let (bits, one) = (x.to_bits(), 1.0_f64.to_bits());
    let m = f64::from_bits(bits & FRACTION | one);
    let e = (bits >> 52) as i64 - 1023 - extra;
    let (m, e) = if m > std::f64::consts::SQRT_2 { (0.5 * m, e + 1) } else { (m, e) };
    let k = (128.0 / m + 0.5) as usize;
    let z = DoubleDouble::of(m) * DoubleDouble::of(k as f64 / 128.0) - DoubleDouble::of(1.0);
    DoubleDouble::of(e as f64) * LN_2 + (logarithm(k) + ln_1p(z))
}

/// Returns `ln(1 + z)`, for `|z| <= 2^-7.5`.
#[inline(always)]
fn ln_1p(z: DoubleDouble) -> DoubleDouble {
    let tail = (7..=14).rev().fold(0.0, |sum, n| 1.0 / f64::from(n) - z.high * sum);
    let sum = DoubleDouble::of(tail);
    let sum = const { reciprocal(6) } - z * sum;
    let sum = const { reciprocal(5) } - z * sum;
    let sum = const { reciprocal(4) } - z * sum;
    let sum = const { reciprocal(3) } - z * sum;
    let sum = const { reciprocal(2) } - z * sum;
    z - z * z * sum
}

/// Returns `e^t` as `(fraction, power)`, for `fraction 2^power`. The fraction is from 0.7 to 1.5.
#[inline(always)]
fn exp(t: DoubleDouble) -> (DoubleDouble, i64) {
    let n = nearest_integer(t.high / LN_2.high);
    let rest = t - DoubleDouble::of(n as f64) * LN_2;
    let j = nearest_integer(64.0 * rest.high);
    let r = rest - DoubleDouble::of(j as f64 / 64.0);
    // 1 / n! for n from 12 to 6.
    const FACTORIALS: [f64; 7] = [
        1.0 / 479_001_600.0,
        1.0 / 39_916_800.0,
        1.0 / 3_628_800.0,
        1.0 / 362_880.0,
        1.0 / 40_320.0,
        1.0 / 5_040.0,
        1.0 / 720.0,
    ];
    let tail = FACTORIALS.into_iter().fold(0.0, |sum, factor| factor + r.high * sum);
    let sum = const { reciprocal(120) } + r * DoubleDouble::of(tail);
    let sum = const { reciprocal(24) } + r * sum;
    let sum = const { reciprocal(6) } + r * sum;
    let sum = const { reciprocal(2) } + r * sum;
    let sum = DoubleDouble::of(1.0) + (r + r * r * sum);
    (exponential(j) * sum, n)
}

/// Returns the integer nearest to a number below 2^53.
#[inline(always)]
fn nearest_integer(value: f64) -> i64 {
    (value + 0.5_f64.copysign(value)) as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dyadic::{Dyadic, integer_and_exponent};
    use crate::math::fixed_point;
    use crate::sampling::uniform::Uniform;

    #[test]
    fn the_error_of_a_power_is_an_eighth_of_its_bound() {
        let exact = |value: f64| Dyadic::new(value).expect("it is finite");
        let logarithm = |value: f64| {
            let (integer, exponent) = integer_and_exponent(value);
            fixed_point::logarithm(integer, exponent, 192).0
        };
        let (mut draws, mut worst) = (Uniform::new(6), 0.0_f64);
        for _ in 0..2000 {
            let (base, exponent) = (10.0_f64.powf(draws.draw(-300.0, 300.0)), draws.draw(0.5, 1.0));
            let (fraction, power) = exp(DoubleDouble::of(exponent) * ln(base));
            // The logarithm of `high (1 + small)`.
            let small = fraction.low / fraction.high;
            let high = &logarithm(fraction.high) + &exact(small - small * small / 2.0);
            let computed = &high + &(&logarithm(2.0) * &exact(power as f64));
            let error = &computed - &(&exact(exponent) * &logarithm(base));
            worst = worst.max(error.to_double_double().high.abs());
        }
        assert!(worst < ERROR / 8.0 && worst > ERROR / 8192.0, "{worst:e}");
    }
}
