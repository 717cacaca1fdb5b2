//! Vectors of 128 bits of 64-bit ARM processors: NEON, which every such processor has. Each line of a table is one
//! operation with its intrinsics.

#![allow(unused_unsafe, reason = "an intrinsic whose feature the target always has is safe")]

use std::arch::aarch64::*;

use crate::math::{real::Real, rounding::Rounding};
use crate::simd::{Kernel, Simd, SimdF32, SimdF64, tables::features, tables::intrinsics, tables::operators};

features!(is_aarch64_feature_detected: "neon");

/// The proof that the machine has NEON.
#[derive(Clone, Copy, Debug)]
pub struct Neon(());

impl Neon {
    /// Returns the proof.
    ///
    /// # Safety
    /// [`is_detected`] must be true.
    pub(super) const unsafe fn new() -> Self {
        Self(())
    }
}

impl Simd for Neon {
    type F64 = F64;
    type F32 = F32;

    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        // SAFETY: `self` is the proof that the machine has the features.
        unsafe { compiled(self, kernel) }
    }
}

/// Four lanes of `f64`, in two registers. A type with one register would have two lanes. Then loops would have twice as
/// many steps and a lookahead would test half as many paths, which costs more than the register saves.
#[derive(Clone, Copy, Debug)]
pub struct F64([float64x2_t; 2]);

/// Four lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(float32x4_t);

/// Results of comparisons: all bits of a lane are ones or zeros.
#[derive(Clone, Copy, Debug)]
pub struct Mask([uint64x2_t; 2]);

/// Calls a function of one register for each of the two registers.
macro_rules! both {
    ($function:ident($($argument:expr),+)) => {
        [$function($($argument[0]),+), $function($($argument[1]),+)]
    };
}

operators! { F64:
    Add add(self, other: Self) { both!(vaddq_f64(self.0, other.0)) }
    Sub sub(self, other: Self) { both!(vsubq_f64(self.0, other.0)) }
    Mul mul(self, other: Self) { both!(vmulq_f64(self.0, other.0)) }
    Div div(self, other: Self) { both!(vdivq_f64(self.0, other.0)) }
    Neg neg(self) { both!(vnegq_f64(self.0)) }
}

operators! { F32:
    Add add(self, other: Self) { vaddq_f32(self.0, other.0) }
    Sub sub(self, other: Self) { vsubq_f32(self.0, other.0) }
    Mul mul(self, other: Self) { vmulq_f32(self.0, other.0) }
}

operators! { Mask:
    BitAnd bitand(self, other: Self) { both!(vandq_u64(self.0, other.0)) }
    BitOr bitor(self, other: Self) { both!(vorrq_u64(self.0, other.0)) }
    Not not(self) { self.0.map(|half| vreinterpretq_u64_u32(vmvnq_u32(vreinterpretq_u32_u64(half)))) }
}

impl Real for F64 {
    type Mask = Mask;

    intrinsics! {
        fn of(value: f64) -> Self { Self([vdupq_n_f64(value); 2]) }
        fn sqrt(self) -> Self { Self(both!(vsqrtq_f64(self.0))) }
        fn abs(self) -> Self { Self(both!(vabsq_f64(self.0))) }
        fn less(self, other: Self) -> Mask { Mask(both!(vcltq_f64(self.0, other.0))) }
        fn less_equal(self, other: Self) -> Mask { Mask(both!(vcleq_f64(self.0, other.0))) }
        fn select(mask: Mask, yes: Self, no: Self) -> Self { Self(both!(vbslq_f64(mask.0, yes.0, no.0))) }
    }
}

impl Rounding for F64 {
    intrinsics! {
        fn mul_add(self, factor: Self, term: Self) -> Self { Self(both!(vfmaq_f64(term.0, self.0, factor.0))) }
    }
}

impl SimdF64 for F64 {
    const LANES: usize = 4;

    // As many numbers as lanes are at the pointers, which need the alignment of one number.
    intrinsics! {
        fn load(values: &[f64]) -> Self {
            let values = &values[..Self::LANES];
            Self([vld1q_f64(values.as_ptr()), vld1q_f64(values[2..].as_ptr())])
        }
        fn store(self, place: &mut [f64]) {
            let place = &mut place[..Self::LANES];
            vst1q_f64(place.as_mut_ptr(), self.0[0]);
            vst1q_f64(place[2..].as_mut_ptr(), self.0[1]);
        }
        fn bits(mask: Mask) -> u32 { bits(vcombine_u32(vmovn_u64(mask.0[0]), vmovn_u64(mask.0[1]))) }
    }
}

/// The lanes of a comparison as bits, lane 0 lowest.
#[inline(always)]
fn bits(mask: uint32x4_t) -> u32 {
    const BIT_OF_LANE: [u32; 4] = [1, 2, 4, 8];
    // SAFETY: as in `intrinsics`; four numbers are at the pointer.
    unsafe { vaddvq_u32(vandq_u32(mask, vld1q_u32(BIT_OF_LANE.as_ptr()))) }
}

impl SimdF32 for F32 {
    const LANES: usize = 4;

    // As many numbers as lanes are at the pointers, which need the alignment of one number.
    intrinsics! {
        fn splat(value: f32) -> Self { Self(vdupq_n_f32(value)) }
        fn load(values: &[f32]) -> Self { Self(vld1q_f32(values[..Self::LANES].as_ptr())) }
        fn load_bytes(bytes: &[u8]) -> Self {
            let four = u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
            let wide = vget_low_u16(vmovl_u8(vcreate_u8(u64::from(four))));
            Self(vcvtq_f32_u32(vmovl_u16(wide)))
        }
        fn store(self, place: &mut [f32]) { vst1q_f32(place[..Self::LANES].as_mut_ptr(), self.0) }
        fn mul_add(self, factor: Self, term: Self) -> Self { Self(vfmaq_f32(term.0, self.0, factor.0)) }
        fn negative_mul_add(self, factor: Self, term: Self) -> Self { Self(vfmsq_f32(term.0, self.0, factor.0)) }
        // The processor's own minimum and maximum are NaN if either number is.
        fn min(self, other: Self) -> Self { Self(vbslq_f32(vcltq_f32(self.0, other.0), self.0, other.0)) }
        fn max(self, other: Self) -> Self { Self(vbslq_f32(vcgtq_f32(self.0, other.0), self.0, other.0)) }
        fn less_equal(self, other: Self) -> u32 { bits(vcleq_f32(self.0, other.0)) }
    }
}
