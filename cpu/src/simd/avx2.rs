//! 256-bit lanes with fused multiply-add for the filters.
//!
//! Each function is one or two instructions. They are sound because a lane value exists only inside a kernel, and a
//! kernel is compiled for this instruction set only where
//! [`InstructionSet::run`](crate::simd::instruction_set::InstructionSet::run) has found that the machine has it.

mod filter_lanes;
mod permutations;

use std::arch::x86_64::*;

use crate::math::error_free::Fused;
use crate::math::real::{MulAdd, Real};
use crate::math::rounding::Rounding;
use crate::simd::avx2::permutations::{COMPRESSED, EXPANDED, Halves, SELECTED};
use crate::simd::{Kernel, LaneMask, Simd, SimdF64, operators};

/// AVX2 and FMA.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

impl Avx2 {
    /// The proof that the machine has it.
    ///
    /// # Safety
    /// It must have.
    pub const unsafe fn new() -> Self {
        Self(())
    }
}

/// Whether the machine has all that kernels are compiled for here, by [`Simd::run`].
pub fn is_found() -> bool {
    is_x86_feature_detected!("avx2")
        && is_x86_feature_detected!("fma")
        && is_x86_feature_detected!("bmi1")
        && is_x86_feature_detected!("bmi2")
        && is_x86_feature_detected!("lzcnt")
        && is_x86_feature_detected!("popcnt")
}

impl Simd for Avx2 {
    type F64 = F64;
    type F32 = F32;
    const FUSES: bool = true;

    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        #[inline(never)]
        #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
        fn compiled<K: Kernel>(simd: Avx2, kernel: K) -> K::Output {
            kernel.call(simd)
        }
        // SAFETY: `self` is the proof that the machine has these features.
        unsafe { compiled(self, kernel) }
    }
}

/// Lanes of `f64`.
#[derive(Clone, Copy, Debug)]
pub struct F64(__m256d);

/// Lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(__m256);

/// Answers of comparisons.
#[derive(Clone, Copy, Debug)]
pub struct Mask(__m256d);

operators!(F64, Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);
operators!(F32, Add add _mm256_add_ps, Sub sub _mm256_sub_ps, Mul mul _mm256_mul_ps);
operators!(Mask, BitAnd bitand _mm256_and_pd, BitOr bitor _mm256_or_pd);

impl std::ops::Not for Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi32(-1))) })
    }
}

impl LaneMask for Mask {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: see the module's head.
        unsafe { _mm256_movemask_pd(self.0) as u32 }
    }
}

impl std::ops::Neg for F64 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

impl Real for F64 {
    type Mask = Mask;

    #[inline(always)]
    fn of(value: f64) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_set1_pd(value) })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn less(self, other: Self) -> Mask {
        // SAFETY: see the module's head.
        Mask(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> Mask {
        // SAFETY: see the module's head.
        Mask(unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn select(mask: Mask, yes: Self, no: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
    }
}

impl Rounding for F64 {
    const UNIT_ROUNDOFF: f64 = <f64 as Rounding>::UNIT_ROUNDOFF;
    const LENIENCE: f64 = <f64 as Rounding>::LENIENCE;
}

impl Fused for F64 {
    #[inline(always)]
    fn fused(self, factor: Self, term: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_fmadd_pd(self.0, factor.0, term.0) })
    }
}

impl MulAdd for F64 {
    #[inline(always)]
    fn mul_add_loosely(self, factor: Self, term: Self) -> Self {
        self.fused(factor, term)
    }
}

impl SimdF64 for F64 {
    const LANES: usize = 4;

    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the module's head.
        Self(unsafe { _mm256_loadu_pd(values.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, place: &mut [f64]) {
        let place = &mut place[..Self::LANES];
        // SAFETY: as many numbers as lanes fit there; the store needs no alignment. See the module's head.
        unsafe { _mm256_storeu_pd(place.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn compress(self, bits: u32) -> Self {
        self.permuted(&COMPRESSED[bits as usize % 16])
    }
    #[inline(always)]
    fn expand(self, bits: u32, packed: Self) -> Self {
        let Halves(selected) = &SELECTED[bits as usize % 16];
        // SAFETY: the table's entries have 256 bits, aligned to as many. See the module's head.
        let mask = unsafe { _mm256_load_pd(selected.as_ptr().cast()) };
        Self::select(Mask(mask), packed.permuted(&EXPANDED[bits as usize % 16]), self)
    }
    #[inline(always)]
    fn unzip(self, next: Self) -> (Self, Self) {
        // SAFETY: see the module's head.
        unsafe {
            // Within each half; then the middle two change places.
            let (even, odd) = (_mm256_unpacklo_pd(self.0, next.0), _mm256_unpackhi_pd(self.0, next.0));
            (Self(_mm256_permute4x64_pd::<0b11_01_10_00>(even)), Self(_mm256_permute4x64_pd::<0b11_01_10_00>(odd)))
        }
    }
}

impl F64 {
    /// The halves of the lanes that `order` names.
    #[inline(always)]
    fn permuted(self, Halves(order): &Halves) -> Self {
        // SAFETY: the table's entries have 256 bits, aligned to as many. See the module's head.
        let order = unsafe { _mm256_load_si256(order.as_ptr().cast()) };
        // SAFETY: see the module's head.
        Self(unsafe { _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(self.0), order)) })
    }
}
