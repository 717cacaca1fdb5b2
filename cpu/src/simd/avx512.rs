//! 512-bit lanes.
//!
//! Each function is one or two instructions. They are sound because a lane value exists only inside a kernel, and a
//! kernel is compiled for this instruction set only where
//! [`InstructionSet::run`](crate::simd::instruction_set::InstructionSet::run) has found that the machine has it.

mod filter_lanes;

use std::arch::x86_64::*;

use crate::math::error_free::Fused;
use crate::math::real::{MulAdd, Real};
use crate::math::rounding::Rounding;
use crate::simd::avx2::Avx2;
use crate::simd::{Kernel, LaneMask, Simd, SimdF64, operators};

/// AVX-512 F, DQ, BW and VL.
#[derive(Clone, Copy, Debug)]
pub struct Avx512 {
    /// Also for work on one ray after the other among a handful of objects.
    throughout: bool,
}

impl Avx512 {
    /// The proof that the machine has it.
    ///
    /// # Safety
    /// It must have.
    pub const unsafe fn new(throughout: bool) -> Self {
        Self { throughout }
    }
}

/// Whether the machine has all that kernels are compiled for here beyond what AVX2 has, by [`Simd::run`].
pub fn is_found() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512bw")
        && is_x86_feature_detected!("avx512vl")
}

impl Simd for Avx512 {
    type F64 = F64;
    type F32 = F32;
    const FUSES: bool = true;

    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        #[inline(never)]
        #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
        fn compiled<K: Kernel>(simd: Avx512, kernel: K) -> K::Output {
            kernel.call(simd)
        }
        // SAFETY: `self` is the proof that the machine has these features.
        unsafe { compiled(self, kernel) }
    }

    #[inline(always)]
    fn run_promptly<K: Kernel>(self, kernel: K) -> K::Output {
        if self.throughout {
            return self.run(kernel);
        }
        // Comparisons into mask registers, which the compiler uses for single numbers too, may take longer than those
        // into vectors.
        // SAFETY: a machine is asked for AVX2 and FMA where it is asked for AVX-512 (`InstructionSet::is_available`).
        unsafe { Avx2::new() }.run(kernel)
    }
}

/// Lanes of `f64`.
#[derive(Clone, Copy, Debug)]
pub struct F64(__m512d);

/// Lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(__m512);

/// Answers of comparisons.
#[derive(Clone, Copy, Debug)]
pub struct Mask(__mmask8);

operators!(F64, Add add _mm512_add_pd, Sub sub _mm512_sub_pd, Mul mul _mm512_mul_pd, Div div _mm512_div_pd);
operators!(F32, Add add _mm512_add_ps, Sub sub _mm512_sub_ps, Mul mul _mm512_mul_ps);

impl std::ops::BitAnd for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl std::ops::BitOr for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl std::ops::Not for Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

impl LaneMask for Mask {
    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(self.0)
    }
}

impl std::ops::Neg for F64 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }
}

impl Real for F64 {
    type Mask = Mask;

    #[inline(always)]
    fn of(value: f64) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_set1_pd(value) })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_andnot_pd(_mm512_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn less(self, other: Self) -> Mask {
        // SAFETY: see the module's head.
        Mask(unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> Mask {
        // SAFETY: see the module's head.
        Mask(unsafe { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn select(mask: Mask, yes: Self, no: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
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
        Self(unsafe { _mm512_fmadd_pd(self.0, factor.0, term.0) })
    }
}

impl MulAdd for F64 {
    #[inline(always)]
    fn mul_add_loosely(self, factor: Self, term: Self) -> Self {
        self.fused(factor, term)
    }
}

impl SimdF64 for F64 {
    const LANES: usize = 8;

    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the module's head.
        Self(unsafe { _mm512_loadu_pd(values.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, place: &mut [f64]) {
        let place = &mut place[..Self::LANES];
        // SAFETY: as many numbers as lanes fit there; the store needs no alignment. See the module's head.
        unsafe { _mm512_storeu_pd(place.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn compress(self, bits: u32) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_maskz_compress_pd(bits as __mmask8, self.0) })
    }
    #[inline(always)]
    fn expand(self, bits: u32, packed: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm512_mask_expand_pd(self.0, bits as __mmask8, packed.0) })
    }
    #[inline(always)]
    fn unzip(self, next: Self) -> (Self, Self) {
        // SAFETY: see the module's head.
        unsafe {
            let (even, odd) =
                (_mm512_setr_epi64(0, 2, 4, 6, 8, 10, 12, 14), _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15));
            let (even, odd) =
                (_mm512_permutex2var_pd(self.0, even, next.0), _mm512_permutex2var_pd(self.0, odd, next.0));
            (Self(even), Self(odd))
        }
    }
}
