//! Reads the numbers of a row.

use cpu::internals::math::real::Real;
use cpu::{Ray, Vec3};

/// Reads numbers and vectors from a row, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a, T>(pub &'a [T]);

impl<T: Real> Reader<'_, T> {
    /// Removes the next number from the row, and returns it.
    ///
    /// # Panics
    /// If the row has no more numbers.
    pub fn number(&mut self) -> T {
        let (first, rest) = self.0.split_first().expect("the row is as long as its kernel says");
        self.0 = rest;
        *first
    }

    /// Removes the next three numbers from the row, and returns them as a vector.
    pub fn vector(&mut self) -> Vec3<T> {
        Vec3::new(self.number(), self.number(), self.number())
    }

    /// Removes the next six numbers from the row, and returns them as a ray.
    pub fn ray(&mut self) -> Ray<T> {
        Ray { origin: self.vector(), direction: self.vector() }
    }
}
