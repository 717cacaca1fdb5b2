//! The rule from a mean to a byte (specification, section 5.2): `trunc(255 * mean^(1 / gamma))`, at most 255, and 0 for
//! NaN. `render/accumulation.rs` has the mean: the sum of the samples in their order, divided by their number.
//!
//! [`quantize`] is the definition, which the reference uses too. `web/site/src/gpu/develop.wgsl` has a copy in f32,
//! for the live view. Tests of WGSL compare the means. The power is slow, so [`Quantizer`] has a table with the
//! interval of means of each of the 256 bytes. It calls [`quantize`] only for means close to a boundary, where the
//! rounding of the power decides, for means below -1/16, and for NaN. With a gamma of 1e14 or more the
//! boundaries are uncertain, so [`quantize`] is called for most means.
//!
//! A mean can be negative: if the length of a ray underflows, the weight of the background is outside of `[0, 1]`. The
//! power of a negative mean is NaN, except if `1 / gamma` is a whole number. It is positive if that number is even.

use crate::counters::{Counter, add};
use crate::math::{power as correctly_rounded, real::Real};
use crate::simd::fused::run_fused;

/// Returns the byte of a channel with this mean: `trunc(255 * mean^(1 / gamma))`, limited to 0 to 255, and 0 if the
/// power is NaN. This is the definition of the byte. Each call computes a power, so the renderer uses the faster
/// [`Quantizer`].
pub fn quantize(mean: f64, gamma: f64) -> u8 {
    // A float-to-integer cast truncates, saturates at 0 and 255, and turns "not a number" into 0.
    channel_level(mean, gamma) as u8
}

/// Returns `255 mean^(1 / gamma)`, which is truncated to the byte.
#[inline]
pub fn channel_level<T: Power>(mean: T, gamma: T) -> T {
    T::of(255.0) * mean.power(T::of(1.0) / gamma)
}

/// A number with powers.
pub trait Power: Real {
    /// Returns the power, correctly rounded.
    fn power(self, exponent: Self) -> Self;
}

impl Power for f64 {
    /// Uses fused multiply-add if the machine has it.
    #[inline]
    fn power(self, exponent: Self) -> Self {
        let (base, exponent) = (&self, &exponent);
        run_fused!(|base: &f64, exponent: &f64| -> f64 { correctly_rounded::power(*base, *exponent) })
    }
}

/// Number of equal cells into which [`Quantizer::first_guess`] divides the means in `[0, 1)`.
const CELLS: usize = 4096;

/// The lowest mean for which the table is used. A negative mean that is not lower gives the byte 0 with every gamma.
/// The power is NaN, negative or at most `(1 / 16)^2`, and 255 times that is `255 / 256`, which is truncated to 0.
const LOWEST: f64 = -1.0 / 16.0;

/// A table for one gamma. It gives the same bytes as the function [`quantize()`], mostly without computing a power.
#[derive(Clone, Debug)]
pub struct Quantizer {
    gamma: f64,
    /// The bounds of each byte. With `bounds[k] = (below, from)`, a mean of at least `from` gives the byte `k` or more.
    /// A mean of at least [`LOWEST`] and at most `below` gives a byte less than `k`. `k` is from 0 to 256.
    bounds: Box<[(f64, f64); 257]>,
    /// For each cell, the byte of the cell's lowest mean, or a lower byte.
    first_guess: Box<[u8; CELLS]>,
}

impl Quantizer {
    /// Computes the table for a positive `gamma`.
    pub fn new(gamma: f64) -> Self {
        let mut bounds = Box::new([(f64::INFINITY, f64::INFINITY); 257]);
        bounds[0] = (f64::NEG_INFINITY, LOWEST);
        for (byte, bound) in bounds.iter_mut().enumerate().take(256).skip(1) {
            *bound = bound_of(byte as f64 / 255.0, gamma);
        }
        let mut first_guess = Box::new([0; CELLS]);
        let mut byte = 0;
        for (cell, guess) in first_guess.iter_mut().enumerate() {
            let mean = cell as f64 / CELLS as f64;
            while byte < 255 && mean >= bounds[byte + 1].1 {
                byte += 1;
            }
            *guess = byte as u8;
        }
        Self { gamma, bounds, first_guess }
    }

