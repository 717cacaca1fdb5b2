//! Draws random numbers as the C++ standard library does: `std::mt19937_64` with libstdc++'s
//! `uniform_real_distribution<double>`.
//!
//! A draw takes one 64-bit word, converts it to `f64` (which rounds), divides it by 2^64 and limits it to below one.
//! The crate `rand_mt` is the generator.
//!
//! [`crate::reference`] and tests draw from this stream. Pictures draw from [`crate::sampling::block`], a second
//! generator that gives the same stream in blocks, because it renews its state in lanes: `rand_mt` makes
//! one number at a time (docs/experiments.md, row "random numbers in blocks"). The test `the_stream_is_rand_mts`
//! compares 10^8 draws of both.

use rand_mt::Mt64;

/// The largest `f64` below one, which replaces a quotient that rounds to one.
pub(crate) const BELOW_ONE: f64 = 1.0_f64.next_down();

/// A stream of random numbers with uniform distribution.
#[derive(Clone, Debug)]
pub struct Uniform {
    generator: Mt64,
}

impl Uniform {
    /// Returns the stream of the generator `std::mt19937_64(seed)`.
    pub fn new(seed: u64) -> Self {
        Self { generator: Mt64::new(seed) }
    }

    /// Returns the next random number, in `[0, 1)`.
    #[inline]
    pub fn canonical(&mut self) -> f64 {
        canonical(self.generator.next_u64())
    }

    /// Returns the next random number, scaled to `[low, high)`.
    #[inline]
    pub fn draw(&mut self, low: f64, high: f64) -> f64 {
        self.canonical() * (high - low) + low
    }
}

/// Converts a word of the generator to a number in `[0, 1)`.
#[inline(always)]
pub fn canonical(word: u64) -> f64 {
    const WORD_SCALE: f64 = 1.0 / 18_446_744_073_709_551_616.0;
    // The product with 2^-64 is exact, and so it has the bits of the quotient by 2^64.
    (word as f64 * WORD_SCALE).min(BELOW_ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generator_is_mt19937_64() {
        // C++ standard, [rand.predef]: the 10,000th invocation of a default-constructed std::mt19937_64.
        let mut generator = Mt64::new(5489);
        let last = (0..10_000).map(|_| generator.next_u64()).last();
        assert_eq!(last, Some(9_981_545_732_273_789_042));
    }

    #[test]
    fn words_become_numbers_below_one() {
        assert_eq!(canonical(0), 0.0);
        assert_eq!(canonical(1 << 63), 0.5);
        assert_eq!(canonical(u64::MAX), BELOW_ONE, "it rounds to one and is clipped");
        assert_eq!(canonical(u64::MAX - 2048), BELOW_ONE);
        assert_eq!(canonical((1 << 53) + 1), 2.0_f64.powi(-11), "the conversion rounds to even");
    }

    #[test]
    fn draws_fill_their_interval() {
        let mut draws = Uniform::new(13);
        let mut again = Uniform::new(13);
        for _ in 0..1000 {
            let value = draws.draw(-0.5, 0.5);
            assert!((-0.5..0.5).contains(&value));
            assert_eq!(value, again.canonical() - 0.5);
        }
    }
}
