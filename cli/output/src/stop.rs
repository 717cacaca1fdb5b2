//! Removes temporary files when a signal ends the process.
//!
//! The names of temporary files are kept in atomic variables that a signal handler may read. Programs install the
//! handler with [`remove_temporary_when_stopped`]; without that call no signal is changed. SIGKILL runs no handler: the
//! old file is unchanged, but a hidden `.render-*.tmp` may be left if the file system does not support files without a
//! name.

#![allow(unsafe_code)]

use std::ffi::{CStr, CString, c_int};
use std::io;
use std::ptr;
use std::sync::atomic::{AtomicBool, AtomicPtr, Ordering};

use crate::folder;

/// The names of the temporary files that this process is writing: at most 16 at a time.
static FILES: [Slot; 16] = [const { Slot(AtomicPtr::new(ptr::null_mut())) }; 16];
/// Whether the handler only records the first request to stop. [`note_first_request`] sets it.
static NOTES_REQUESTS: AtomicBool = AtomicBool::new(false);
/// Whether a request to stop has come. The handler sets it.
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// A pointer to the name of one temporary file, or null. Only the thread or handler that takes the pointer out removes
/// the file, so the file is removed once.
#[derive(Debug)]
struct Slot(AtomicPtr<Named>);

/// The name of a file in the open folder that has the descriptor `folder`.
#[derive(Debug)]
struct Named {
    folder: c_int,
    name: CString,
}

/// The signals that request to stop: SIGHUP, SIGINT and SIGTERM. They have these numbers on every Unix.
const REQUESTS: [c_int; 3] = [1, 2, 15];
/// Other signals that end a process and have the same numbers on every Unix: SIGQUIT, SIGILL, SIGTRAP, SIGABRT, SIGFPE,
/// SIGPIPE and SIGALRM. SIGSEGV and SIGBUS are left to the standard library, which distinguishes a stack overflow from
/// other faults.
const FATAL: [c_int; 7] = [3, 4, 5, 6, 8, 13, 14];
/// Further signals of Linux that end a process: two for users, coprocessor fault, processor time, two timers, input,
/// power, wrong system call, and the real-time signals from 34 on.
#[cfg(target_os = "linux")]
const MORE: &[c_int] = &[
    10, 12, 16, 24, 26, 27, 29, 30, 31, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53,
    54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64,
];
/// Further signals of macOS that end a process: emulation, wrong system call, processor time, two timers, two for
/// users.
#[cfg(target_os = "macos")]
const MORE: &[c_int] = &[7, 12, 24, 26, 27, 30, 31];
#[cfg(not(any(target_os = "linux", target_os = "macos")))]
const MORE: &[c_int] = &[];
/// SIGXFSZ, the signal for the limit on file sizes. It is ignored, so that the write returns an error instead.
const FILE_SIZE: Option<c_int> = if cfg!(any(target_os = "linux", target_os = "macos")) { Some(25) } else { None };

/// Special values of a signal's handler, used in place of the address of a function.
const DEFAULT: usize = 0;
const IGNORE: usize = 1;

// SAFETY: the C library of every Unix has these functions with these types, and the standard library links to it.
unsafe extern "C" {
    fn signal(number: c_int, handler: usize) -> usize;
    fn raise(number: c_int) -> c_int;
    fn getpid() -> c_int;
    fn _exit(status: c_int) -> !;
}

/// The registered name of a temporary file. The file is removed when this value is dropped, and when a signal ends the
/// process.
#[derive(Debug)]
pub(super) struct Remembered {
    slot: &'static Slot,
    named: &'static Named,
}

impl Remembered {
    /// Registers `name`, a file in the open `folder`. The folder must stay open as long as the returned value lives.
    ///
    /// # Errors
    /// An error if all 16 slots are in use, because the process writes too many files at once.
    pub fn new(folder: c_int, name: &CStr) -> io::Result<Self> {
        // Never freed, because a signal handler on another thread may still read it. Each file costs about 60 bytes.
        let named: &'static Named = Box::leak(Box::new(Named { folder, name: name.to_owned() }));
        let slot = FILES.iter().find(|slot| slot.exchange(ptr::null(), named));
        slot.map(|slot| Self { slot, named })
            .ok_or_else(|| io::Error::other("too many files are being written at once"))
    }

    /// Removes the name from the register, but not the file. Call this when the file has its final name, or was not
    /// created.
    pub fn forget(self) {
        self.slot.exchange(self.named, ptr::null());
    }
}

impl Drop for Remembered {
    fn drop(&mut self) {
        // `exchange` returns false after `forget`, or when a signal handler has removed the file already.
        if self.slot.exchange(self.named, ptr::null()) {
            folder::unlink(self.named.folder, &self.named.name);
        }
    }
}

impl Slot {
    /// Replaces the pointer `old` by `new`. Returns false, and changes nothing, if the slot does not hold `old`.
    fn exchange(&self, old: *const Named, new: *const Named) -> bool {
        self.0.compare_exchange(old.cast_mut(), new.cast_mut(), Ordering::SeqCst, Ordering::SeqCst).is_ok()
    }

    /// Removes the file whose name is in this slot, if there is one. A signal handler may call this function.
    fn remove(&self) {
        let named = self.0.swap(ptr::null_mut(), Ordering::SeqCst);
        // SAFETY: the pointer is null or comes from a `&'static Named`, which is never changed.
        if let Some(named) = unsafe { named.as_ref() } {
            folder::unlink(named.folder, &named.name);
        }
    }
}

/// Installs a handler that removes the temporary files of this process when a signal ends it.
///
/// After that the process ends by this signal. A signal whose action is to ignore it stays ignored, as `nohup` needs
/// it. Process 1 is special, because a default action never ends it: it exits with the status 128 plus the signal's
/// number. A write beyond the limit on file sizes returns an error, and no signal is sent.
pub fn remove_temporary_when_stopped() {
    for &number in REQUESTS.iter().chain(&FATAL).chain(MORE) {
        // SAFETY: `stop` has the type of a handler, and calls only functions that a handler may call.
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

/// Installs the handler of [`remove_temporary_when_stopped`], with one difference: the first SIGHUP, SIGINT or SIGTERM
/// only makes [`requested`] return true. The program should then end by itself soon. A second such signal ends it at
/// once.
pub fn note_first_request() {
    NOTES_REQUESTS.store(true, Ordering::SeqCst);
    remove_temporary_when_stopped();
}

/// Whether a SIGHUP, SIGINT or SIGTERM came since [`note_first_request`] was called.
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
    // SAFETY: a handler may call all these functions. `raise` only marks the signal, because it is blocked until the
    // handler returns. Then the signal ends the process, unless it is process 1.
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
