//! The power `x^y`, correctly rounded, so that it has the same bits on every system.
//!
//! [`quick`] computes the power in [double-double](crate::math::double_double) arithmetic with a bound of its error.
//! The bound leaves the rounding uncertain for about one power in 2^30. Then the power is compared with the midpoints
//! of neighbouring `f64` by logarithms of as many bits as are needed.

pub mod quick;
pub mod tables;

use std::cmp::Ordering;

use crate::math::dyadic::{integer_and_exponent, of_finite};
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
            Quick::Uncertain(candidate) => decided(base, exponent, candidate),
        }
    } else {
        special(base, exponent)
    }
}

/// Returns the result of [`power`] if a number is not finite, or if the base or the exponent is not positive.
#[cold]
#[inline(never)]
fn special(base: f64, exponent: f64) -> f64 {
    let magnitude = base.abs();
    let sign = if exponent % 2.0 == 1.0 { base.signum() } else { 1.0 };
    if exponent.is_nan() || exponent <= 0.0 || base.is_nan() {
        f64::NAN
    } else if magnitude == 0.0 || magnitude == f64::INFINITY {
        sign * magnitude
    } else if exponent == f64::INFINITY {
        match magnitude.total_cmp(&1.0) {
            Ordering::Less => 0.0,
            Ordering::Equal => 1.0,
            Ordering::Greater => f64::INFINITY,
        }
    } else if exponent % 1.0 == 0.0 {
        sign * power(magnitude, exponent)
    } else {
        f64::NAN
    }
}

/// Returns `base^exponent` for positive finite numbers, correctly rounded. `candidate` is a number near the power.
#[cold]
#[inline(never)]
fn decided(base: f64, exponent: f64, candidate: f64) -> f64 {
    // 192 bits nearly always decide.
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
    let (base, base_error_bound) = logarithm(base, power_of_two, bits);
    let (midpoint, midpoint_error_bound) = logarithm(midpoint.integer, midpoint.exponent, bits);
    let exponent = of_finite(exponent);
    certain_sign(&(&(&exponent * &base) - &midpoint), &(&(&exponent * &base_error_bound) + &midpoint_error_bound))
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
    let power_of_two = &of_finite(exponent) * &of_finite(e as f64);
    odd == Some(midpoint.integer) && (&power_of_two - &of_finite(midpoint.exponent as f64)).sign() == Ordering::Equal
}

