//! Arithmetic without rounding, on the finite numbers of `f64` and on their sums and products.
//!
//! A number is an integer of any size times a power of two. No operation rounds or overflows. Each operation allocates
//! memory, so this arithmetic serves only the rare decisions that faster arithmetic leaves uncertain.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use crate::math::{double_double::DoubleDouble, error_free::two_sum, limbs, real::Real};

/// The number `± magnitude * 2^exponent`, with the minus sign if `negative` is set.
#[derive(Clone, Debug)]
pub struct Dyadic {
    negative: bool,
    /// A whole number in the form of [`limbs`]: the lowest limb first, the last limb not zero, empty for zero.
    magnitude: Vec<u64>,
    exponent: i64,
}

impl Dyadic {
    /// Returns `value` without rounding, or `None` if `value` is infinite or NaN.
    pub fn new(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let (integer, exponent) = integer_and_exponent(value);
        let magnitude = if integer == 0 { Vec::new() } else { vec![integer] };
        Some(Self { negative: value < 0.0, magnitude, exponent })
    }

    /// Returns `magnitude * 2^exponent`. The highest limb of `magnitude` must not be zero.
    pub(crate) fn of_limbs(magnitude: Vec<u64>, exponent: i64) -> Self {
        debug_assert!(magnitude.last() != Some(&0));
        Self { negative: false, magnitude, exponent }
    }

    /// Compares the number with zero.
    pub fn sign(&self) -> Ordering {
        match (self.magnitude.is_empty(), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// Returns the square of the number.
    pub(crate) fn squared(&self) -> Self {
        self * self
    }

    /// Returns the number times `2^power`.
    pub(crate) fn times_power_of_two(&self, power: i64) -> Self {
        Self { exponent: self.exponent + power, ..self.clone() }
    }

    /// Returns the smallest `e` with `|self| < 2^e`, or `None` for zero, which is below every power of two. The
    /// exponent of a zero has no meaning, because it comes from the numbers that cancelled.
    pub(crate) fn top_exponent(&self) -> Option<i64> {
        (!self.magnitude.is_empty()).then(|| self.exponent + self.bits())
    }

    /// Returns `fraction` and `power`, so that the number is `fraction 2^power`. This works for magnitudes beyond the
    /// range of `f64` too. The fraction is truncated to 106 bits, with `0.5 <= |fraction| < 1`. For zero the result is
    /// `(0, 0)`.
    pub(crate) fn to_fraction_and_power(&self) -> (DoubleDouble, i64) {
        let power = self.top_exponent().unwrap_or(0);
        (self.to_double_double(-power), power)
    }

    /// Returns the number times `2^power`, truncated to 106 bits.
    pub(crate) fn to_double_double(&self, power: i64) -> DoubleDouble {
        let Some(top_exponent) = self.top_exponent() else { return DoubleDouble::of(0.0) };
        let part = |skipped: i64| times_power_of_two(self.digits(skipped) as f64, top_exponent - 53 - skipped + power);
        let (high, low) = two_sum(part(0), part(53));
        if self.negative { DoubleDouble { high: -high, low: -low } } else { DoubleDouble { high, low } }
    }

    /// Returns the number of bits of the magnitude, without zeros before the highest.
    fn bits(&self) -> i64 {
        self.magnitude.last().map_or(0, |last| 64 * self.magnitude.len() as i64 - i64::from(last.leading_zeros()))
    }

    /// Returns the 53 bits of the magnitude that follow its highest `skipped` bits.
    fn digits(&self, skipped: i64) -> u64 {
        let lowest = self.bits() - skipped - 53;
        // Bits outside of the magnitude are 0.
        let limb =
            |index: i64| usize::try_from(index).map_or(0, |index| self.magnitude.get(index).copied().unwrap_or(0));
        let (first, shift) = (lowest.div_euclid(64), lowest.rem_euclid(64));
        let both = u128::from(limb(first + 1)) << 64 | u128::from(limb(first));
        (both >> shift) as u64 & ((1 << 53) - 1)
    }

    /// Returns `self + other`, or `self - other` if `is_difference` is set.
    fn combined(&self, other: &Self, is_difference: bool) -> Self {
        let other_is_negative = other.negative != is_difference;
        if other.magnitude.is_empty() {
            return self.clone();
        }
        if self.magnitude.is_empty() {
            return Self { negative: other_is_negative, ..other.clone() };
        }
        let shift = self.exponent - other.exponent;
        let exponent = self.exponent.min(other.exponent);
        // The number with the larger exponent is shifted to the smaller one.
        let ((high, high_is_negative), (low, low_is_negative)) = match shift >= 0 {
            true => ((self, self.negative), (other, other_is_negative)),
            false => ((other, other_is_negative), (self, self.negative)),
        };
        let high = limbs::shifted(&high.magnitude, shift.unsigned_abs());
        if high_is_negative == low_is_negative {
            let magnitude = limbs::sum(high, &low.magnitude);
            return Self { negative: high_is_negative, magnitude, exponent };
        }
        let (magnitude, is_flipped) = limbs::difference(high, &low.magnitude);
        Self { negative: high_is_negative != is_flipped, magnitude, exponent }
    }
}

/// Returns a finite number without rounding.
pub(crate) fn of_finite(value: f64) -> Dyadic {
    Dyadic::new(value).expect("the value is finite")
}

/// Returns `(integer, exponent)` with `|value| = integer * 2^exponent`. `value` must be finite. The integer is below
/// 2^53 and the exponent is at least -1074, because this is how an `f64` stores numbers (IEEE 754, binary64).
pub(crate) const fn integer_and_exponent(value: f64) -> (u64, i64) {
    debug_assert!(value.is_finite());
    let (fraction, biased) = (value.to_bits() & ((1 << 52) - 1), (value.to_bits() >> 52 & 0x7FF) as i64);
    if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) }
}

