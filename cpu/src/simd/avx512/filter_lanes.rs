//! 512-bit lanes of `f32`, for filters. Sound as those of `f64` are: see the head of the module above.

use std::arch::x86_64::*;

use crate::simd::SimdF32;
use crate::simd::avx512::F32;

impl SimdF32 for F32 {
    const LANES: usize = 16;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        // SAFETY: see the head of the module above.
        Self(unsafe { _mm512_set1_ps(value) })
    }
    #[inline(always)]
    fn load(values: &[f32]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the head of the module above.
        Self(unsafe { _mm512_loadu_ps(values.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, place: &mut [f32]) {
        let place = &mut place[..Self::LANES];
        // SAFETY: as many numbers as lanes fit there; the store needs no alignment. See the head of the module above.
        unsafe { _mm512_storeu_ps(place.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        // SAFETY: see the head of the module above.
        Self(unsafe { _mm512_fmadd_ps(self.0, factor.0, term.0) })
    }
    #[inline(always)]
    fn negative_mul_add(self, factor: Self, term: Self) -> Self {
        // SAFETY: see the head of the module above.
        Self(unsafe { _mm512_fnmadd_ps(self.0, factor.0, term.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: see the head of the module above.
        Self(unsafe { _mm512_min_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: see the head of the module above.
        Self(unsafe { _mm512_max_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> u32 {
        // SAFETY: see the head of the module above.
        unsafe { u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(self.0, other.0)) }
    }
    #[inline(always)]
    fn places_of(number: u32, numbers: &[u32]) -> u32 {
        let numbers = &numbers[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the head of the module above.
        unsafe {
            let numbers = _mm512_loadu_si512(numbers.as_ptr().cast());
            u32::from(_mm512_cmpeq_epi32_mask(numbers, _mm512_set1_epi32(number as i32)))
        }
    }
}
