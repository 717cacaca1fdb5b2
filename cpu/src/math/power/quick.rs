//! The power in double-double arithmetic, with a bound of its error.
//!
//! `x^y = e^(y ln x)`:
//!
//! 1. `x = m 2^e` with `sqrt(1/2) <= m < sqrt 2`. With the integer `k` nearest to `128 / m`, `z = m k / 128 - 1` is
//!    exact and at most `2^-7.5`. Then `ln x = e ln 2 + ln(128 / k) + ln(1 + z)`.
//! 2. `ln(1 + z)` is a Taylor polynomial of degree 14. Terms from degree 7 on are computed in `f64`.
//! 3. `t = y ln x = n ln 2 + j / 64 + r` with `|r| <= 2^-7` and a little more, and `|t| < 746`.
//! 4. `e^r` is a Taylor polynomial of degree 12, and `e^t = 2^n e^(j / 64) e^r`.
//!
//! `tests/stability/src/proof/power.rs` bounds the relative error.

use crate::math::double_double::DoubleDouble;
use crate::math::dyadic::times_power_of_two;
use crate::math::power::tables::{LN_2, exponential, ln_128_over, reciprocal};
use crate::math::real::Real;

/// An upper bound of the relative error of a power in double-double arithmetic (docs/margins.md).
pub const POWER_ERROR: f64 = 1.0 / (1_u128 << 83) as f64;

/// The result of [`power`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quick {
    /// The power, correctly rounded.
    Certain(f64),
    /// A number near the power. It is uncertain which `f64` is nearest to the power.
    Uncertain(f64),
}

/// Computes `base^exponent` for positive finite numbers in double-double arithmetic. The result tells whether its
/// rounding is certain.
#[inline(always)]
pub(crate) fn power(base: f64, exponent: f64) -> Quick {
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
    let error_bound = fraction.high * POWER_ERROR;
    let [low, high] = [fraction.low - error_bound, fraction.low + error_bound].map(|low| fraction.high + low);
    let candidate = times_power_of_two(high, power);
    // A subnormal number has fewer bits, so this rounding is not the final one.
    if low == high && power >= -1021 { Quick::Certain(candidate) } else { Quick::Uncertain(candidate) }
}

/// A number of about 106 bits. The series are generic over it, so that a proof can bound their errors.
pub trait Wide: Real {
    /// A number of 53 bits.
    type Narrow: Real;
    /// Returns the number, rounded to 53 bits.
    fn high(self) -> Self::Narrow;
    /// Returns the number with more bits.
    fn widened(narrow: Self::Narrow) -> Self;
    /// Returns a constant of a table.
    fn constant(value: DoubleDouble) -> Self;
}

impl Wide for DoubleDouble {
    type Narrow = f64;

    #[inline(always)]
    fn high(self) -> f64 {
        self.high
    }
    #[inline(always)]
    fn widened(narrow: f64) -> Self {
        Self::of(narrow)
    }
    #[inline(always)]
    fn constant(value: DoubleDouble) -> Self {
        value
    }
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
    ln_of_parts(e, k, z)
}

/// Returns `e ln 2 + ln(128 / k) + ln(1 + z)`.
#[inline(always)]
pub fn ln_of_parts<T: Wide>(e: i64, k: usize, z: T) -> T {
    T::of(e as f64) * T::constant(LN_2) + (T::constant(ln_128_over(k)) + ln_1p(z))
}

/// Returns `ln(1 + z)`, for `|z| <= 2^-7.5`.
#[inline(always)]
fn ln_1p<T: Wide>(z: T) -> T {
    let high = z.high();
    let tail = (7..=14).rev().fold(T::Narrow::of(0.0), |sum, n| T::Narrow::of(1.0 / f64::from(n)) - high * sum);
    let sum = T::widened(tail);
    let sum = T::constant(const { reciprocal(6) }) - z * sum;
    let sum = T::constant(const { reciprocal(5) }) - z * sum;
    let sum = T::constant(const { reciprocal(4) }) - z * sum;
    let sum = T::constant(const { reciprocal(3) }) - z * sum;
    let sum = T::constant(const { reciprocal(2) }) - z * sum;
    z - z * z * sum
}

/// Returns `e^t` as `(fraction, power)`, for `fraction 2^power`. The fraction is from 0.7 to 1.5.
#[inline(always)]
fn exp(t: DoubleDouble) -> (DoubleDouble, i64) {
    let n = nearest_integer(t.high / LN_2.high);
    let rest = rest(t, n);
    let j = nearest_integer(64.0 * rest.high);
    (exp_of_rest(rest - DoubleDouble::of(j as f64 / 64.0), j), n)
}

/// Returns `t - n ln 2`.
#[inline(always)]
pub fn rest<T: Wide>(t: T, n: i64) -> T {
    t - T::of(n as f64) * T::constant(LN_2)
}

/// Returns `e^(r + j / 64)`, for `|r|` of about `2^-7` or less.
#[inline(always)]
pub fn exp_of_rest<T: Wide>(r: T, j: i64) -> T {
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
    let high = r.high();
    let tail = FACTORIALS.into_iter().fold(T::Narrow::of(0.0), |sum, factor| T::Narrow::of(factor) + high * sum);
    let sum = T::constant(const { reciprocal(120) }) + r * T::widened(tail);
    let sum = T::constant(const { reciprocal(24) }) + r * sum;
    let sum = T::constant(const { reciprocal(6) }) + r * sum;
    let sum = T::constant(const { reciprocal(2) }) + r * sum;
    let sum = T::of(1.0) + (r + r * r * sum);
    T::constant(exponential(j)) * sum
}

/// Returns the integer nearest to a number below 2^53.
#[inline(always)]
fn nearest_integer(value: f64) -> i64 {
    (value + 0.5_f64.copysign(value)) as i64
}
