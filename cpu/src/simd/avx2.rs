//! Vectors of 256 bits: AVX2 with fused multiply-add. Each line of a table is one operation with its intrinsics.

use std::arch::x86_64::*;

use crate::math::{real::Real, rounding::Rounding};
use crate::simd::{Kernel, Simd, SimdF32, SimdF64, tables::features, tables::intrinsics, tables::operators};

features!(is_x86_feature_detected: "avx2", "fma", "bmi1", "bmi2", "lzcnt", "popcnt");

/// The proof that the machine has AVX2, FMA, and four extensions for integers (BMI1, BMI2, LZCNT and POPCNT).
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

impl Avx2 {
    /// Returns the proof.
    ///
    /// # Safety
    /// [`is_detected`] must be true.
    pub(super) const unsafe fn new() -> Self {
        Self(())
    }
}

impl Simd for Avx2 {
    type F64 = F64;
    type F32 = F32;

    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        // SAFETY: `self` is the proof that the machine has the features.
        unsafe { compiled(self, kernel) }
    }
}

/// Four lanes of `f64`.
#[derive(Clone, Copy, Debug)]
pub struct F64(__m256d);

/// Eight lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(__m256);

/// The results of a comparison. All 64 bits of a lane are ones where the comparison holds, and zeros elsewhere.
#[derive(Clone, Copy, Debug)]
pub struct Mask(__m256d);

operators! { F64:
    Add add(self, other: Self) { _mm256_add_pd(self.0, other.0) }
    Sub sub(self, other: Self) { _mm256_sub_pd(self.0, other.0) }
    Mul mul(self, other: Self) { _mm256_mul_pd(self.0, other.0) }
    Div div(self, other: Self) { _mm256_div_pd(self.0, other.0) }
    Neg neg(self) { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) }
}

operators! { F32:
    Add add(self, other: Self) { _mm256_add_ps(self.0, other.0) }
    Sub sub(self, other: Self) { _mm256_sub_ps(self.0, other.0) }
    Mul mul(self, other: Self) { _mm256_mul_ps(self.0, other.0) }
}

operators! { Mask:
    BitAnd bitand(self, other: Self) { _mm256_and_pd(self.0, other.0) }
    BitOr bitor(self, other: Self) { _mm256_or_pd(self.0, other.0) }
    Not not(self) { _mm256_xor_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi32(-1))) }
}

impl Real for F64 {
    type Mask = Mask;

    intrinsics! {
        fn of(value: f64) -> Self { Self(_mm256_set1_pd(value)) }
        fn sqrt(self) -> Self { Self(_mm256_sqrt_pd(self.0)) }
        fn abs(self) -> Self { Self(_mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0)) }
        fn less(self, other: Self) -> Mask { Mask(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0)) }
        fn less_equal(self, other: Self) -> Mask { Mask(_mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0)) }
        fn select(mask: Mask, yes: Self, no: Self) -> Self { Self(_mm256_blendv_pd(no.0, yes.0, mask.0)) }
    }
}

impl Rounding for F64 {
    intrinsics! {
        fn mul_add(self, factor: Self, term: Self) -> Self { Self(_mm256_fmadd_pd(self.0, factor.0, term.0)) }
    }
}

impl SimdF64 for F64 {
    const LANES: usize = 4;

    // Each pointer is that of a slice of exactly `LANES` numbers, and needs no alignment.
    intrinsics! {
        fn load(values: &[f64]) -> Self { Self(_mm256_loadu_pd(values[..Self::LANES].as_ptr())) }
        fn store(self, place: &mut [f64]) { _mm256_storeu_pd(place[..Self::LANES].as_mut_ptr(), self.0) }
        fn bits(mask: Mask) -> u32 { _mm256_movemask_pd(mask.0) as u32 }
        fn store_selected(self, bits: u32, place: &mut [f64]) {
            // A permutation has 32 bytes and is aligned to 32 bytes.
            let order = _mm256_load_si256(COMPRESSING[bits as usize % 16].0.as_ptr().cast());
            Self(_mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(self.0), order))).store(place);
        }
    }
}

/// A permutation of the eight 32-bit halves of four lanes: the index of the half that moves to each place. AVX2 has no
/// instruction that permutes 64-bit lanes by a variable.
#[repr(align(32))]
struct Halves([u32; 8]);

/// The permutation for each selection of lanes. The index has a bit for each lane, which is 1 if the lane is selected.
/// The halves of the selected lanes come first, in order.
static COMPRESSING: [Halves; 16] = {
    let mut table = [const { Halves([0; 8]) }; 16];
    let mut bits = 0;
    while bits < 16 {
        let (mut half, mut place) = (0, 0);
        while half < 8 {
            if bits >> (half / 2) & 1 == 1 {
                table[bits].0[place] = half as u32;
                place += 1;
            }
            half += 1;
        }
        bits += 1;
    }
    table
};

impl SimdF32 for F32 {
    const LANES: usize = 8;

    // Each pointer is that of a slice of exactly `LANES` numbers, and needs no alignment.
    intrinsics! {
        fn splat(value: f32) -> Self { Self(_mm256_set1_ps(value)) }
        fn load(values: &[f32]) -> Self { Self(_mm256_loadu_ps(values[..Self::LANES].as_ptr())) }
        fn load_bytes(bytes: &[u8]) -> Self {
            Self(_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadl_epi64(bytes[..Self::LANES].as_ptr().cast()))))
        }
        fn store(self, place: &mut [f32]) { _mm256_storeu_ps(place[..Self::LANES].as_mut_ptr(), self.0) }
        fn mul_add(self, factor: Self, term: Self) -> Self { Self(_mm256_fmadd_ps(self.0, factor.0, term.0)) }
        fn negative_mul_add(self, factor: Self, term: Self) -> Self { Self(_mm256_fnmadd_ps(self.0, factor.0, term.0)) }
        fn min(self, other: Self) -> Self { Self(_mm256_min_ps(self.0, other.0)) }
        fn max(self, other: Self) -> Self { Self(_mm256_max_ps(self.0, other.0)) }
        fn less_equal(self, other: Self) -> u32 {
            _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(self.0, other.0)) as u32
        }
    }
}
