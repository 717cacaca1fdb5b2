//! Removes temporary files when a signal ends the process.
//!
//! The names of temporary files are kept in a list that a signal handler may read. Programs install the handler with
//! [`remove_temporary_when_stopped`]; without that call no signal is changed. SIGKILL and faults of the program run no
//! handler: the old file is unchanged, but a hidden `.render-*.tmp` may be left if the file system does not support
//! files without a name, or if the signal comes just before the renaming.

#![allow(unsafe_code)]

use std::ffi::{CStr, CString, c_int};
use std::fs::File;
use std::hash::{BuildHasher, RandomState};
use std::io;
use std::os::fd::{AsRawFd, BorrowedFd, RawFd};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use rustix::fs::{AtFlags, unlinkat};
use rustix::io::Errno;

/// The first of all temporary names of this process, which form a list. No name leaves the list, so a handler may read
/// it at any time. Each costs about 100 bytes.
static FIRST: OnceLock<&'static Name> = OnceLock::new();
/// Whether the handler only records the first request to stop. [`note_first_request`] sets it.
static NOTES_REQUESTS: AtomicBool = AtomicBool::new(false);
/// Whether a request to stop has come. The handler sets it.
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// A hidden temporary name of a file in the open folder that has the descriptor `folder`.
#[derive(Debug)]
pub(crate) struct Name {
    folder: RawFd,
    pub name: CString,
    /// Whether the file must be removed. Only the thread or handler that sets this to false removes the file.
    is_temporary: AtomicBool,
    next: OnceLock<&'static Name>,
}

/// The signals that request to stop: SIGHUP, SIGINT and SIGTERM. They have these numbers on every Unix.
const REQUESTS: [c_int; 3] = [1, 2, 15];
/// Other signals that end a process from outside, and abort: SIGQUIT, SIGABRT, SIGUSR1, SIGUSR2, SIGALRM and SIGXCPU.
const OTHERS: [c_int; 6] = [3, 6, 10, 12, 14, 24];

/// Values of a signal's handler that stand for the default action and for none.
const DEFAULT: usize = 0;
const IGNORE: usize = 1;

// SAFETY: the C library of every Unix has these functions with these types, and the standard library links to it.
unsafe extern "C" {
    fn signal(number: c_int, handler: usize) -> usize;
    safe fn raise(number: c_int) -> c_int;
    safe fn _exit(status: c_int) -> !;
}

impl Name {
    /// Registers a random name for a file in `folder`, and calls `make`, which creates a file with this name. If the
    /// name is in use, `make` must fail. The folder must stay open until [`Name::remove`] or [`Name::forget`] is
    /// called.
    ///
    /// # Errors
    /// The error of `make`.
    pub fn new<T>(
        folder: &File,
        make: impl FnOnce(&CStr) -> Result<T, Errno>,
    ) -> io::Result<(Option<&'static Self>, T)> {
        // The name does not contain the target's name, which may already have the largest length. The random number
        // makes it differ from the names of all other processes on all machines.
        let process = std::process::id();
        let name = CString::new(format!(".render-{process}-{:016x}.tmp", RandomState::new().hash_one(process)))?;
        let (folder, is_temporary) = (folder.as_raw_fd(), AtomicBool::new(true));
        let this: &'static Self = Box::leak(Box::new(Self { folder, name, is_temporary, next: OnceLock::new() }));
        let mut place = &FIRST;
        while place.set(this).is_err() {
            place = place.get().map_or(place, |taken| &taken.next);
        }
        // After an error the name may belong to a file of another process, which must not be removed.
        Ok((Some(this), make(&this.name).inspect_err(|_| this.forget())?))
    }

    /// Marks the file as no longer temporary. Call this when it has its final name.
    pub fn forget(&self) {
        self.is_temporary.store(false, Ordering::SeqCst);
    }

    /// Removes the file, if it is still temporary. A signal handler may call this function.
    pub fn remove(&self) {
        if self.is_temporary.swap(false, Ordering::SeqCst) {
            // SAFETY: the folder stays open while the file is temporary. If another thread has just removed the file
            // and closed the folder, no file has this name.
            let folder = unsafe { BorrowedFd::borrow_raw(self.folder) };
            let _ = unlinkat(folder, &self.name, AtFlags::empty());
        }
    }
}

/// Installs a handler that removes the temporary files of this process when a signal ends it.
///
/// After that the process ends by this signal. A signal whose action is to ignore it stays ignored, as `nohup` needs
/// it. Process 1 is special, because a default action never ends it: it exits with the status 128 plus the signal's
/// number. A write beyond the limit on file sizes returns an error, and no signal is sent.
pub fn remove_temporary_when_stopped() {
    for &number in REQUESTS.iter().chain(&OTHERS) {
        // SAFETY: `stop` has the type of a handler, and calls only functions that a handler may call.
        unsafe {
            if signal(number, stop as extern "C" fn(c_int) as usize) == IGNORE {
                signal(number, IGNORE);
            }
        }
    }
    // 25 is SIGXFSZ, for the limit on file sizes. It is ignored, so that the write returns an error instead.
    // SAFETY: ignoring a signal runs no code.
    unsafe { signal(25, IGNORE) };
}

/// Installs the handler of [`remove_temporary_when_stopped`], with one difference: the first SIGHUP, SIGINT or SIGTERM
/// only makes [`requested`] return true. The program should then end by itself soon. A second such signal ends it at
/// once.
pub fn note_first_request() {
    NOTES_REQUESTS.store(true, Ordering::SeqCst);
    remove_temporary_when_stopped();
}

/// Whether a SIGHUP, SIGINT or SIGTERM came since [`note_first_request`] was called.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::SeqCst)
}

extern "C" fn stop(number: c_int) {
    if NOTES_REQUESTS.load(Ordering::SeqCst) && REQUESTS.contains(&number) && !REQUESTED.swap(true, Ordering::SeqCst) {
        return;
    }
    let mut place = &FIRST;
    while let Some(name) = place.get() {
        name.remove();
        place = &name.next;
    }
    if std::process::id() == 1 {
        _exit(128 + number);
    }
    // SAFETY: a handler may call this function. The default action runs no code.
    unsafe { signal(number, DEFAULT) };
    // The signal is blocked until the handler returns. Then it ends the process.
    raise(number);
}
