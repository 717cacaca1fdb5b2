//! Queues of samples that wait for the next stage. There is an array for each number of a sample.
//!
//! Data flow in one direction. Camera rays push a sample to the specular queue if its hit is refractive, and to the
//! path queue if its hit is matte or metal. Specular chains take samples from the specular queue. They push the samples
//! that reach a matte or metal surface to a third queue, which is merged into the path queue.

use crate::render::{arrays::CAPACITY, arrays::ROOM, path_vertex::PathVertex};
use crate::{simd::SimdF64, simd::columns::Columns, simd::valid_lanes};

/// The queue of samples whose last hit was refractive. The numbers of a sample are the origin and direction of its next
/// ray, the object on which that ray starts, and the sample's index in the span.
pub type SpecularQueue = Queue<8>;

/// The queue of samples whose last hit was matte or metal. The numbers are those of a [`PathVertex`].
pub type PathQueue = Queue<{ PathVertex::NUMBERS }>;

/// A queue of up to [`CAPACITY`] entries of `N` numbers each. Entries from `count` on have no meaning. They may be read
/// into lanes beyond the last entry, but the results of these lanes are never used.
#[derive(Debug)]
pub struct Queue<const N: usize> {
    /// Number of entries.
    pub count: usize,
    /// The entries.
    pub entries: Columns<N, ROOM>,
}

impl<const N: usize> Queue<N> {
    /// An empty queue.
    pub const EMPTY: Self = Self { count: 0, entries: Columns::ZERO };

    /// Adds an entry for each lane whose bit is set in `bits`, in the order of the lanes.
    #[inline(always)]
    pub(crate) fn push<V: SimdF64>(&mut self, numbers: [V; N], bits: u32) {
        let at = self.count;
        // Mostly all lanes are selected, because neighbouring rays mostly hit the same surface.
        if bits == valid_lanes::<V>(V::LANES) {
            self.entries.store(at, numbers);
        } else {
            for (column, lanes) in self.entries.0.iter_mut().zip(numbers) {
                lanes.store_selected(bits, &mut column[at..]);
            }
        }
        self.count += bits.count_ones() as usize;
    }

    /// Adds one entry.
    #[inline(always)]
    pub(crate) fn push_one(&mut self, numbers: [f64; N]) {
        self.entries.set(self.count, numbers);
        self.count += 1;
    }

    /// Moves the entries of `other` into this queue, so that all entries are sorted by their number at index `key`. The
    /// bits of this number are an integer below [`CAPACITY`], and no integer may occur twice. This queue must be sorted
    /// already. `other` need not be sorted.
    #[inline(always)]
    pub(crate) fn merge(&mut self, other: &mut Self, key: usize) {
        const NONE: u16 = u16::MAX;
        let mut entry_of = [NONE; CAPACITY];
        debug_assert!(self.entries.0[key][..self.count].is_sorted_by_key(|number| number.to_bits()));
        for (entry, number) in other.entries.0[key][..other.count].iter().enumerate() {
            debug_assert!(number.to_bits() < CAPACITY as u64 && entry_of[number.to_bits() as usize] == NONE);
            entry_of[number.to_bits() as usize % CAPACITY] = entry as u16;
        }
        // The loop goes from the last entry to the first, so that no entry is overwritten before it has moved.
        let (mut from, mut to) = (self.count, self.count + other.count);
        (self.count, other.count) = (to, 0);
        for (number, &entry) in entry_of.iter().enumerate().rev() {
            if entry == NONE {
                continue;
            }
            while from > 0 && self.entries.0[key][from - 1].to_bits() > number as u64 {
                (from, to) = (from - 1, to - 1);
                self.entries.set(to, self.entries.get(from));
            }
            to -= 1;
            self.entries.set(to, other.entries.get(entry as usize));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::arrays::SAMPLES;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    /// A kernel that pushes every third of 240 entries in lanes, and merges 9 other entries, which are pushed one by
    /// one.
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
            for sample in (0..9).rev().map(|number| f64::from_bits(27 * number + 1)) {
                other.push_one([sample, -sample]);
            }
            let mut lanes = [0.0; 16];
            queue.entries.load::<S::F64>(3)[1].store(&mut lanes);
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
        for set in InstructionSet::available() {
            let queue = set.run(Fill);
            assert_eq!(queue.entries.0[0][..queue.count], expected, "{}", set.name());
            assert!(
                (0..queue.count).all(|at| queue.entries.get(at) == [expected[at], -expected[at]]),
                "{}",
                set.name()
            );
        }
    }
}
