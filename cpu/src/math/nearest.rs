//! Correct rounding of a number that can only be compared.
//!
//! The rounded result changes where the number passes the midpoint between two neighbouring `f64`. So code that can
//! compare a number with midpoints can round it correctly, however inaccurate the first candidate is.

use std::cmp::Ordering;

use crate::math::dyadic::{Dyadic, integer_and_exponent};

/// The number `integer * 2^exponent`, which lies halfway between two neighbouring `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Midpoint {
    /// An odd number below 2^54.
    pub integer: u64,
    /// The power of two that it is multiplied by.
    pub exponent: i64,
}

impl Midpoint {
    /// Returns the midpoint between `below` and the next larger `f64`. `below` is finite and not negative. The number
    /// after the largest `f64` is 2^1024.
    const fn above(below: f64) -> Self {
        let (integer, exponent) = integer_and_exponent(below);
        Self { integer: 2 * integer + 1, exponent: exponent - 1 }
    }
}

/// Returns the `f64` nearest to a positive number. If two are equally near, it returns the one with the even fraction
/// (IEEE 754, roundTiesToEven).
///
/// `compare` compares the number with a midpoint, and returns `None` if it cannot. Then the result is `None` too. The
/// search starts at `candidate` and goes to a neighbour at each step, so `candidate` should be near the number.
pub(crate) fn nearest(candidate: f64, compare: impl Fn(Midpoint) -> Option<Ordering>) -> Option<f64> {
    let even = |lower: f64| if lower.to_bits().is_multiple_of(2) { lower } else { lower.next_up() };
    let mut result = candidate.clamp(0.0, f64::MAX);
    loop {
        match compare(Midpoint::above(result))? {
            Ordering::Less => break,
            Ordering::Equal => return Some(even(result)),
            Ordering::Greater if result == f64::MAX => return Some(f64::INFINITY),
            Ordering::Greater => result = result.next_up(),
        }
    }
    while result > 0.0 {
        let lower = result.next_down();
        match compare(Midpoint::above(lower))? {
            Ordering::Less => result = lower,
            Ordering::Equal => return Some(even(lower)),
            Ordering::Greater => break,
        }
    }
    Some(result)
}

/// Returns the sign of a number that differs from `difference` by at most `error_bound`. The result is `None` if both
/// signs are possible.
pub(crate) fn certain_sign(difference: &Dyadic, error_bound: &Dyadic) -> Option<Ordering> {
    match ((difference - error_bound).sign(), (difference + error_bound).sign()) {
        (Ordering::Greater, _) => Some(Ordering::Greater),
        (_, Ordering::Less) => Some(Ordering::Less),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dyadic::of_finite;

    /// Rounds `number` from `candidate`.
    fn rounded(number: &Dyadic, candidate: f64) -> Option<f64> {
        nearest(candidate, |Midpoint { integer, exponent }| {
            Some((number - &Dyadic::of_limbs(vec![integer], exponent)).sign())
        })
    }

    #[test]
    fn sums_are_rounded_as_the_processor_rounds_them() {
        for a in [0.0, 5e-324, 1.0, 1.5, f64::MIN_POSITIVE, 4503599627370497.0, 1e300, f64::MAX, f64::MAX.next_down()] {
            for share in [0.0, 0.25, 0.5, 0.75, 1.0, 1.25] {
                let unit = if a == f64::MAX { a - a.next_down() } else { a.next_up() - a };
                let b = unit * share;
                let number = &of_finite(a) + &of_finite(b);
                for candidate in [a, a.next_up(), a.next_down(), a + b, f64::NAN.max(a)] {
                    assert_eq!(rounded(&number, candidate), Some(a + b), "{a:e} + {b:e} from {candidate:e}");
                }
            }
        }
    }

    #[test]
    fn half_a_unit_beyond_the_largest_number_is_infinite() {
        let unit = f64::MAX - f64::MAX.next_down();
        let sum = |share: f64| {
            let [a, b] = [f64::MAX, unit * share].map(of_finite);
            rounded(&(&a + &b), f64::INFINITY)
        };
        assert_eq!((sum(0.499), sum(0.5)), (Some(f64::MAX), Some(f64::INFINITY)));
    }

    #[test]
    fn what_cannot_be_compared_has_no_result() {
        assert_eq!(nearest(1.0, |_| None), None);
    }

    #[test]
    fn a_sign_is_certain_beyond_the_error_only() {
        let [large, small] = [2.0, 1.0].map(of_finite);
        assert_eq!(certain_sign(&large, &small), Some(Ordering::Greater));
        assert_eq!(certain_sign(&-&large, &small), Some(Ordering::Less));
        assert_eq!(certain_sign(&small, &large), None);
        assert_eq!(certain_sign(&small, &small), None);
    }
}
