//! Lanes as arrays, for machines without a kernel of their own, and as the twin that the others are held against.

use std::array;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use crate::math::error_free::Fused;
use crate::math::real::{MulAdd, Real};
use crate::math::rounding::Rounding;
use crate::simd::{Kernel, LaneMask, Simd, SimdF32, SimdF64};

/// The portable implementation.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

impl Simd for Portable {
    type F64 = F64x4;
    type F32 = F32x4;
    const FUSES: bool = false;

    #[inline(never)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.call(self)
    }
}

/// Four numbers.
#[derive(Clone, Copy, Debug)]
pub struct F64x4([f64; 4]);

/// Four answers.
#[derive(Clone, Copy, Debug)]
pub struct Mask4([bool; 4]);

/// Four numbers for filters.
#[derive(Clone, Copy, Debug)]
pub struct F32x4([f32; 4]);

macro_rules! elementwise {
    ($type:ident: $($trait:ident $method:ident $operator:tt),+) => {
        $(impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(array::from_fn(|lane| self.0[lane] $operator other.0[lane]))
            }
        })+
    };
}

elementwise!(F64x4: Add add +, Sub sub -, Mul mul *, Div div /);
elementwise!(F32x4: Add add +, Sub sub -, Mul mul *);
elementwise!(Mask4: BitAnd bitand &, BitOr bitor |);

impl Not for Mask4 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(|lane| !lane))
    }
}

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|lane| -lane))
    }
}

impl LaneMask for Mask4 {
    #[inline(always)]
    fn bits(self) -> u32 {
        self.0.iter().enumerate().map(|(lane, &set)| u32::from(set) << lane).sum()
    }
}

impl Real for F64x4 {
    type Mask = Mask4;

    #[inline(always)]
    fn of(value: f64) -> Self {
        Self([value; 4])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Mask4 {
        Mask4(array::from_fn(|lane| self.0[lane] < other.0[lane]))
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> Mask4 {
        Mask4(array::from_fn(|lane| self.0[lane] <= other.0[lane]))
    }
    #[inline(always)]
    fn select(mask: Mask4, yes: Self, no: Self) -> Self {
        Self(array::from_fn(|lane| if mask.0[lane] { yes.0[lane] } else { no.0[lane] }))
    }
}

impl Rounding for F64x4 {
    const UNIT_ROUNDOFF: f64 = <f64 as Rounding>::UNIT_ROUNDOFF;
    const LENIENCE: f64 = <f64 as Rounding>::LENIENCE;
}

impl Fused for F64x4 {
    #[inline(always)]
    fn fused(self, factor: Self, term: Self) -> Self {
        Self(array::from_fn(|lane| self.0[lane].mul_add(factor.0[lane], term.0[lane])))
    }
}

impl MulAdd for F64x4 {
    #[inline(always)]
    fn mul_add_loosely(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}

impl SimdF64 for F64x4 {
    const LANES: usize = 4;

    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        Self([values[0], values[1], values[2], values[3]])
    }
    #[inline(always)]
    fn store(self, place: &mut [f64]) {
        place[..4].copy_from_slice(&self.0);
    }
    #[inline(always)]
    fn compress(self, bits: u32) -> Self {
        let (mut packed, mut count) = (self.0, 0);
        for lane in 0..4 {
            packed[count] = self.0[lane];
            count += (bits >> lane & 1) as usize;
        }
        Self(packed)
    }
    #[inline(always)]
    fn expand(mut self, bits: u32, packed: Self) -> Self {
        let mut count = 0;
        for lane in 0..4 {
            if bits >> lane & 1 == 1 {
                self.0[lane] = packed.0[count];
                count += 1;
            }
        }
        self
    }
    #[inline(always)]
    fn unzip(self, Self(next): Self) -> (Self, Self) {
        let this = self.0;
        (Self([this[0], this[2], next[0], next[2]]), Self([this[1], this[3], next[1], next[3]]))
    }
}

impl SimdF32 for F32x4 {
    const LANES: usize = 4;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([value; 4])
    }
    #[inline(always)]
    fn load(values: &[f32]) -> Self {
        Self([values[0], values[1], values[2], values[3]])
    }
    #[inline(always)]
    fn store(self, place: &mut [f32]) {
        place[..4].copy_from_slice(&self.0);
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    #[inline(always)]
    fn negative_mul_add(self, factor: Self, term: Self) -> Self {
        term - self * factor
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(array::from_fn(|lane| if self.0[lane] < other.0[lane] { self.0[lane] } else { other.0[lane] }))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(array::from_fn(|lane| if self.0[lane] > other.0[lane] { self.0[lane] } else { other.0[lane] }))
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> u32 {
        (0..4).map(|lane| u32::from(self.0[lane] <= other.0[lane]) << lane).sum()
    }
    #[inline(always)]
    fn places_of(number: u32, numbers: &[u32]) -> u32 {
        (0..4).map(|lane| u32::from(numbers[lane] == number) << lane).sum()
    }
}
