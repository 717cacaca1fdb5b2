//! A list of entries of several numbers each. The list has one array for each number of an entry. So lanes load and
//! store several entries at once.

use crate::simd::SimdF64;

/// A list of `LENGTH` entries of `N` numbers each.
#[derive(Clone, Debug)]
pub struct Columns<const N: usize, const LENGTH: usize>(
    /// One array for each of the `N` numbers.
    pub [[f64; LENGTH]; N],
);

impl<const N: usize, const LENGTH: usize> Columns<N, LENGTH> {
    /// Entries whose numbers are all zero.
    pub const ZERO: Self = Self([[0.0; LENGTH]; N]);

    /// Returns a list whose first entries are the lanes: entry `i` has the numbers of lane `i`. All other entries are
    /// zero.
    #[inline(always)]
    pub(crate) fn of_lanes<V: SimdF64>(numbers: [V; N]) -> Self {
        let mut columns = Self::ZERO;
        columns.store(0, numbers);
        columns
    }

    /// Returns the entry at index `at`.
    #[inline(always)]
    pub(crate) fn get(&self, at: usize) -> [f64; N] {
        // This is a loop and no closure; see `Kernel::call`.
        let mut numbers = [0.0; N];
        for (number, column) in numbers.iter_mut().zip(&self.0) {
            *number = column[at];
        }
        numbers
    }

    /// Replaces the entry at index `at`.
    #[inline(always)]
    pub(crate) fn set(&mut self, at: usize, numbers: [f64; N]) {
        for (column, number) in self.0.iter_mut().zip(numbers) {
            column[at] = number;
        }
    }

    /// Returns the entries from index `at` on, one in each lane.
    #[inline(always)]
    pub(crate) fn load<V: SimdF64>(&self, at: usize) -> [V; N] {
        let mut numbers = [V::of(0.0); N];
        for (lanes, column) in numbers.iter_mut().zip(&self.0) {
            *lanes = V::load(&column[at..]);
        }
        numbers
    }

    /// Replaces the entries from index `at` on by the lanes, one entry for each lane.
    #[inline(always)]
    pub(crate) fn store<V: SimdF64>(&mut self, at: usize, numbers: [V; N]) {
        for (column, lanes) in self.0.iter_mut().zip(numbers) {
            lanes.store(&mut column[at..]);
        }
    }
}
