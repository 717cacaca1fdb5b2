//! The tangent of an angle, correctly rounded, so that it has the same bits on every system.

use crate::math::dyadic::{Dyadic, integer_and_exponent};
use crate::math::fixed_point::sine_and_cosine;
use crate::math::nearest::{Midpoint, certain_sign, nearest};

/// Returns the tangent of an angle from 0 to `pi / 2`, in radians, correctly rounded. It takes some ten microseconds.
///
/// To round the tangent, it is compared with midpoints of neighbouring `f64`. The tangent of an `f64` other than 0 is
/// transcendental, so it never equals a midpoint, and a comparison with enough bits always decides. NaN and angles
/// outside of the range give NaN.
pub fn tangent(angle: f64) -> f64 {
    /// Below this angle `angle^3 / 3` is less than half a unit in the last place, so the `f64` nearest to the tangent
    /// is the angle itself (checked for every exponent in `tests/stability/tests/all/functions.rs`).
    const SMALL: f64 = 1.0 / (1_u64 << 27) as f64;

    if (0.0..SMALL).contains(&angle) {
        return angle;
    }
    if !(SMALL..=std::f64::consts::FRAC_PI_2).contains(&angle) {
        return f64::NAN;
    }
    // 192 bits nearly always decide.
    let mut bits = 192;
    loop {
        if let Some(tangent) = rounded(angle, bits) {
            return tangent;
        }
        bits *= 2;
    }
}

/// Returns the tangent if `bits` bits decide its rounding, and otherwise `None`.
fn rounded(angle: f64, bits: usize) -> Option<f64> {
    let (integer, exponent) = integer_and_exponent(angle);
    let ([sine, cosine], error_bound) = sine_and_cosine(integer, exponent, bits);
    let candidate = sine.to_double_double(0).high / cosine.to_double_double(0).high;
    nearest(candidate, |Midpoint { integer, exponent }| {
        // The tangent is above the midpoint if `sine - midpoint cosine` is positive.
        let midpoint = Dyadic::of_limbs(vec![integer], exponent);
        let difference = &sine - &(&midpoint * &cosine);
        let error_bound = &error_bound + &(&midpoint * &error_bound);
        certain_sign(&difference, &error_bound)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_tangents() {
        assert_eq!(tangent(0.0), 0.0);
        assert_eq!(tangent(1e-300), 1e-300);
        assert_eq!(tangent(std::f64::consts::FRAC_PI_4), 0.999_999_999_999_999_9);
        assert_eq!(tangent(std::f64::consts::FRAC_PI_2), 16_331_239_353_195_370.0);
        assert!([-1e-9, 1.6, f64::INFINITY, f64::NAN].map(tangent).iter().all(|value| value.is_nan()));
    }
}
