//! Vectors of 512 bits: AVX-512 F, DQ, BW and VL. Each line of a table is one operation with its intrinsics.

use std::arch::x86_64::*;

use crate::math::{real::Real, rounding::Rounding};
use crate::simd::{
    Kernel, Simd, SimdF32, SimdF64, avx2::Avx2, tables::features, tables::intrinsics, tables::operators,
};

features!(is_x86_feature_detected: "avx512f", "avx512dq", "avx512bw", "avx512vl", "avx2", "fma", "bmi1", "bmi2", "lzcnt", "popcnt");

/// The proof that the machine has AVX-512 F, DQ, BW and VL, AVX2, FMA, and four extensions for integers (BMI1, BMI2,
/// LZCNT and POPCNT).
#[derive(Clone, Copy, Debug)]
pub struct Avx512 {
    /// Whether [`Simd::run_promptly`] uses 512 bits too, instead of 256.
    throughout: bool,
}

impl Avx512 {
    /// Returns the proof. `throughout` tells whether [`Simd::run_promptly`] uses 512 bits too.
    ///
    /// # Safety
    /// [`is_detected`] must be true.
    pub(super) const unsafe fn new(throughout: bool) -> Self {
        Self { throughout }
    }
}

impl Simd for Avx512 {
    type F64 = F64;
    type F32 = F32;

    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        // SAFETY: `self` is the proof that the machine has the features.
        unsafe { compiled(self, kernel) }
    }

    #[inline(always)]
    fn run_promptly<K: Kernel>(self, kernel: K) -> K::Output {
        if self.throughout {
            return self.run(kernel);
        }
        // Comparisons into mask registers, which the compiler uses for single numbers too, may take longer than those
        // into vectors.
        // SAFETY: `self` is the proof that the machine has the features of AVX2 too: they are among those above.
        unsafe { Avx2::new() }.run(kernel)
    }
}

/// Eight lanes of `f64`.
#[derive(Clone, Copy, Debug)]
pub struct F64(__m512d);

/// Sixteen lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(__m512);

/// The results of a comparison, one bit for each lane.
#[derive(Clone, Copy, Debug)]
pub struct Mask(__mmask8);

operators! { F64:
    Add add(self, other: Self) { _mm512_add_pd(self.0, other.0) }
    Sub sub(self, other: Self) { _mm512_sub_pd(self.0, other.0) }
    Mul mul(self, other: Self) { _mm512_mul_pd(self.0, other.0) }
    Div div(self, other: Self) { _mm512_div_pd(self.0, other.0) }
    Neg neg(self) { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) }
}

operators! { F32:
    Add add(self, other: Self) { _mm512_add_ps(self.0, other.0) }
    Sub sub(self, other: Self) { _mm512_sub_ps(self.0, other.0) }
    Mul mul(self, other: Self) { _mm512_mul_ps(self.0, other.0) }
}

operators! { Mask:
    BitAnd bitand(self, other: Self) { _kand_mask8(self.0, other.0) }
    BitOr bitor(self, other: Self) { _kor_mask8(self.0, other.0) }
    Not not(self) { _knot_mask8(self.0) }
}

impl Real for F64 {
    type Mask = Mask;

    intrinsics! {
        fn of(value: f64) -> Self { Self(_mm512_set1_pd(value)) }
        fn sqrt(self) -> Self { Self(_mm512_sqrt_pd(self.0)) }
        fn abs(self) -> Self { Self(_mm512_andnot_pd(_mm512_set1_pd(-0.0), self.0)) }
        fn less(self, other: Self) -> Mask { Mask(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0)) }
        fn less_equal(self, other: Self) -> Mask { Mask(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, other.0)) }
        fn select(mask: Mask, yes: Self, no: Self) -> Self { Self(_mm512_mask_blend_pd(mask.0, no.0, yes.0)) }
    }
}

impl Rounding for F64 {
    intrinsics! {
        fn mul_add(self, factor: Self, term: Self) -> Self { Self(_mm512_fmadd_pd(self.0, factor.0, term.0)) }
    }
}

impl SimdF64 for F64 {
    const LANES: usize = 8;

    // Each pointer is that of a slice of exactly `LANES` numbers, and needs no alignment.
    intrinsics! {
        fn load(values: &[f64]) -> Self { Self(_mm512_loadu_pd(values[..Self::LANES].as_ptr())) }
        fn store(self, place: &mut [f64]) { _mm512_storeu_pd(place[..Self::LANES].as_mut_ptr(), self.0) }
        fn bits(mask: Mask) -> u32 { _cvtmask8_u32(mask.0) }
        fn store_selected(self, bits: u32, place: &mut [f64]) {
            _mm512_storeu_pd(place[..Self::LANES].as_mut_ptr(), _mm512_maskz_compress_pd(bits as __mmask8, self.0))
        }
    }
}

impl SimdF32 for F32 {
    const LANES: usize = 16;

    // Each pointer is that of a slice of exactly `LANES` numbers, and needs no alignment.
    intrinsics! {
        fn splat(value: f32) -> Self { Self(_mm512_set1_ps(value)) }
        fn load(values: &[f32]) -> Self { Self(_mm512_loadu_ps(values[..Self::LANES].as_ptr())) }
        fn load_bytes(bytes: &[u8]) -> Self {
            Self(_mm512_cvtepi32_ps(_mm512_cvtepu8_epi32(_mm_loadu_si128(bytes[..Self::LANES].as_ptr().cast()))))
        }
        fn store(self, place: &mut [f32]) { _mm512_storeu_ps(place[..Self::LANES].as_mut_ptr(), self.0) }
        fn mul_add(self, factor: Self, term: Self) -> Self { Self(_mm512_fmadd_ps(self.0, factor.0, term.0)) }
        fn negative_mul_add(self, factor: Self, term: Self) -> Self { Self(_mm512_fnmadd_ps(self.0, factor.0, term.0)) }
        fn min(self, other: Self) -> Self { Self(_mm512_min_ps(self.0, other.0)) }
        fn max(self, other: Self) -> Self { Self(_mm512_max_ps(self.0, other.0)) }
        fn less_equal(self, other: Self) -> u32 { u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(self.0, other.0)) }
    }
}