    /// Returns the byte of a channel with this mean: the byte of [`quantize`].
    #[inline]
    pub fn quantize(&self, mean: f64) -> u8 {
        let (byte, below) = self.last_reached(mean);
        if mean > below {
            return self.at_a_boundary(mean);
        }
        if mean >= LOWEST { byte } else { quantize(mean, self.gamma) }
    }

    /// Returns the byte that every mean from `low` to `high` certainly gives, or `None` if they may give different
    /// bytes. `guess` is tried first, which is fastest if it is right.
    #[inline]
    pub fn quantize_interval(&self, low: f64, high: f64, guess: u8) -> Option<u8> {
        if self.holds(guess, low, high) {
            return Some(guess);
        }
        let (byte, _) = self.last_reached(low);
        self.holds(byte, low, high).then_some(byte)
    }

    /// Returns the largest byte `k` that `mean` certainly reaches, because `from` in `bounds[k]` is at most `mean`.
    /// Also returns `below` in `bounds[k + 1]`. Negative means and NaN give byte 0.
    #[inline]
    fn last_reached(&self, mean: f64) -> (u8, f64) {
        // Negative means and NaN land in cell 0.
        let cell = ((mean * CELLS as f64) as usize).min(CELLS - 1);
        let mut byte = usize::from(self.first_guess[cell]);
        loop {
            let (below, from) = self.bounds[byte + 1];
            if byte < 255 && mean >= from {
                byte += 1;
            } else {
                return (byte as u8, below);
            }
        }
    }

    /// Whether every mean from `low` to `high` certainly gives this byte.
    #[inline]
    fn holds(&self, byte: u8, low: f64, high: f64) -> bool {
        let byte = usize::from(byte);
        low <= high && low >= self.bounds[byte].1 && high <= self.bounds[byte + 1].0
    }

    /// Returns the byte of a mean next to a boundary between two bytes, by a power.
    #[cold]
    fn at_a_boundary(&self, mean: f64) -> u8 {
        if mean == 1.0 {
            // The pixel is white, and any power of 1 is 1.
            return u8::MAX;
        }
        add(Counter::Powers, 1);
        quantize(mean, self.gamma)
    }
}

