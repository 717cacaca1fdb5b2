//! Makes sure that rendering has the stack that it needs.

use crate::Error;

/// Size in bytes of the stack that rendering gets.
///
/// Rendering needs 160 KiB in release builds, for any scene, and 256 KiB in test builds. These are the smallest values
/// of `ulimit -s` with which the programs rendered 10,000 objects without a reserve. Most of it are the samples of a
/// span, 140 KiB, which are made on the stack before they are copied to the heap.
const BYTES: usize = if cfg!(debug_assertions) { 288 << 10 } else { 192 << 10 };

/// Size in bytes of the room that must be left: [`BYTES`], the frames above them, and a page that must stay free.
const NEEDED: usize = BYTES + (16 << 10);

/// Makes the system give the stack all the memory that rendering needs. Call this before other allocations, which may
/// use up the address space.
///
/// The stack grows on demand. If it reaches its limit, or if a limited address space is used up, SIGSEGV ends the
/// process without a message. All other allocations that grow with the input return an error when they fail. The
/// programs have only one thread, so one stack is enough.
///
/// # Errors
/// [`Error::Stack`] if the stack cannot grow so far.
pub(crate) fn reserve() -> Result<(), Error> {
    if let Some(room) = room().filter(|&room| room < NEEDED) {
        return Err(Error::Stack { room, needed: NEEDED });
    }
    touch();
    Ok(())
}

/// Writes zeros to [`BYTES`] of the stack, so that the system must give it this memory now.
#[inline(never)]
fn touch() {
    std::hint::black_box(&mut [0_u8; BYTES]);
}

/// Returns by how many bytes the stack of the main thread may still grow. The main thread must call this function.
/// Returns `None` if the system does not tell it, or if the stack's limit is 1 MiB or more.
fn room() -> Option<usize> {
    /// A limit from which on no exact number is needed. Linux gives at most a quarter of it to the arguments and the
    /// environment.
    const ENOUGH: usize = 1 << 20;

    let limit = rustix::process::getrlimit(rustix::process::Resource::Stack).current?;
    let limit = usize::try_from(limit).ok().filter(|&limit| limit < ENOUGH)?;
    let here = (&raw const limit).addr();
    // A line of this file begins with the first address of an area of memory and the address after its last one.
    let areas = std::fs::read_to_string("/proc/self/maps").ok()?;
    let (area, _) = areas.lines().find(|line| line.ends_with("[stack]"))?.split_once(' ')?;
    let (_, end) = area.split_once('-')?;
    let used = usize::from_str_radix(end, 16).ok()?.checked_sub(here)?;
    Some(limit.saturating_sub(used))
}
