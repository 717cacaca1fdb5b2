//! Lanes: several numbers that one instruction handles. The instruction set is chosen at run time.
//!
//! A kernel is written once, generic over [`Simd`]. [`Simd::run`] compiles it for each instruction set. The program
//! chooses the instruction set once, when it starts to render
//! ([`chosen`](instruction_set::InstructionSet::chosen)). Every operation on `f64` lanes is one correctly rounded IEEE
//! operation, so the choice never changes a byte. There are two exceptions, which only conservative tests use:
//! `mul_add_loosely` and the fused operations of `f32` lanes may round once or twice.
//!
//! The portable implementation is always compiled and tested. Tests check the operations of all instruction sets
//! against those of single numbers.
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
#[cfg(target_arch = "aarch64")]
mod neon;
pub mod portable;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod simd128;
#[allow(unused_imports, unused_macros, reason = "each instruction set uses some of the macros")]
mod tables;
#[cfg(test)]
pub(crate) mod tests;

use std::ops::{Add, Mul, Sub};

use crate::math::rounding::Rounding;

/// An instruction set, as a type for which kernels are compiled. A value of the type proves that the machine has the
/// instruction set. [`portable::Portable`] and `Simd128` can be made anywhere, because this program could not run on a
/// machine that lacks them. The types of all other sets have only an unsafe constructor, and
/// [`InstructionSet::run`](instruction_set::InstructionSet::run) calls it after it has detected the set.
pub trait Simd: Copy + 'static {
    /// Lanes of `f64`.
    type F64: SimdF64;
    /// Lanes of `f32`, for conservative tests.
    type F32: SimdF32;

    /// Runs `kernel`, which is compiled for this instruction set as a separate function.
    fn run<K: Kernel>(self, kernel: K) -> K::Output;

    /// Runs a `kernel` whose speed latency limits, such as one that follows one ray after the other. If comparisons
    /// have a lower latency in another instruction set, `kernel` is compiled for that one.
    #[inline(always)]
    fn run_promptly<K: Kernel>(self, kernel: K) -> K::Output {
        self.run(kernel)
    }
}

/// Work that is compiled once for each instruction set.
pub trait Kernel {
    /// The result of the work.
    type Output;

    /// Does the work. This function, and every function that it calls with lanes, must be `#[inline(always)]`. A
    /// function that is not inlined is compiled without the instruction set. The same is true of a closure, so a kernel
    /// has loops and macros in place of closures.
    fn call<S: Simd>(self, simd: S) -> Self::Output;
}

/// Largest number of `f64` lanes of any instruction set.
pub const MOST_LANES: usize = 8;

/// Lanes of `f64`.
pub trait SimdF64: Rounding {
    /// Number of lanes, at most [`MOST_LANES`].
    const LANES: usize;

    /// Returns the first [`LANES`](Self::LANES) numbers of `values`.
    ///
    /// # Panics
    /// If `values` has fewer numbers.
    fn load(values: &[f64]) -> Self;
    /// Stores the lanes in the first [`LANES`](Self::LANES) numbers of `place`.
    ///
    /// # Panics
    /// If `place` has fewer numbers.
    fn store(self, place: &mut [f64]);
    /// Returns the result of a comparison as bits. Lane 0 is the lowest bit, and bits beyond the last lane are 0.
    fn bits(mask: Self::Mask) -> u32;
    /// Stores the lanes that `bits` selects, in their order, in the first numbers of `place`. The numbers behind these
    /// have no meaning, up to [`LANES`](Self::LANES) numbers in all.
    ///
    /// # Panics
    /// If `place` has fewer numbers.
    #[inline(always)]
    fn store_selected(self, bits: u32, place: &mut [f64]) {
        let (place, mut lanes, mut count) = (&mut place[..Self::LANES], [0.0; MOST_LANES], 0);
        self.store(&mut lanes);
        for (lane, value) in lanes.into_iter().enumerate().take(Self::LANES) {
            place[count] = value;
            count += (bits >> lane & 1) as usize;
        }
    }
}

/// Returns a bit for each lane, lane 0 lowest, which is 1 for the first `count` lanes and 0 for the others. If there
/// are fewer lanes than `count`, every bit is 1.
#[inline(always)]
pub(crate) fn valid_lanes<V: SimdF64>(count: usize) -> u32 {
    let all = (1_u32 << V::LANES) - 1;
    if count >= V::LANES { all } else { (1_u32 << count) - 1 }
}

/// Lanes of `f32` for conservative tests. The margins of these tests hold with and without fused operations.
pub trait SimdF32: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// Number of lanes, which divides 16.
    const LANES: usize;

    /// Returns `value` in every lane.
    fn splat(value: f32) -> Self;
    /// Returns the first [`LANES`](Self::LANES) numbers of `values`.
    ///
    /// # Panics
    /// If `values` has fewer numbers.
    fn load(values: &[f32]) -> Self;
    /// Returns the first [`LANES`](Self::LANES) of `bytes`, converted to numbers from 0 to 255.
    ///
    /// # Panics
    /// If `bytes` has fewer entries.
    fn load_bytes(bytes: &[u8]) -> Self;
    /// Stores the lanes in the first [`LANES`](Self::LANES) numbers of `place`.
    ///
    /// # Panics
    /// If `place` has fewer numbers.
    fn store(self, place: &mut [f32]);
    /// Returns `self * factor + term`, rounded once or twice.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Returns `term - self * factor`, rounded once or twice.
    fn negative_mul_add(self, factor: Self, term: Self) -> Self;
    /// Returns the smaller number of each lane. If one of the two is NaN, the lane gets `other`.
    fn min(self, other: Self) -> Self;
    /// Returns the larger number of each lane. If one of the two is NaN, the lane gets `other`.
    fn max(self, other: Self) -> Self;
    /// Compares the lanes. Bit `i` of the result is 1 if `self <= other` in lane `i`. If one of the two is NaN, the bit
    /// is 0.
    fn less_equal(self, other: Self) -> u32;
}