/// Returns `(below, from)` around the boundary `root^gamma`. A mean of at most `below` is certainly below the boundary,
/// and a mean of at least `from` is certainly not below it.
///
/// `tests/stability/src/proof/bytes.rs` proves that the room covers the rounding if it is below 1/2.
fn bound_of(root: f64, gamma: f64) -> (f64, f64) {
    let (room, [below, from]) = around(root, gamma);
    // With an extreme gamma nothing is certain. Then a power is computed for every mean.
    if !(below.is_finite() && room < 0.5) {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    // A boundary that underflows is below the smallest normal number.
    let underflows = from <= f64::MIN_POSITIVE;
    (if underflows { f64::NEG_INFINITY } else { below }, from.max(2.0 * f64::MIN_POSITIVE))
}

/// The room on both sides of a boundary, in units of the boundary, for a gamma near 0.
pub const ROOM_FOR_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Returns the room, and the boundary `root^gamma` moved down and up by the room.
#[inline]
pub fn around<T: Power>(root: T, gamma: T) -> (T, [T; 2]) {
    let (one, boundary) = (T::of(1.0), root.power(gamma));
    let room = T::of(ROOM_FOR_ROUNDING) * (one + gamma);
    (room, [boundary * (one - room), boundary * (one + room)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAMMAS: [f64; 14] = [1.0, 2.2, 2.1, 2.6, 2.5, 1.8, 0.45, 0.5, 0.25, 0.1, 10.0, 100.0, 1e-3, 3.0];

    #[test]
    fn the_definition_truncates_and_clips() {
        assert_eq!(quantize(0.5, 1.0), 127);
        assert_eq!(quantize(1.0, 2.2), 255);
        assert_eq!(quantize(1.5, 1.0), 255);
        assert_eq!(quantize(-1e-17, 1.0), 0);
        assert_eq!(quantize(-1e-17, 2.2), 0);
        assert_eq!(quantize(f64::NAN, 2.2), 0);
        assert_eq!(quantize(0.25, 2.0), 127);
    }

    #[test]
    fn the_table_has_the_byte_of_every_mean() {
        // The power is correctly rounded, so the byte never falls where the mean grows. So the ends of an interval
        // decide about all means between them, and nothing is left to try.
        for gamma in GAMMAS.into_iter().chain([128.0, 1e3, 1e13, 1e300, 1e-300, f64::MIN_POSITIVE, f64::MAX]) {
            let table = Quantizer::new(gamma);
            for byte in 1..=255 {
                let (below, from) = table.bounds[usize::from(byte)];
                assert!(below < 0.0 || quantize(below, gamma) < byte, "gamma {gamma}, below {byte}");
                assert!(from.is_infinite() || quantize(from, gamma) >= byte, "gamma {gamma}, from {byte}");
                if below > 0.0 && from.is_finite() {
                    // Between the bounds a power decides, except for a mean of 1.
                    for mean in [below.next_up(), f64::midpoint(below, from), from.next_down()] {
                        assert_eq!(table.quantize(mean), quantize(mean, gamma), "gamma {gamma}, mean {mean:e}");
                    }
                }
                let (last, _) = table.bounds[usize::from(byte) + 1];
                if from <= last && byte < 255 {
                    assert_eq!(table.quantize_interval(from, last, byte), Some(byte), "gamma {gamma}");
                    assert_eq!(table.quantize_interval(from.next_down(), last, byte), None, "gamma {gamma}");
                    assert_eq!(table.quantize_interval(from, last.next_up(), byte), None, "gamma {gamma}");
                }
            }
            for (cell, &guess) in table.first_guess.iter().enumerate() {
                assert!(guess == 0 || table.bounds[usize::from(guess)].1 <= cell as f64 / CELLS as f64);
            }
        }
        assert_eq!(Quantizer::new(2.2).quantize_interval(f64::NAN, f64::NAN, 0), None);
    }

    #[test]
    fn special_means_have_their_bytes() {
        for gamma in GAMMAS {
            let table = Quantizer::new(gamma);
            let negative = [-1e-17, LOWEST.next_up(), LOWEST, LOWEST.next_down(), -0.1, -0.5, -2.0, f64::NEG_INFINITY];
            for mean in [0.0, -0.0, 1.0, 1.0_f64.next_up(), 2.0, f64::INFINITY, f64::NAN].into_iter().chain(negative) {
                assert_eq!(table.quantize(mean), quantize(mean, gamma), "gamma {gamma}, mean {mean:e}");
            }
        }
    }

    #[test]
    fn a_narrow_interval_has_a_byte_in_99_of_100_cases_for_any_guess() {
        let mut draws = crate::sampling::uniform::Uniform::new(9);
        for gamma in [1.0, 2.2, 0.45] {
            let table = Quantizer::new(gamma);
            let mut known = 0;
            for guess in (0..=255).cycle().take(10_000) {
                let low = draws.canonical();
                if let Some(byte) = table.quantize_interval(low, low + 1e-9, guess) {
                    assert_eq!(byte, quantize(low, gamma), "gamma {gamma}, from {low:e}");
                    known += 1;
                }
            }
            assert!(known > 9_900, "gamma {gamma}: {known} of 10,000");
        }
    }

    #[test]
    fn bounds_of_extreme_gammas_are_normal_or_infinite() {
        // In the first case the boundary underflows. In the second case the bounds would be farther apart than the
        // boundary.
        for (root, gamma, from) in [(1.0 / 255.0, 1000.0, 2.0 * f64::MIN_POSITIVE), (1.0, 1e15, f64::INFINITY)] {
            assert_eq!(bound_of(root, gamma), (f64::NEG_INFINITY, from));
        }
    }

    #[test]
    fn a_common_gamma_hardly_ever_needs_the_power() {
        let table = Quantizer::new(2.2);
        let uncertain: f64 = table.bounds[1..256].iter().map(|(below, from)| from - below).sum();
        assert!(uncertain < 1e-9, "{uncertain:e} of all means");
    }
}
