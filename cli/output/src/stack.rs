//! The room that is left on the main thread's stack.

#![allow(unsafe_code)]

use std::fs;

/// Returns by how many bytes the stack of the main thread may still grow. The main thread must call this function.
/// Returns `None` if the system does not tell it, or if the stack's limit is 1 MiB or more.
#[must_use]
pub fn room() -> Option<usize> {
    /// A limit from which on no exact number is needed. Linux gives at most a quarter of it to the arguments and the
    /// environment.
    const ENOUGH: usize = 1 << 20;

    let limit = limit().filter(|&limit| limit < ENOUGH)?;
    let here = (&raw const limit).addr();
    // A line of this file begins with the first address of an area of memory and the address after its last one.
    let areas = fs::read_to_string("/proc/self/maps").ok()?;
    let (area, _) = areas.lines().find(|line| line.ends_with("[stack]"))?.split_once(' ')?;
    let (_, end) = area.split_once('-')?;
    let used = usize::from_str_radix(end, 16).ok()?.checked_sub(here)?;
    Some(limit.saturating_sub(used))
}

/// Returns the limit of the stack in bytes, or `None` if it is not known.
#[cfg(target_pointer_width = "64")]
fn limit() -> Option<usize> {
    use std::ffi::c_int;

    /// The number of the stack's limit, the same on every Unix.
    const STACK: c_int = 3;

    // SAFETY: this declaration has the type that the C library of every Unix with addresses of 64 bits uses. The limit
    // is a structure of two numbers there.
    unsafe extern "C" {
        fn getrlimit(resource: c_int, limit: *mut [u64; 2]) -> c_int;
    }

    let mut limit = [0; 2];
    // SAFETY: the call writes the two numbers to which the pointer leads.
    let result = unsafe { getrlimit(STACK, &raw mut limit) };
    usize::try_from(limit[0]).ok().filter(|_| result == 0)
}

/// Returns `None`: on systems with other addresses the layout of the limit depends on the C library.
#[cfg(not(target_pointer_width = "64"))]
fn limit() -> Option<usize> {
    None
}
