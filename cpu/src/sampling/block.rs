//! Draws the stream of [`crate::sampling::uniform::Uniform`], in blocks of 312 numbers. Pictures draw from this one.
//!
//! `mt19937_64` (Nishimura and Matsumoto, 2000) renews its whole state of 312 words at once. To renew, temper and
//! convert the words, there are loops without branches, which the compiler turns into lanes. A test compares 10^8 draws
//! with the crate `rand_mt`.

use crate::sampling::uniform::canonical;

/// Number of words in the state of the generator.
const LENGTH: usize = 312;
/// Half of the state, in words.
const MIDDLE: usize = 156;

/// Number of words stored before the state: copies of the last words of the previous state. With four of them,
/// [`renew`] can renew the 312 words in two loops of 152 and 160 words, which are multiples of 8 lanes. Half of the
/// state, 156 words, is no such multiple.
const LEAD: usize = 4;

/// The last [`LEAD`] words of the previous state, then the [`LENGTH`] words of the state, then its first word again.
type State = [u64; LEAD + LENGTH + 1];

/// A stream of random numbers in `[0, 1)`.
#[derive(Clone, Debug)]
pub struct BlockUniform {
    state: Box<State>,
    /// Number of words of the state that have been drawn or skipped.
    used: usize,
}

impl BlockUniform {
    /// Returns the stream of the generator `std::mt19937_64(seed)`.
    pub fn new(seed: u64) -> Self {
        const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
        let mut state = Box::new([seed; LEAD + LENGTH + 1]);
        for index in 1..LENGTH {
            let before = state[LEAD + index - 1];
            state[LEAD + index] = (before ^ (before >> 62)).wrapping_mul(MULTIPLIER).wrapping_add(index as u64);
        }
        Self { state, used: LENGTH }
    }

    /// Calls `visit` with each word of the stream's state, to read or to replace it.
    pub(crate) fn visit(&mut self, visit: &mut impl FnMut(&mut u64)) {
        let mut used = self.used as u64;
        visit(&mut used);
        self.used = LENGTH.min(used as usize);
        self.state.iter_mut().for_each(visit);
    }

    /// Fills `draws` with the next random numbers of the stream.
    #[inline(always)]
    pub fn fill(&mut self, mut draws: &mut [f64]) {
        while !draws.is_empty() {
            if self.used == LENGTH {
                renew(&mut self.state);
                self.used = 0;
            }
            let count = draws.len().min(LENGTH - self.used);
            let (first, remaining) = draws.split_at_mut(count);
            let words = &self.state[LEAD + self.used..LEAD + self.used + count];
            for (draw, &word) in first.iter_mut().zip(words) {
                *draw = canonical(temper(word));
            }
            self.used += count;
            draws = remaining;
        }
    }

    /// Skips `count` random numbers. This is faster than drawing, because their words are neither tempered nor
    /// converted.
    #[inline(always)]
    pub fn skip(&mut self, mut count: u64) {
        loop {
            let left = (LENGTH - self.used) as u64;
            if count <= left {
                self.used += count as usize;
                return;
            }
            count -= left;
            renew(&mut self.state);
            self.used = 0;
        }
    }
}

/// Computes the next state. A new word depends on the old word at its place, the next word, and the word half a state
/// away.
#[inline(always)]
fn renew(state: &mut State) {
    // Both loops must begin at a multiple of the lanes. So the second begins four words before the middle of the state.
    // The words half a state away from these four are the last four words of the old state.
    state.copy_within(LENGTH..LENGTH + LEAD, 0);
    renew_some::<{ MIDDLE - LEAD }>(state, LEAD, LEAD + MIDDLE);
    state[LEAD + LENGTH] = state[LEAD];
    renew_some::<{ LENGTH - MIDDLE + LEAD }>(state, MIDDLE, 0);
}

/// Renews the `COUNT` words from index `at` on. The words half a state away from them begin at index `half`.
#[inline(always)]
fn renew_some<const COUNT: usize>(state: &mut State, at: usize, half: usize) {
    for index in 0..COUNT {
        state[at + index] = state[half + index] ^ twist(state[at + index], state[at + index + 1]);
    }
}

/// Returns the word by which the generator combines two words of its state (Matsumoto and Nishimura, MT19937-64).
#[inline(always)]
fn twist(high: u64, low: u64) -> u64 {
    const UPPER: u64 = 0xFFFF_FFFF_8000_0000;
    const MATRIX: u64 = 0xB502_6F5A_A966_19E9;
    let word = (high & UPPER) | (low & !UPPER);
    (word >> 1) ^ ((word & 1).wrapping_neg() & MATRIX)
}

/// Returns the random number of a word of the state.
#[inline(always)]
fn temper(mut word: u64) -> u64 {
    word ^= (word >> 29) & 0x5555_5555_5555_5555;
    word ^= (word << 17) & 0x71D6_7FFF_EDA6_0000;
    word ^= (word << 37) & 0xFFF7_EEE0_0000_0000;
    word ^ (word >> 43)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::uniform::Uniform;

    #[test]
    fn the_stream_is_rand_mts() {
        // miri interprets each step, so there the test only draws enough to renew the state several times.
        let total = if cfg!(miri) { 3_000 } else { 100_000_000 };
        let (mut block, mut single) = (BlockUniform::new(45), Uniform::new(45));
        let mut draws = [0.0; 1000];
        for _ in 0..total / draws.len() {
            block.fill(&mut draws);
            for draw in draws {
                assert_eq!(draw, single.canonical());
            }
        }
    }

    #[test]
    fn skipping_advances_the_stream_as_drawing_does() {
        for (before, skipped) in [(0, 0), (0, 312), (1, 311), (5, 312), (311, 2), (312, 624), (100, 10_000), (7, 3)] {
            let (mut block, mut single) = (BlockUniform::new(7), Uniform::new(7));
            let mut draws = vec![0.0; before];
            block.fill(&mut draws);
            block.skip(skipped);
            (0..before as u64 + skipped).for_each(|_| _ = single.canonical());
            let mut draws = [0.0; 400];
            block.fill(&mut draws);
            for draw in draws {
                assert_eq!(draw, single.canonical(), "{before} drawn, {skipped} skipped");
            }
        }
    }
}
