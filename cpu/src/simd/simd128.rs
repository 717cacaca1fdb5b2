//! Vectors of 128 bits of WebAssembly. Each line of a table is one operation with its intrinsics.
//!
//! A WebAssembly module that contains these instructions loads only where they are supported, so they are chosen when
//! the renderer is compiled (`-C target-feature=+simd128`), not when it runs.

#![allow(unused_unsafe, reason = "an intrinsic whose feature the target always has is safe")]

use std::arch::wasm32::*;

use crate::math::{real::Real, real::functions, rounding::Rounding};
use crate::simd::{Kernel, Simd, SimdF32, SimdF64, tables::intrinsics, tables::operators};

/// The proof that the machine has the 128-bit vectors of WebAssembly. Without them the WebAssembly module would not
/// have loaded.
#[derive(Clone, Copy, Debug)]
pub struct Simd128;

impl Simd for Simd128 {
    type F64 = F64;
    type F32 = F32;

    #[inline(never)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.call(self)
    }
}

/// Two lanes of `f64`.
#[derive(Clone, Copy, Debug)]
pub struct F64(v128);

/// Four lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(v128);

/// Results of comparisons: all bits of a lane are ones or zeros.
#[derive(Clone, Copy, Debug)]
pub struct Mask(v128);

operators! { F64:
    Add add(self, other: Self) { f64x2_add(self.0, other.0) }
    Sub sub(self, other: Self) { f64x2_sub(self.0, other.0) }
    Mul mul(self, other: Self) { f64x2_mul(self.0, other.0) }
    Div div(self, other: Self) { f64x2_div(self.0, other.0) }
    Neg neg(self) { f64x2_neg(self.0) }
}

operators! { F32:
    Add add(self, other: Self) { f32x4_add(self.0, other.0) }
    Sub sub(self, other: Self) { f32x4_sub(self.0, other.0) }
    Mul mul(self, other: Self) { f32x4_mul(self.0, other.0) }
}

operators! { Mask:
    BitAnd bitand(self, other: Self) { v128_and(self.0, other.0) }
    BitOr bitor(self, other: Self) { v128_or(self.0, other.0) }
    Not not(self) { v128_not(self.0) }
}

impl Real for F64 {
    type Mask = Mask;

    intrinsics! {
        fn of(value: f64) -> Self { Self(f64x2_splat(value)) }
        fn sqrt(self) -> Self { Self(f64x2_sqrt(self.0)) }
        fn abs(self) -> Self { Self(f64x2_abs(self.0)) }
        fn less(self, other: Self) -> Mask { Mask(f64x2_lt(self.0, other.0)) }
        fn less_equal(self, other: Self) -> Mask { Mask(f64x2_le(self.0, other.0)) }
        fn select(mask: Mask, yes: Self, no: Self) -> Self { Self(v128_bitselect(yes.0, no.0, mask.0)) }
    }
}

impl Rounding for F64 {
    functions! {
        // WebAssembly has no fused multiply-add with a certain result, so each lane calls a function.
        fn mul_add(self, factor: Self, term: Self) -> Self {
            let lanes = |of: v128| [f64x2_extract_lane::<0>(of), f64x2_extract_lane::<1>(of)];
            let ([a, b], [c, d], [e, f]) = (lanes(self.0), lanes(factor.0), lanes(term.0));
            Self(f64x2(a.mul_add(c, e), b.mul_add(d, f)))
        }
        fn mul_add_loosely(self, factor: Self, term: Self) -> Self { self * factor + term }
    }
}

impl SimdF64 for F64 {
    const LANES: usize = 2;

    // As many numbers as lanes are at the pointers, which need no alignment.
    intrinsics! {
        fn load(values: &[f64]) -> Self { Self(v128_load(values[..Self::LANES].as_ptr().cast())) }
        fn store(self, place: &mut [f64]) { v128_store(place[..Self::LANES].as_mut_ptr().cast(), self.0) }
        fn bits(mask: Mask) -> u32 { u32::from(i64x2_bitmask(mask.0)) }
    }
}

impl SimdF32 for F32 {
    const LANES: usize = 4;

    // As many numbers as lanes are at the pointers, which need no alignment.
    intrinsics! {
        fn splat(value: f32) -> Self { Self(f32x4_splat(value)) }
        fn load(values: &[f32]) -> Self { Self(v128_load(values[..Self::LANES].as_ptr().cast())) }
        fn load_bytes(bytes: &[u8]) -> Self {
            let four = v128_load32_zero(bytes[..Self::LANES].as_ptr().cast());
            Self(f32x4_convert_u32x4(u32x4_extend_low_u16x8(u16x8_extend_low_u8x16(four))))
        }
        fn store(self, place: &mut [f32]) { v128_store(place[..Self::LANES].as_mut_ptr().cast(), self.0) }
        fn mul_add(self, factor: Self, term: Self) -> Self { self * factor + term }
        fn negative_mul_add(self, factor: Self, term: Self) -> Self { term - self * factor }
        // `pmin(a, b)` is `b < a ? b : a`.
        fn min(self, other: Self) -> Self { Self(f32x4_pmin(other.0, self.0)) }
        fn max(self, other: Self) -> Self { Self(f32x4_pmax(other.0, self.0)) }
        fn less_equal(self, other: Self) -> u32 { u32::from(i32x4_bitmask(f32x4_le(self.0, other.0))) }
    }
}
