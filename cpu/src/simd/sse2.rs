//! 128-bit lanes, which every x86-64 machine has.
//!
//! Each function is one or two instructions. They are sound because a lane value exists only inside a kernel, and a
//! kernel is compiled for this instruction set only where [`InstructionSet::run`](super::InstructionSet::run) has found
//! that the machine has it.

use std::arch::x86_64::*;

use super::{FilterLanes, Kernel, LaneMask, Lanes, Simd, operators};
use crate::exact_sums::Fused;
use crate::real::{MulAdd, Real};
use crate::rounding::Rounding;

/// SSE2.
#[derive(Clone, Copy, Debug)]
pub struct Sse2(());

impl Sse2 {
    /// The proof that the machine has it.
    ///
    /// # Safety
    /// It must have.
    pub const unsafe fn new() -> Self {
        Self(())
    }
}

impl Simd for Sse2 {
    type F64 = F64;
    type F32 = F32;
    const FUSES: bool = false;

    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) -> K::Output {
        #[inline(never)]
        #[target_feature(enable = "sse2")]
        fn compiled<K: Kernel>(simd: Sse2, kernel: K) -> K::Output {
            kernel.call(simd)
        }
        // SAFETY: `self` is the proof that the machine has these features.
        unsafe { compiled(self, kernel) }
    }
}

/// Lanes of `f64`.
#[derive(Clone, Copy, Debug)]
pub struct F64(__m128d);

/// Lanes of `f32`.
#[derive(Clone, Copy, Debug)]
pub struct F32(__m128);

/// Answers of comparisons.
#[derive(Clone, Copy, Debug)]
pub struct Mask(__m128d);

operators!(F64, Add add _mm_add_pd, Sub sub _mm_sub_pd, Mul mul _mm_mul_pd, Div div _mm_div_pd);
operators!(F32, Add add _mm_add_ps, Sub sub _mm_sub_ps, Mul mul _mm_mul_ps);
operators!(Mask, BitAnd bitand _mm_and_pd, BitOr bitor _mm_or_pd);

impl std::ops::Not for Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_xor_pd(self.0, _mm_castsi128_pd(_mm_set1_epi32(-1))) })
    }
}

impl LaneMask for Mask {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: see the module's head.
        unsafe { _mm_movemask_pd(self.0) as u32 }
    }
}

impl std::ops::Neg for F64 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_xor_pd(self.0, _mm_set1_pd(-0.0)) })
    }
}

impl Real for F64 {
    type Mask = Mask;

    #[inline(always)]
    fn of(value: f64) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_set1_pd(value) })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_andnot_pd(_mm_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn less(self, other: Self) -> Mask {
        // SAFETY: see the module's head.
        Mask(unsafe { _mm_cmplt_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> Mask {
        // SAFETY: see the module's head.
        Mask(unsafe { _mm_cmple_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn select(mask: Mask, yes: Self, no: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_or_pd(_mm_and_pd(mask.0, yes.0), _mm_andnot_pd(mask.0, no.0)) })
    }
}

impl Rounding for F64 {
    const UNIT_ROUNDOFF: f64 = <f64 as Rounding>::UNIT_ROUNDOFF;
    const LENIENCE: f64 = <f64 as Rounding>::LENIENCE;
}

impl Fused for F64 {
    // The instruction set has none: a function, lane by lane.
    #[inline(always)]
    fn fused(self, factor: Self, term: Self) -> Self {
        let (mut values, mut factors, mut terms) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        self.store(&mut values);
        factor.store(&mut factors);
        term.store(&mut terms);
        let both = [values[0].mul_add(factors[0], terms[0]), values[1].mul_add(factors[1], terms[1])];
        Self::load(&both)
    }
}

impl MulAdd for F64 {
    #[inline(always)]
    fn times_plus(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}

impl Lanes for F64 {
    const LANES: usize = 2;

    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the module's head.
        Self(unsafe { _mm_loadu_pd(values.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, place: &mut [f64]) {
        let place = &mut place[..Self::LANES];
        // SAFETY: as many numbers as lanes fit there; the store needs no alignment. See the module's head.
        unsafe { _mm_storeu_pd(place.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn compress(self, bits: u32) -> Self {
        // SAFETY: see the module's head.
        if bits == 2 { Self(unsafe { _mm_unpackhi_pd(self.0, self.0) }) } else { self }
    }
    #[inline(always)]
    fn expand(self, bits: u32, packed: Self) -> Self {
        match bits {
            0 => self,
            // SAFETY: see the module's head.
            1 => Self(unsafe { _mm_move_sd(self.0, packed.0) }),
            // SAFETY: as above.
            2 => Self(unsafe { _mm_unpacklo_pd(self.0, packed.0) }),
            _ => packed,
        }
    }
    #[inline(always)]
    fn unzip(self, next: Self) -> (Self, Self) {
        // SAFETY: see the module's head.
        unsafe { (Self(_mm_unpacklo_pd(self.0, next.0)), Self(_mm_unpackhi_pd(self.0, next.0))) }
    }
}

impl FilterLanes for F32 {
    const LANES: usize = 4;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_set1_ps(value) })
    }
    #[inline(always)]
    fn load(values: &[f32]) -> Self {
        let values = &values[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the module's head.
        Self(unsafe { _mm_loadu_ps(values.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, place: &mut [f32]) {
        let place = &mut place[..Self::LANES];
        // SAFETY: as many numbers as lanes fit there; the store needs no alignment. See the module's head.
        unsafe { _mm_storeu_ps(place.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_add_ps(_mm_mul_ps(self.0, factor.0), term.0) })
    }
    #[inline(always)]
    fn negative_mul_add(self, factor: Self, term: Self) -> Self {
        term - self * factor
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_min_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: see the module's head.
        Self(unsafe { _mm_max_ps(self.0, other.0) })
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> u32 {
        // SAFETY: see the module's head.
        unsafe { _mm_movemask_ps(_mm_cmple_ps(self.0, other.0)) as u32 }
    }
    #[inline(always)]
    fn places_of(number: u32, numbers: &[u32]) -> u32 {
        let numbers = &numbers[..Self::LANES];
        // SAFETY: as many numbers as lanes start there; the load needs no alignment. See the module's head.
        unsafe {
            let numbers = _mm_loadu_si128(numbers.as_ptr().cast());
            _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(numbers, _mm_set1_epi32(number as i32)))) as u32
        }
    }
}
