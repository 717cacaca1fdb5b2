//! Entries of several numbers each, with an array for each number, so that lanes load and store several entries at
//! once.

use crate::simd::SimdF64;

/// `LENGTH` entries of `N` numbers each.
#[derive(Clone, Debug)]
pub struct Columns<const N: usize, const LENGTH: usize>(
    /// The array of each number.
    pub [[f64; LENGTH]; N],
);

impl<const N: usize, const LENGTH: usize> Columns<N, LENGTH> {
    /// All zero.
    pub const ZERO: Self = Self([[0.0; LENGTH]; N]);

    /// The numbers of every lane; entries beyond the lanes are zero.
    #[inline(always)]
    pub fn of_lanes<V: SimdF64>(numbers: [V; N]) -> Self {
        let mut columns = Self::ZERO;
        columns.store(0, numbers);
        columns
    }

    /// The entry at `at`.
    #[inline(always)]
    pub fn get(&self, at: usize) -> [f64; N] {
        // Not a closure: it would be compiled without the instruction set.
        let mut numbers = [0.0; N];
        for (number, column) in numbers.iter_mut().zip(&self.0) {
            *number = column[at];
        }
        numbers
    }

    /// Replaces the entry at `at`.
    #[inline(always)]
    pub fn set(&mut self, at: usize, numbers: [f64; N]) {
        for (column, number) in self.0.iter_mut().zip(numbers) {
            column[at] = number;
        }
    }

    /// The entries from `at` on, a lane each.
    #[inline(always)]
    pub fn load<V: SimdF64>(&self, at: usize) -> [V; N] {
        let mut numbers = [V::of(0.0); N];
        for (lanes, column) in numbers.iter_mut().zip(&self.0) {
            *lanes = V::load(&column[at..]);
        }
        numbers
    }

    /// Replaces the entries from `at` on, as many as there are lanes.
    #[inline(always)]
    pub fn store<V: SimdF64>(&mut self, at: usize, numbers: [V; N]) {
        for (column, lanes) in self.0.iter_mut().zip(numbers) {
            lanes.store(&mut column[at..]);
        }
    }
}
