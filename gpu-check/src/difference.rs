//! Compares the linear colours of two pictures: the size of the differences, and the number of pixels that differ.

use std::fmt;

use cpu::Vec3;

use crate::Float;

/// The differences between two pictures, in linear channels (1 is white).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Number of compared pixels.
    pub pixels: usize,
    /// Number of pixels in which a channel has different bits. If the precisions differ, values are compared instead of
    /// bits.
    pub differing: usize,
    /// The index of the first of these pixels.
    pub first: Option<usize>,
    /// Root of the mean square of the differences of all channels.
    pub rmse: f64,
    /// The largest difference of any channel.
    pub largest: f64,
}

/// Returns the difference of two channels: 0 if both are NaN, infinity if only one is NaN.
fn distance(one: f64, other: f64) -> f64 {
    match (one.is_nan(), other.is_nan()) {
        (true, true) => 0.0,
        (false, false) => (one - other).abs(),
        _ => f64::INFINITY,
    }
}

/// Returns the differences between two pictures of equal size.
///
/// # Panics
/// If the pictures have different numbers of pixels.
#[must_use]
pub fn difference<A: Float, B: Float>(one: &[Vec3<A>], other: &[Vec3<B>]) -> Difference {
    assert_eq!(one.len(), other.len(), "pictures of one size are compared");
    let mut result = Difference { pixels: one.len(), ..Difference::default() };
    let mut squares = 0.0;
    for (index, (a, b)) in one.iter().zip(other).enumerate() {
        let mut differs = false;
        for (a, b) in a.to_array().into_iter().zip(b.to_array()) {
            let apart = distance(a.wide(), b.wide());
            differs |= apart != 0.0 || (A::PRECISION == B::PRECISION && a.bits() != b.bits() && !a.wide().is_nan());
            squares += apart * apart;
            result.largest = result.largest.max(apart);
        }
        if differs {
            result.differing += 1;
            result.first.get_or_insert(index);
        }
    }
    result.rmse = (squares / (3 * one.len()).max(1) as f64).sqrt();
    result
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, differing, rmse, largest, .. } = self;
        write!(f, "{differing} of {pixels} pixels differ, RMSE {rmse:.1e}, at most {largest:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_measured() {
        let one = [Vec3::new(0.5, 0.5, 0.5), Vec3::new(f64::NAN, 0.0, 0.0)];
        assert_eq!(difference(&one, &one), Difference { pixels: 2, ..Difference::default() });
        let other = [Vec3::new(0.5, 0.5, 0.8), Vec3::new(f64::NAN, -0.0, 0.0)];
        let found = difference(&one, &other);
        assert_eq!((found.pixels, found.differing, found.first), (2, 2, Some(0)), "a zero's sign counts");
        assert!((found.largest - 0.3).abs() < 1e-15 && (found.rmse - (0.09_f64 / 6.0).sqrt()).abs() < 1e-15);
        let not_a_number = [one[0], Vec3::ONE];
        assert_eq!(difference(&one, &not_a_number).largest, f64::INFINITY);
    }
}
