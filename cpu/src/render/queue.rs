//! Samples that wait for the next stage, side by side: an array for each of their numbers.
//!
//! Data goes one way. Camera rays push a sample to the specular queue if its hit is refractive, and to the path queue
//! if its hit scatters. Specular chains take samples from the first queue and push those that scatter at last to a
//! third queue, which is merged into the second.

use crate::render::arrays::{CAPACITY, Values, ZEROS};
use crate::render::path_vertex::PathVertex;
use crate::simd::{SimdF64, valid_lanes};

/// Samples whose last hit was refractive: the origin and direction of the next ray, the object that it leaves, and the
/// sample's number.
pub type SpecularQueue = Queue<8>;

/// Samples whose last hit scatters: the numbers of a [`PathVertex`].
pub type PathQueue = Queue<{ PathVertex::NUMBERS }>;

/// Up to [`CAPACITY`] entries of `N` numbers each. Entries from `count` on are stale: they may be read as lanes beyond
/// the last entry, and are never used.
#[derive(Debug)]
pub struct Queue<const N: usize> {
    /// Number of entries.
    pub count: usize,
    /// The array of each number.
    pub arrays: [Values; N],
}

impl<const N: usize> Queue<N> {
    /// An empty queue.
    pub const EMPTY: Self = Self { count: 0, arrays: [ZEROS; N] };

    /// Adds the entries in the lanes that `bits` selects.
    #[inline(always)]
    pub fn push<V: SimdF64>(&mut self, numbers: [V; N], bits: u32) {
        let at = self.count;
        // All lanes are selected more often than not, because neighbours mostly hit the same surface.
        if bits == valid_lanes::<V>(V::LANES) {
            for (array, lanes) in self.arrays.iter_mut().zip(numbers) {
                lanes.store(&mut array[at..]);
            }
        } else {
            for (array, lanes) in self.arrays.iter_mut().zip(numbers) {
                lanes.compress(bits).store(&mut array[at..]);
            }
        }
        self.count += bits.count_ones() as usize;
    }

    /// Adds one entry.
    #[inline(always)]
    pub fn push_one(&mut self, numbers: [f64; N]) {
        self.set(self.count, numbers);
        self.count += 1;
    }

    /// The entries from `at` on, a lane each.
    #[inline(always)]
    pub fn load<V: SimdF64>(&self, at: usize) -> [V; N] {
        // Not a closure: it would be compiled without the instruction set.
        let mut numbers = [V::of(0.0); N];
        for (lanes, array) in numbers.iter_mut().zip(&self.arrays) {
            *lanes = V::load(&array[at..]);
        }
        numbers
    }

    /// The entry at `at`.
    #[inline(always)]
    pub fn get(&self, at: usize) -> [f64; N] {
        let mut numbers = [0.0; N];
        for (number, array) in numbers.iter_mut().zip(&self.arrays) {
            *number = array[at];
        }
        numbers
    }

    /// Moves the entries of `other` into this queue, in the order of the array `key`. Its bits are numbers below
    /// [`CAPACITY`], all different, and ascend in this queue.
    #[inline(always)]
    pub fn merge(&mut self, other: &mut Self, key: usize) {
        const NONE: u16 = u16::MAX;
        let mut place_of = [NONE; CAPACITY];
        for (place, number) in other.arrays[key][..other.count].iter().enumerate() {
            place_of[number.to_bits() as usize % CAPACITY] = place as u16;
        }
        // From the last entry to the first, so that no entry is overwritten before it has moved.
        let (mut from, mut to) = (self.count, self.count + other.count);
        (self.count, other.count) = (to, 0);
        for (number, &place) in place_of.iter().enumerate().rev() {
            if place == NONE {
                continue;
            }
            while from > 0 && self.arrays[key][from - 1].to_bits() > number as u64 {
                (from, to) = (from - 1, to - 1);
                self.set(to, self.get(from));
            }
            to -= 1;
            self.set(to, other.get(place as usize));
        }
    }

    #[inline(always)]
    fn set(&mut self, at: usize, numbers: [f64; N]) {
        for (array, number) in self.arrays.iter_mut().zip(numbers) {
            array[at] = number;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::arrays::SAMPLES;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    /// Pushes every third of 240 entries as lanes, and merges 9 others, pushed one by one.
    struct Fill;

    impl Kernel for Fill {
        type Output = Queue<2>;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> Self::Output {
            let (mut queue, mut other) = (Queue::EMPTY, Queue::EMPTY);
            for at in (0..240).step_by(S::F64::LANES) {
                let samples = S::F64::load(&SAMPLES[at..]);
                let bits = (0..S::F64::LANES).map(|lane| u32::from((at + lane) % 3 == 0) << lane).sum();
                queue.push([samples, -samples], bits);
            }
            for sample in (0..9).rev().map(|place| f64::from_bits(27 * place + 1)) {
                other.push_one([sample, -sample]);
            }
            let mut lanes = [0.0; 16];
            queue.load::<S::F64>(3)[1].store(&mut lanes);
            assert_eq!(lanes[..2], [9, 12].map(|sample| -f64::from_bits(sample)));
            queue.merge(&mut other, 0);
            assert_eq!(other.count, 0);
            queue
        }
    }

    #[test]
    fn selected_lanes_and_single_entries_are_merged_in_order() {
        let expected: Vec<_> =
            (0..240).filter(|sample| sample % 3 == 0 || sample % 27 == 1).map(f64::from_bits).collect();
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            let queue = set.run(Fill);
            assert_eq!(queue.arrays[0][..queue.count], expected, "{}", set.name());
            assert!((0..queue.count).all(|at| queue.get(at) == [expected[at], -expected[at]]), "{}", set.name());
        }
    }
}
