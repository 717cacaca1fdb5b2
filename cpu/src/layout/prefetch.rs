//! Prefetching: asking the processor to bring data into its nearest cache before they are needed. After a test of boxes
//! a traversal knows which nodes and spheres it will read, but it reads them one after the other. In a large scene they
//! are often not in the two nearest caches. Prefetched together, they arrive together.

#![allow(unsafe_code)]

/// The size of a cache line in bytes. Where lines have another size, prefetching gains less or nothing.
#[cfg(all(target_arch = "x86_64", not(miri)))]
const CACHE_LINE: usize = 64;

/// Asks the processor for the cache lines of `value`. A program cannot observe this, except by its speed.
#[cfg(all(target_arch = "x86_64", not(miri)))]
#[inline(always)]
pub(crate) fn prefetch<T>(value: &T) {
    use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};

    let start = std::ptr::from_ref(value).cast::<i8>();
    // A value that is larger than its alignment may begin within a line and end in one more line.
    let is_in_more_lines = align_of::<T>() < CACHE_LINE && size_of::<T>() > align_of::<T>();
    let end = is_in_more_lines.then(|| size_of::<T>() - 1);
    for at in (0..size_of::<T>()).step_by(CACHE_LINE).chain(end) {
        // SAFETY: every x86-64 processor has this instruction. It changes no data, and it does nothing for an address
        // that cannot be read. This address is within `value`.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.wrapping_add(at)) };
    }
}

/// Does nothing. Other processors have no such instruction in Rust's stable library, and Miri does not interpret it.
#[cfg(not(all(target_arch = "x86_64", not(miri))))]
#[inline(always)]
pub(crate) fn prefetch<T>(_: &T) {}
