//! Huge pages: blocks of memory of 2 MiB, each with one entry in the processor's table of addresses. Nodes and objects
//! of a large scene are read in no order. With ordinary pages of 4 KiB, the table has too many entries to be at hand.

#![allow(unsafe_code)]

/// The size of a huge page in bytes. Where the system has other sizes, asking gains less or nothing.
const HUGE_PAGE: usize = 2 << 20;

/// Asks the system to place the memory of `list`, with its spare capacity, in huge pages. Nothing happens if it
/// refuses, or if no whole huge page lies in the list. The list keeps its content and its address.
pub(crate) fn ask<T>(list: &mut Vec<T>) {
    let (from, bytes) = (list.as_mut_ptr() as usize, list.capacity() * size_of::<T>());
    // Only the huge pages that lie in the list as a whole are asked for.
    let (first, end) = (from.next_multiple_of(HUGE_PAGE), (from + bytes) / HUGE_PAGE * HUGE_PAGE);
    if first < end {
        // SAFETY: the addresses from `first` to `end` belong to the list's memory. It is owned alone by `list`.
        unsafe { advise(first, end - first) };
    }
}

/// Advises the system to use huge pages for these addresses, which must be memory of the caller.
#[cfg(all(target_os = "linux", target_pointer_width = "64"))]
unsafe fn advise(address: usize, bytes: usize) {
    use std::ffi::{c_int, c_void};

    unsafe extern "C" {
        /// See `madvise(2)`.
        fn madvise(address: *mut c_void, bytes: usize, advice: c_int) -> c_int;
    }
    /// The advice to use huge pages. It never changes the content of memory.
    const MADV_HUGEPAGE: c_int = 14;
    // SAFETY: the caller owns the memory, and this advice changes nothing that a program can read. A refusal is a
    // result that is ignored.
    let _ = unsafe { madvise(address as *mut c_void, bytes, MADV_HUGEPAGE) };
}

/// The twin for other systems does nothing. It is `unsafe` only to have the same signature.
#[cfg(not(all(target_os = "linux", target_pointer_width = "64")))]
unsafe fn advise(_: usize, _: usize) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_has_the_same_content_with_and_without_huge_pages() {
        for count in [0, 1, 100_000, 3_000_000] {
            let plain: Vec<u32> = (0..count).collect();
            let mut list = plain.clone();
            let address = list.as_ptr();
            ask(&mut list);
            assert!(list == plain && list.as_ptr() == address);
            let mut empty = Vec::with_capacity(plain.len());
            ask(&mut empty);
            empty.extend(0..count);
            assert!(empty == plain);
        }
    }

    #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
    #[test]
    fn a_system_that_has_huge_pages_is_asked_for_them() {
        let mut list: Vec<u8> = Vec::with_capacity(5 * HUGE_PAGE);
        ask(&mut list);
        let middle = list.as_ptr() as usize + 5 * HUGE_PAGE / 2;
        // The file lists each part of memory: a line with its addresses, then lines with its properties.
        let memory = std::fs::read_to_string("/proc/self/smaps").expect("Linux has it");
        let mut is_inside = false;
        let flags = memory.lines().find_map(|line| {
            if let Some((from, to)) = line.split(' ').next().and_then(|word| word.split_once('-')) {
                let address = |text| usize::from_str_radix(text, 16);
                if let (Ok(from), Ok(to)) = (address(from), address(to)) {
                    is_inside = (from..to).contains(&middle);
                }
            }
            line.strip_prefix("VmFlags:").filter(|_| is_inside)
        });
        let flags = flags.expect("the list is in memory");
        // A system without huge pages refuses, and then the memory must be as it was.
        let has_huge_pages = std::path::Path::new("/sys/kernel/mm/transparent_hugepage").exists();
        assert_eq!(flags.split(' ').any(|flag| flag == "hg"), has_huge_pages, "{flags}");
    }
}
