//! A set of a batch's samples, a bit each, asked for by as many at once as there are lanes.

use crate::render::arrays::CAPACITY;

/// Bits of a word; every instruction set's lanes divide it.
const WORD: usize = u64::BITS as usize;

/// Which samples, or which places in the queue.
#[derive(Clone, Debug)]
pub struct SampleSet([u64; CAPACITY / WORD]);

impl SampleSet {
    /// No sample.
    pub const EMPTY: Self = Self([0; CAPACITY / WORD]);

    /// Adds those of the samples from `at` on that `bits` selects. `at` is a multiple of as many lanes as there are.
    #[inline(always)]
    pub const fn add(&mut self, at: usize, bits: u32) {
        self.0[at / WORD] |= (bits as u64) << (at % WORD);
    }

    /// Removes a sample.
    #[inline(always)]
    pub const fn remove(&mut self, sample: usize) {
        self.0[sample / WORD] &= !(1 << (sample % WORD));
    }

    /// Which of the `lanes` samples from `at` on, a multiple of `lanes`, are in the set, as bits.
    #[inline(always)]
    pub const fn bits(&self, at: usize, lanes: usize) -> u32 {
        (self.0[at / WORD] >> (at % WORD)) as u32 & ((1 << lanes) - 1)
    }

    /// Whether no sample is in it.
    pub fn is_empty(&self) -> bool {
        self.0 == Self::EMPTY.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_added_and_asked_for_by_lanes() {
        let mut set = SampleSet::EMPTY;
        assert!(set.is_empty());
        set.add(56, 0b1010_0001);
        set.add(64, 0b11);
        assert_eq!([56, 60, 62].map(|at| set.bits(at, 2)), [0b01, 0b10, 0b10]);
        assert_eq!((set.bits(56, 8), set.bits(60, 4), set.bits(64, 8)), (0b1010_0001, 0b1010, 0b11));
        set.remove(61);
        set.remove(64);
        assert_eq!((set.bits(56, 8), set.bits(64, 8), set.is_empty()), (0b1000_0001, 0b10, false));
    }
}
