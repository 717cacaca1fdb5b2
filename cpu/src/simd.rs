//! Lanes: several numbers that one instruction handles, with the instruction set that the machine has.
//!
//! A kernel is written once, over [`Simd`], and compiled for each instruction set by [`Simd::run`]. The set is chosen
//! once, at run time ([`best`](instruction_set::InstructionSet::best)); every operation on `f64` lanes is one correctly
//! rounded IEEE operation, so the choice never changes a byte. Only `mul_add_loosely` and the `f32` lanes, which serve
//! conservative tests alone, may round once or twice.
//!
//! The portable implementation is always compiled and tested. Tests compare the others with it.
//!
//! Uses [`math`](crate::math). Begin with [`SimdF64`] and [`portable`].

#![allow(unsafe_code)]

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
pub mod columns;
pub(crate) mod fused;
pub mod instruction_set;
pub mod portable;
#[cfg_attr(not(target_arch = "x86_64"), allow(unused_imports, unused_macros))]
mod tables;
#[cfg(test)]
pub(crate) mod tests;

use std::ops::{Add, Mul, Sub};

use crate::math::rounding::MulAdd;

/// An instruction set, as a type that kernels are compiled for. A value of the type proves that the machine has the
/// instruction set: only [`run`](instruction_set::InstructionSet::run) makes one, after detecting it.
pub trait Simd: Copy + 'static {
    /// Lanes of `f64`.
    type F64: SimdF64;
    /// Lanes of `f32`, for filters.
    type F32: SimdF32;

    /// Runs `kernel`, compiled for this instruction set as a function of its own.
    fn run<K: Kernel>(self, kernel: K) -> K::Output;

    /// Runs `kernel`, which works on one ray after the other and is bound by latency. Where comparisons have a lower
    /// latency in another instruction set, `kernel` is compiled for that one.
    #[inline(always)]
    fn run_promptly<K: Kernel>(self, kernel: K) -> K::Output {
        self.run(kernel)
    }
}

/// Work that is compiled once for each instruction set.
pub trait Kernel {
    /// The result of the work.
    type Output;

    /// The work. Implementations, and all that handles lanes in them, must be `#[inline(always)]`: a function of its
    /// own would be compiled without the instruction set.
    fn call<S: Simd>(self, simd: S) -> Self::Output;
}

/// The result of a comparison in each lane.
pub trait LaneMask: Copy {
    /// The lanes as bits, lane 0 lowest; bits beyond the lanes are 0.
    fn bits(self) -> u32;
}

/// Lanes of `f64`.
pub trait SimdF64: MulAdd<Mask: LaneMask> {
    /// Their number.
    const LANES: usize;

    /// The first lanes of `values`.
    ///
    /// # Panics
    /// When there are fewer.
    fn load(values: &[f64]) -> Self;
    /// Stores the lanes at the beginning of `place`.
    ///
    /// # Panics
    /// When it is shorter.
    fn store(self, place: &mut [f64]);
    /// The lanes that `bits` selects, in order, as the first lanes. The lanes behind these have no meaning.
    fn compress(self, bits: u32) -> Self;
    /// Joins these lanes and those of `next`; returns the lanes at even places, and those at odd places.
    fn unzip(self, next: Self) -> (Self, Self);
}

/// The first `count` lanes as bits; all lanes if there are fewer than `count`.
#[inline(always)]
pub fn valid_lanes<V: SimdF64>(count: usize) -> u32 {
    let all = (1_u32 << V::LANES) - 1;
    if count >= V::LANES { all } else { (1_u32 << count) - 1 }
}

/// Lanes of `f32` for filters, whose error bounds hold with or without fused operations.
pub trait SimdF32: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// Their number; it divides 16.
    const LANES: usize;

    /// `value` in every lane.
    fn splat(value: f32) -> Self;
    /// The first lanes of `values`.
    ///
    /// # Panics
    /// When there are fewer.
    fn load(values: &[f32]) -> Self;
    /// Stores the lanes at the beginning of `place`.
    ///
    /// # Panics
    /// When it is shorter.
    fn store(self, place: &mut [f32]);
    /// `self * factor + term`, rounded once or twice.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// `term - self * factor`, rounded once or twice.
    fn negative_mul_add(self, factor: Self, term: Self) -> Self;
    /// The smaller; `other` when either is not a number.
    fn min(self, other: Self) -> Self;
    /// The larger; `other` when either is not a number.
    fn max(self, other: Self) -> Self;
    /// Whether `self <= other`, a bit for each lane; 0 when either is not a number.
    fn less_equal(self, other: Self) -> u32;
    /// Compares the first [`LANES`](Self::LANES) of `numbers` with `number`. Bit `i` of the result is 1 if `numbers[i]`
    /// equals `number`.
    ///
    /// # Panics
    /// When there are fewer.
    fn places_of(number: u32, numbers: &[u32]) -> u32;
}
