//! Lanes as arrays, for machines that have no other instruction set of this program. They need no unsafe code.

use std::array;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use crate::math::{real::Real, real::functions, rounding::Rounding};
use crate::simd::{Kernel, Simd, SimdF32, SimdF64};

/// The portable instruction set: lanes are arrays of four numbers, for `f64` and for `f32`. It needs nothing special of
/// the machine, so every machine has it.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

impl Simd for Portable {
    type F64 = Array<f64>;
    type F32 = Array<f32>;

    #[inline(never)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.call(self)
    }
}

/// Four lanes, which hold numbers or results of comparisons.
#[derive(Clone, Copy, Debug)]
pub struct Array<T>([T; 4]);

macro_rules! operators {
    ($($trait:ident $method:ident $operator:tt),+) => {
        $(impl<T: Copy + $trait<Output = T>> $trait for Array<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(array::from_fn(|lane| self.0[lane] $operator other.0[lane]))
            }
        })+
    };
}
operators!(Add add +, Sub sub -, Mul mul *, Div div /, BitAnd bitand &, BitOr bitor |);

impl<T: Neg<Output = T>> Neg for Array<T> {
    type Output = Self;
    functions! {
        fn neg(self) -> Self { Self(self.0.map(T::neg)) }
    }
}

impl<T: Not<Output = T>> Not for Array<T> {
    type Output = Self;
    functions! {
        fn not(self) -> Self { Self(self.0.map(T::not)) }
    }
}

impl<T: Copy> Array<T> {
    functions! {
        fn first(values: &[T]) -> Self { Self([values[0], values[1], values[2], values[3]]) }
        fn compare(self, other: Self, test: impl Fn(&T, &T) -> bool) -> Array<bool> {
            Array(array::from_fn(|lane| test(&self.0[lane], &other.0[lane])))
        }
        fn choose(mask: Array<bool>, yes: Self, no: Self) -> Self {
            Self(array::from_fn(|lane| if mask.0[lane] { yes.0[lane] } else { no.0[lane] }))
        }
    }
}

impl Real for Array<f64> {
    type Mask = Array<bool>;

    functions! {
        fn of(value: f64) -> Self { Self([value; 4]) }
        fn sqrt(self) -> Self { Self(self.0.map(f64::sqrt)) }
        fn abs(self) -> Self { Self(self.0.map(f64::abs)) }
        fn less(self, other: Self) -> Array<bool> { self.compare(other, f64::lt) }
        fn less_equal(self, other: Self) -> Array<bool> { self.compare(other, f64::le) }
        fn select(mask: Array<bool>, yes: Self, no: Self) -> Self { Self::choose(mask, yes, no) }
    }
}

impl Rounding for Array<f64> {
    functions! {
        fn mul_add(self, factor: Self, term: Self) -> Self {
            Self(array::from_fn(|lane| self.0[lane].mul_add(factor.0[lane], term.0[lane])))
        }
        fn mul_add_loosely(self, factor: Self, term: Self) -> Self { self * factor + term }
    }
}

impl SimdF64 for Array<f64> {
    const LANES: usize = 4;

    functions! {
        fn load(values: &[f64]) -> Self { Self::first(values) }
        fn store(self, place: &mut [f64]) { place[..4].copy_from_slice(&self.0) }
        fn bits(mask: Array<bool>) -> u32 { (0..4).map(|lane| u32::from(mask.0[lane]) << lane).sum() }
    }
}

impl SimdF32 for Array<f32> {
    const LANES: usize = 4;

    functions! {
        fn splat(value: f32) -> Self { Self([value; 4]) }
        fn load(values: &[f32]) -> Self { Self::first(values) }
        fn load_bytes(bytes: &[u8]) -> Self { Self([0, 1, 2, 3].map(|lane| f32::from(bytes[lane]))) }
        fn store(self, place: &mut [f32]) { place[..4].copy_from_slice(&self.0) }
        fn mul_add(self, factor: Self, term: Self) -> Self { self * factor + term }
        fn negative_mul_add(self, factor: Self, term: Self) -> Self { term - self * factor }
        fn min(self, other: Self) -> Self { Self::choose(self.compare(other, f32::lt), self, other) }
        fn max(self, other: Self) -> Self { Self::choose(self.compare(other, f32::gt), self, other) }
        fn less_equal(self, other: Self) -> u32 { Array::<f64>::bits(self.compare(other, f32::le)) }
    }
}
