//! Portable lanes that emulate a machine whose default NaN has a positive sign, as on aarch64. On x86 it is negative.
//!
//! Only tests use them, to show that no conservative test depends on the sign of a NaN.

use std::ops::{Add, Mul, Sub};

use crate::simd::portable::{Array, Portable};
use crate::simd::{Kernel, Simd, SimdF32};

/// The portable instruction set, except that its `f32` lanes hold only positive NaNs.
#[derive(Clone, Copy, Debug)]
pub struct PositiveNan;

impl Simd for PositiveNan {
    type F64 = <Portable as Simd>::F64;
    type F32 = F32;

    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.call(self)
    }
}

/// Four lanes that hold no negative NaN.
#[derive(Clone, Copy, Debug)]
pub struct F32(Array<f32>);

/// Returns the lanes, with the sign of every NaN made positive.
fn positive(lanes: Array<f32>) -> F32 {
    let mut numbers = [0.0; 4];
    lanes.store(&mut numbers);
    F32(Array::load(&numbers.map(|number: f32| if number.is_nan() { f32::NAN.copysign(1.0) } else { number })))
}

macro_rules! operators {
    ($($trait:ident $method:ident),+) => {
        $(impl $trait for F32 {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                positive(self.0.$method(other.0))
            }
        })+
    };
}
operators!(Add add, Sub sub, Mul mul);

impl SimdF32 for F32 {
    const LANES: usize = Array::<f32>::LANES;

    fn splat(value: f32) -> Self {
        positive(Array::splat(value))
    }
    fn load(values: &[f32]) -> Self {
        positive(Array::load(values))
    }
    fn store(self, place: &mut [f32]) {
        self.0.store(place);
    }
    fn mul_add(self, factor: Self, term: Self) -> Self {
        positive(self.0.mul_add(factor.0, term.0))
    }
    fn negative_mul_add(self, factor: Self, term: Self) -> Self {
        positive(self.0.negative_mul_add(factor.0, term.0))
    }
    fn min(self, other: Self) -> Self {
        positive(self.0.min(other.0))
    }
    fn max(self, other: Self) -> Self {
        positive(self.0.max(other.0))
    }
    fn less_equal(self, other: Self) -> u32 {
        self.0.less_equal(other.0)
    }
    fn load_bytes(bytes: &[u8]) -> Self {
        Self(Array::load_bytes(bytes))
    }
}
