//! A signal that ends the process removes its temporary files first.
//!
//! The names of the files that are being written are kept where a signal handler may look. The programs install such a
//! handler; the library alone changes nothing about signals. Against SIGKILL nothing helps: the old file stands, and a
//! hidden `.render-*.tmp` may stay beside it, where the file system makes no files without a name.

#![allow(unsafe_code)]

use std::ffi::{CStr, CString, c_int};
use std::io;
use std::ptr;
use std::sync::atomic::{AtomicBool, AtomicPtr, Ordering};

use crate::output::folder;

/// The files that are being written and have a temporary name.
static FILES: [Slot; 16] = [const { Slot(AtomicPtr::new(ptr::null_mut())) }; 16];
/// Whether the first request to stop is only noted, and whether there was one.
static NOTES_REQUESTS: AtomicBool = AtomicBool::new(false);
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// A place for one file, or null. Whoever swaps it out removes it or forgets it.
#[derive(Debug)]
struct Slot(AtomicPtr<Named>);

/// A name in an open folder.
#[derive(Debug)]
struct Named {
    folder: c_int,
    name: CString,
}

/// Requests to stop: hangup, interruption and termination have these numbers on every Unix.
const REQUESTS: [c_int; 3] = [1, 2, 15];
/// Other signals that end a process, with the same numbers on every Unix: quit, illegal instruction, trap, abort,
/// floating-point error, pipe, alarm. SIGSEGV and SIGBUS are left to the standard library, which tells a stack overflow
/// from other faults.
const FATAL: [c_int; 7] = [3, 4, 5, 6, 8, 13, 14];
/// Those of Linux: two for users, a coprocessor's fault, processor time, two timers, input, power, system call, and the
/// real-time signals from 34 on.
#[cfg(target_os = "linux")]
const MORE: &[c_int] = &[
    10, 12, 16, 24, 26, 27, 29, 30, 31, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53,
    54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64,
];
/// Those of macOS: emulation, system call, processor time, two timers, two for users.
#[cfg(target_os = "macos")]
const MORE: &[c_int] = &[7, 12, 24, 26, 27, 30, 31];
#[cfg(not(any(target_os = "linux", target_os = "macos")))]
const MORE: &[c_int] = &[];
/// The limit on file sizes, whose signal is better an error of the write.
const FILE_SIZE: Option<c_int> = if cfg!(any(target_os = "linux", target_os = "macos")) { Some(25) } else { None };

/// What a signal may be set to beside the address of a function.
const DEFAULT: usize = 0;
const IGNORE: usize = 1;

// SAFETY: the C library of every Unix has these, with these types; the standard library links it already.
unsafe extern "C" {
    fn signal(number: c_int, handler: usize) -> usize;
    fn raise(number: c_int) -> c_int;
    fn getpid() -> c_int;
    fn _exit(status: c_int) -> !;
}

/// A file that is removed when this is dropped, and when a signal ends the process.
#[derive(Debug)]
pub(super) struct Remembered {
    slot: &'static Slot,
    named: &'static Named,
}

impl Remembered {
    /// Remembers `name` in the open `folder`, which must stay open as long as this lives.
    ///
    /// # Errors
    /// Too many files are being written at once.
    pub fn new(folder: c_int, name: &CStr) -> io::Result<Self> {
        // Never freed, because a signal handler on another thread may still be looking at it: some 60 bytes a file.
        let named: &'static Named = Box::leak(Box::new(Named { folder, name: name.to_owned() }));
        let slot = FILES.iter().find(|slot| slot.exchange(ptr::null(), named));
        slot.map(|slot| Self { slot, named })
            .ok_or_else(|| io::Error::other("too many files are being written at once"))
    }

    /// The file has its place, or was never made: it is not removed.
    pub fn forget(self) {
        self.slot.exchange(self.named, ptr::null());
    }
}

impl Drop for Remembered {
    fn drop(&mut self) {
        // Not so after `forget`, and where a signal handler has removed the file.
        if self.slot.exchange(self.named, ptr::null()) {
            folder::unlink(self.named.folder, &self.named.name);
        }
    }
}

impl Slot {
    /// Puts `new` in the place of `old`, and says whether `old` was there.
    fn exchange(&self, old: *const Named, new: *const Named) -> bool {
        self.0.compare_exchange(old.cast_mut(), new.cast_mut(), Ordering::SeqCst, Ordering::SeqCst).is_ok()
    }

    /// Removes the file. Calls nothing but what a signal handler may call.
    fn remove(&self) {
        let named = self.0.swap(ptr::null_mut(), Ordering::SeqCst);
        // SAFETY: it is null or comes from a `&'static Named`, which nothing ever changes.
        if let Some(named) = unsafe { named.as_ref() } {
            folder::unlink(named.folder, &named.name);
        }
    }
}

/// From now on a signal that ends this process removes its temporary files first. The process then ends by the signal,
/// as it would have; as process 1, which no default action ends, with status 128 and the signal's number. Signals that
/// are ignored stay ignored, as `nohup` wants it. A write beyond the limit on file sizes becomes an error and not a
/// signal.
pub fn remove_temporary_when_stopped() {
    for &number in REQUESTS.iter().chain(&FATAL).chain(MORE) {
        // SAFETY: `stop` has the type of a handler, and calls nothing but what a handler may call.
        unsafe {
            if signal(number, stop as extern "C" fn(c_int) as usize) == IGNORE {
                signal(number, IGNORE);
            }
        }
    }
    if let Some(number) = FILE_SIZE {
        // SAFETY: ignoring a signal runs no code.
        unsafe { signal(number, IGNORE) };
    }
}

/// The same, but the first SIGHUP, SIGINT or SIGTERM only makes [`requested`] true: the program is to end by itself
/// soon. A second one ends it as above.
pub fn note_first_request() {
    NOTES_REQUESTS.store(true, Ordering::SeqCst);
    remove_temporary_when_stopped();
}

/// Whether a request to stop came since [`note_first_request`].
#[must_use]
pub fn requested() -> bool {
    REQUESTED.load(Ordering::SeqCst)
}

extern "C" fn stop(number: c_int) {
    let is_request = REQUESTS.contains(&number) && NOTES_REQUESTS.load(Ordering::SeqCst);
    if is_request && !REQUESTED.swap(true, Ordering::SeqCst) {
        return;
    }
    FILES.iter().for_each(Slot::remove);
    // SAFETY: all may be called in a handler. A raised signal waits until the handler returns, and then ends the
    // process, unless it is process 1.
    unsafe {
        if getpid() == 1 {
            _exit(128 + number);
        }
        signal(number, DEFAULT);
        raise(number);
    }
}

#[cfg(test)]
mod tests;
