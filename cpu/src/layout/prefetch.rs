//! Prefetching: asking the processor to bring data into its nearest cache before they are needed. A traversal knows
//! which nodes and objects it will read some time before it reads them. In a large scene they are in no near cache.

#![allow(unsafe_code)]

/// The size of a cache line in bytes. Where lines have another size, prefetching gains less or nothing.
#[cfg(all(target_arch = "x86_64", not(miri)))]
const CACHE_LINE: usize = 64;

/// Asks the processor for the cache lines of `value`. A program cannot observe this, except by its speed.
#[cfg(all(target_arch = "x86_64", not(miri)))]
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};

    let start = std::ptr::from_ref(value).cast::<i8>();
    // A value that may begin within a line may also end in one more line.
    let end = (align_of::<T>() < CACHE_LINE && size_of::<T>() > 0).then(|| size_of::<T>() - 1);
    for at in (0..size_of::<T>()).step_by(CACHE_LINE).chain(end) {
        // SAFETY: every x86-64 processor has this instruction. It changes no data, and it does nothing for an address
        // that cannot be read. This address is within `value`.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.wrapping_add(at)) };
    }
}

/// The twin for other processors does nothing.
#[cfg(not(all(target_arch = "x86_64", not(miri))))]
#[inline(always)]
pub fn prefetch<T>(_: &T) {}