/// Returns `value 2^power`. The result is infinite if it is too large for `f64`, and zero if it is too small.
pub(crate) fn times_power_of_two(mut value: f64, power: i64) -> f64 {
    let mut left = power.clamp(-4000, 4000);
    while left != 0 {
        let step = left.clamp(-1022, 1023);
        value *= f64::from_bits(((1023 + step) as u64) << 52);
        left -= step;
    }
    value
}

/// Compares `x + y sqrt(d)` with zero, for `d >= 0`.
pub fn sign_with_sqrt(x: &Dyadic, y: &Dyadic, d: &Dyadic) -> Ordering {
    let y_sign = if d.sign() == Ordering::Equal { Ordering::Equal } else { y.sign() };
    match (x.sign(), y_sign) {
        (sign, Ordering::Equal) | (Ordering::Equal, sign) => sign,
        (x_sign, y_sign) if x_sign == y_sign => x_sign,
        // The larger of the two squares decides.
        (Ordering::Greater, _) => (&x.squared() - &(&y.squared() * d)).sign(),
        (_, _) => (&(&y.squared() * d) - &x.squared()).sign(),
    }
}

/// Compares `x + y sqrt(d) + z sqrt(e)` with zero, for `d >= 0` and `e >= 0`.
pub fn sign_with_two_sqrts(x: &Dyadic, (y, d): (&Dyadic, &Dyadic), (z, e): (&Dyadic, &Dyadic)) -> Ordering {
    let z_sign = if e.sign() == Ordering::Equal { Ordering::Equal } else { z.sign() };
    match (sign_with_sqrt(x, y, d), z_sign) {
        (sign, Ordering::Equal) | (Ordering::Equal, sign) => sign,
        (left, right) if left == right => left,
        (left, _) => {
            // The larger of two squares decides: that of `x + y sqrt(d)`, or that of `z sqrt(e)`.
            let difference = &(&x.squared() + &(&y.squared() * d)) - &(&z.squared() * e);
            let sign = sign_with_sqrt(&difference, &(x * y).times_power_of_two(1), d);
            if left == Ordering::Greater { sign } else { sign.reverse() }
        }
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: Self) -> Dyadic {
        self.combined(other, false)
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { negative: !self.negative, ..self.clone() }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: Self) -> Dyadic {
        self.combined(other, true)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Self) -> Dyadic {
        Dyadic {
            negative: self.negative != other.negative,
            magnitude: limbs::product(&self.magnitude, &other.magnitude),
            exponent: self.exponent + other.exponent,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_an_integer_times_a_power_of_two() {
        assert_eq!([0.0, -0.0].map(integer_and_exponent), [(0, -1074); 2]);
        assert_eq!(integer_and_exponent(-1.5), (3 << 51, -52));
        assert_eq!(integer_and_exponent(f64::MIN_POSITIVE.next_down()), ((1 << 52) - 1, -1074));
        assert_eq!(integer_and_exponent(f64::MIN_POSITIVE), (1 << 52, -1074));
        assert_eq!(integer_and_exponent(f64::MAX), ((1 << 53) - 1, 971));
    }

    fn high(number: &Dyadic) -> f64 {
        number.to_double_double(0).high
    }

    #[test]
    fn every_finite_number_is_held_and_no_other() {
        for value in [0.0, 1.0, -1.5, 0.1, f64::MAX, f64::MIN_POSITIVE, 5e-324, -3e-310] {
            let sign = value.partial_cmp(&0.0);
            assert_eq!((high(&of_finite(value)), Some(of_finite(value).sign())), (value, sign));
        }
        assert!(Dyadic::new(f64::NAN).is_none() && Dyadic::new(f64::INFINITY).is_none());
    }

    #[test]
    fn nothing_is_lost_beside_something_large() {
        let (large, tiny) = (of_finite(1e300), of_finite(5e-324));
        let sum = &large + &tiny;
        assert_eq!((&sum - &large).sign(), Ordering::Greater);
        assert_eq!(high(&(&sum - &large)), 5e-324);
        // (large + tiny)(large - tiny) - large^2 = -tiny^2
        let difference = &(&sum * &(&large - &tiny)) - &large.squared();
        assert_eq!((&difference + &tiny.squared()).sign(), Ordering::Equal);
    }

    #[test]
    fn roots_are_compared_without_being_taken() {
        let [one, two, three] = [1.0, 2.0, 3.0].map(of_finite);
        assert_eq!(sign_with_sqrt(&-&three, &two, &two), Ordering::Less, "-3 + 2 sqrt(2)");
        assert_eq!(sign_with_sqrt(&three, &-&two, &two), Ordering::Greater, "3 - 2 sqrt(2)");
        assert_eq!(sign_with_sqrt(&-&two, &one, &of_finite(4.0)), Ordering::Equal, "-2 + sqrt(4)");
        assert_eq!(sign_with_sqrt(&of_finite(-2.0_f64.next_down()), &one, &of_finite(4.0)), Ordering::Greater);
        assert_eq!(sign_with_sqrt(&of_finite(0.0), &-&one, &two), Ordering::Less);
        assert_eq!(sign_with_sqrt(&of_finite(0.0), &one, &of_finite(0.0)), Ordering::Equal);
    }

    #[test]
    fn sums_of_two_roots_are_compared_without_a_root() {
        // sqrt(2) + sqrt(3) is 3.14626436994197234...
        let [one, two, three] = [1.0, 2.0, 3.0].map(of_finite);
        let near = |x: f64| sign_with_two_sqrts(&of_finite(-x), (&one, &two), (&one, &three));
        assert_eq!([near(3.146264369941972), near(3.1462643699419726)], [Ordering::Greater, Ordering::Less]);
        assert_eq!(sign_with_two_sqrts(&of_finite(0.0), (&two, &two), (&-&one, &of_finite(8.0))), Ordering::Equal);
    }

    #[test]
    fn rounding_keeps_106_bits() {
        let third = &(&of_finite(1.0) + &of_finite(2.0_f64.powi(-100))) * &of_finite(3.0);
        let DoubleDouble { high, low } = third.to_double_double(0);
        assert_eq!((high, low), (3.0, 3.0 * 2.0_f64.powi(-100)));
        assert_eq!(times_power_of_two(1.5, 3000), f64::INFINITY);
        assert_eq!(times_power_of_two(1.5, -3000), 0.0);
        assert_eq!(times_power_of_two(1.5, -1), 0.75);
    }
}
