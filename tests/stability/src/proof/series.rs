//! The errors of the series of `math/fixed_point.rs`, whose operations truncate.

use cpu::internals::math::fixed_point::{UNITS_PER_BIT, Units, quarters, two_atanh};

use super::row::Row;

/// Bounds of a fixed-point number that is truncated, both in units. They are computed in `f64`, whose rounding is far
/// below the slack.
#[derive(Clone, Copy, Debug)]
struct Counted {
    /// The exact number is at most this.
    most: f64,
    /// The truncated number is lower than the exact one by at most this.
    error: f64,
}

impl Units for Counted {
    fn of(integer: u64, shift: usize) -> Self {
        Self { most: integer as f64 * 2.0_f64.powi(shift as i32), error: 0.0 }
    }
    fn times(&self, other: &Self, bits: usize) -> Self {
        let unit = 0.5_f64.powi(bits as i32);
        let (share, other_share) = (self.most * unit, other.most * unit);
        Self { most: self.most * other_share, error: share * other.error + other_share * self.error + 1.0 }
    }
    fn over(&self, divisor: u64) -> Self {
        Self { most: self.most / divisor as f64, error: self.error / divisor as f64 + 1.0 }
    }
    fn plus(&self, other: &Self) -> Self {
        Self { most: self.most + other.most, error: self.error + other.error }
    }
    /// The exact number is truncated to 0. If the error truncated it before, it counts with its error.
    fn is_zero(&self) -> bool {
        self.most < 1.0
    }
}

/// Returns the row of the error of a series, in units for each bit.
///
/// The logarithm's quotient is at most 1/3, and the angle at most 1.58. All bounds grow with them. The terms that are
/// left out are below one unit, and each is at most a ninth of the one before. The callers begin with 192 bits, and
/// double them until they decide. More bits than these need less for each bit, because the first terms count less.
#[must_use]
pub fn row() -> Row {
    let errors = [192, 384, 768].map(|bits| {
        let angle = Counted { most: 1.58 * 2.0_f64.powi(bits as i32), error: 0.0 };
        let [cosine, sine, minus_cosine, minus_sine] = quarters(&angle, bits).map(|sum| sum.error);
        let logarithm: Counted = two_atanh(1, 3, bits);
        let most = logarithm.error.max(cosine + minus_cosine).max(sine + minus_sine);
        (most + 2.0) / bits as f64
    });
    let [need, ..] = errors;
    assert!(errors.is_sorted_by(|a, b| a >= b), "more bits need less");
    let margins = [UNITS_PER_BIT * 1000.0, need * 1000.0];
    Row::new("logarithms, sines and cosines", "math/fixed_point.rs", margins, "10^-3 units a bit")
}
