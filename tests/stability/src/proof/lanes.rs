//! [`Bounded`] as a lane of `f32`, for tests that load their numbers from arrays.
//!
//! Such a test takes values, not numbers of any type. So a value that has been [named](name) stands for a number with
//! bounds, and every other value is a constant, which is rounded if it is no whole
//! number.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, Mul, Sub};

use cpu::internals::math::{real::Real, rounding::Rounding};
use cpu::internals::simd::SimdF32;

use super::bounded::{self, Bounded, compared};
use super::bounds::Arithmetic;

thread_local! {
    static NAMES: RefCell<HashMap<u32, Bounded>> = RefCell::default();
}

/// Forgets all names and numbers of this thread, and begins a proof; see [`bounded::begin`].
pub fn begin(arithmetic: Arithmetic, margin: f64) {
    NAMES.with_borrow_mut(HashMap::clear);
    bounded::begin(arithmetic, margin);
}

/// Makes the value `value` stand for `number` from now on. Its negative stands for the same number.
pub fn name(value: f32, number: Bounded) {
    NAMES.with_borrow_mut(|names| names.insert(value.abs().to_bits(), number));
}

/// A lane that holds a number with bounds.
#[derive(Clone, Copy, Debug)]
pub struct Lane(pub Bounded);

impl Add for Lane {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Lane {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Lane {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl SimdF32 for Lane {
    const LANES: usize = 1;

    fn splat(value: f32) -> Self {
        let named = NAMES.with_borrow(|names| names.get(&value.abs().to_bits()).copied());
        Self(named.unwrap_or_else(|| Bounded::constant(value.into(), if value.fract() == 0.0 { 0.0 } else { 1.0 })))
    }
    fn load(values: &[f32]) -> Self {
        Self::splat(values[0])
    }
    fn load_bytes(_: &[u8]) -> Self {
        // Every byte is exact, and at most 255.
        Self(Bounded::of(255.0))
    }
    fn store(self, _: &mut [f32]) {
        // A number with bounds has no value.
    }
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.mul_add(factor.0, term.0))
    }
    fn negative_mul_add(self, factor: Self, term: Self) -> Self {
        Self(-self.0).mul_add(factor, term)
    }
    fn min(self, other: Self) -> Self {
        _ = self.0.less(other.0);
        self
    }
    fn max(self, other: Self) -> Self {
        _ = self.0.less(other.0);
        self
    }
    fn less_equal(self, other: Self) -> u32 {
        _ = self.0.less(other.0);
        compared().len() as u32
    }
}