/// Returns `(odd, power)`, so that the positive finite `number` is `odd 2^power` with an odd integer.
fn odd_part(number: f64) -> (u64, i64) {
    let (integer, power) = integer_and_exponent(number);
    let zeros = integer.trailing_zeros();
    (integer >> zeros, power + i64::from(zeros))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{double_double::DoubleDouble, real::Real};
    use crate::sampling::uniform::Uniform;

    /// Numbers of all magnitudes, and near 1.
    fn numbers(draws: &mut Uniform, round: usize) -> f64 {
        match round % 3 {
            0 => draws.draw(0.0, 1.0),
            1 => 1.0 + draws.draw(-1.0, 1.0) * 0.5_f64.powi((round % 50) as i32),
            _ => 10.0_f64.powf(draws.draw(-307.0, 308.0)),
        }
    }

    #[test]
    fn special_values_are_those_of_c() {
        let infinity = f64::INFINITY;
        let powers = [power(-2.0, 3.0), power(-2.0, 2.0), power(0.0, 0.5), power(-infinity, 3.0), power(0.5, infinity)];
        assert_eq!(powers, [-8.0, 4.0, 0.0, -infinity, 0.0]);
        let values = [0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -2.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        for base in values {
            for exponent in [0.5, 1.0, 2.0, 3.0, 2.5, 9007199254740991.0, 9007199254740992.0, 1e300, f64::INFINITY] {
                let (ours, system) = (power(base, exponent), base.powf(exponent));
                assert!(
                    ours.to_bits() == system.to_bits() || ours.is_nan() && system.is_nan(),
                    "{base:e}^{exponent:e}"
                );
            }
            assert!([0.0, -0.0, -1.0, f64::NAN].iter().all(|&exponent| power(base, exponent).is_nan()), "{base}");
        }
    }

    #[test]
    fn exact_powers_and_ties_are_found() {
        assert_eq!([power(4.0, 0.5), power(27.0, 3.0), power(3.0, 33.0)], [2.0, 19683.0, 5559060566555523.0]);
        // 3^34 has 54 bits: it is halfway between two numbers.
        assert_eq!(power(3.0, 34.0), 16677181699666568.0);
        assert!(is_equal(3.0, 34.0, Midpoint { integer: 16677181699666569, exponent: 0 }));
        // The root of a square of 54 bits: (2^53 + 1)^2 has 107 bits, but 94906267^2 has 53.
        assert_eq!(power(94906265.0 * 94906265.0, 0.5), 94906265.0);
        // The square of a number of 27 bits plus a half is halfway where it has 54 bits.
        let half = 94906265.5_f64;
        assert_eq!(power(half, 2.0), half * half);
        let square = Midpoint { integer: 189812531 * 189812531, exponent: -2 };
        assert_eq!(compare(half, 2.0, square, 192), Some(Ordering::Equal));
        // The smallest positive number is twice 2^-1075, which is halfway to zero.
        assert_eq!([power(2.0_f64.powi(-215), 5.0), power(2.0_f64.powi(-537), 2.0)], [0.0, 5e-324]);
        assert_eq!(
            compare(2.0_f64.powi(-215), 5.0, Midpoint { integer: 1, exponent: -1075 }, 192),
            Some(Ordering::Equal)
        );
        // `powi` gives 0 for the smallest number if it is computed while the test runs.
        assert_eq!(power(f64::from_bits(1), 1.0 / 1074.0), 0.5_f64.powf(1074.0 * (1.0 / 1074.0)));
    }

    #[test]
    fn the_quick_power_is_that_of_integers() {
        let mut draws = Uniform::new(5);
        let mut certain = 0;
        for round in 0..3_000 {
            let (base, exponent) =
                (numbers(&mut draws, round), draws.draw(0.0, 1.0) * 2.0_f64.powi((round % 9) as i32 - 4));
            let quick = quick::power(base, exponent);
            let (Quick::Certain(candidate) | Quick::Uncertain(candidate)) = quick;
            certain += usize::from(matches!(quick, Quick::Certain(_)));
            // A wrong candidate does not matter.
            for start in [candidate, candidate.next_up(), candidate.next_down()] {
                assert_eq!(decided(base, exponent, start), candidate, "{base:e}^{exponent:e}");
            }
        }
        assert!(certain > 2_900, "{certain} certain");
    }

    #[test]
    fn tables_and_series_keep_the_laws_of_logarithms_and_powers() {
        let of = DoubleDouble::of;
        let is_near = |a: DoubleDouble, b: DoubleDouble, bits: i32| (a - b).high.abs() < 0.5_f64.powi(bits);
        assert!(is_near(of(3.0) * tables::reciprocal(3), of(1.0), 104));
        // The logarithm of 8/9 is twice that of 4/3, less that of 2.
        let of_4_3 = tables::ln_128_over(96);
        assert!(is_near(tables::ln_128_over(144), of_4_3 + of_4_3 - tables::LN_2, 103));
        assert_eq!(tables::ln_128_over(128), of(0.0));
        let quarter = tables::exponential(16);
        assert_eq!((quarter * quarter * quarter * quarter).high, std::f64::consts::E);
        assert!(is_near(tables::exponential(-16) * quarter, of(1.0), 100));
        assert!(is_near(quick::ln_of_parts(-1, 96, of(0.0)), of_4_3 - tables::LN_2, 103));
        // A number in the middle between two entries of the table has the same logarithm by both.
        let by = |k: usize| quick::ln_of_parts(0, k, of(128.0 / 100.5) * of(k as f64 / 128.0) - of(1.0));
        assert!(is_near(by(100), by(101), 97));
        // 4/3 times 1 + 1/256 is 257/192.
        assert!((quick::ln_of_parts(0, 96, of(1.0 / 256.0)).high - (257.0_f64 / 192.0).ln()).abs() < 1e-15);
        assert!(is_near(quick::exp_of_rest(of(0.0), 16), quarter, 100));
        assert!(is_near(quick::exp_of_rest(of(1.0 / 128.0), -1) * quick::exp_of_rest(of(1.0 / 128.0), 0), of(1.0), 80));
    }
}
