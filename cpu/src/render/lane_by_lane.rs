//! Lanes one by one, for what is not done together.

use crate::simd::SimdF64;

/// Most lanes of any instruction set.
pub const MOST_LANES: usize = 8;

/// Some numbers of every lane, in memory.
#[derive(Clone, Copy, Debug)]
pub struct LaneByLane<const NUMBERS: usize>([[f64; MOST_LANES]; NUMBERS]);

impl<const NUMBERS: usize> LaneByLane<NUMBERS> {
    /// The lanes of these.
    #[inline(always)]
    pub fn new<V: SimdF64>(numbers: [V; NUMBERS]) -> Self {
        let mut apart = [[0.0; MOST_LANES]; NUMBERS];
        for (place, lanes) in apart.iter_mut().zip(numbers) {
            lanes.store(place);
        }
        Self(apart)
    }

    /// The numbers of a lane; zero beyond those of the instruction set.
    #[inline(always)]
    pub fn of(&self, lane: usize) -> [f64; NUMBERS] {
        // Not by a closure: it would be compiled without the instruction set.
        let mut numbers = [0.0; NUMBERS];
        for (number, lanes) in numbers.iter_mut().zip(&self.0) {
            *number = lanes[lane];
        }
        numbers
    }
}

/// Calls `visit` with every lane whose bit is set.
#[inline(always)]
pub fn for_each_lane(mut bits: u32, mut visit: impl FnMut(usize)) {
    while bits != 0 {
        visit(bits.trailing_zeros() as usize % MOST_LANES);
        bits &= bits - 1;
    }
}
