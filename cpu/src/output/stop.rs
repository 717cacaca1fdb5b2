//! A process that is asked to stop takes its temporary file with it.
//!
//! A picture under a temporary name is half a picture: nobody wants it, and nobody would ever remove it. The name of the
//! one file that is being written is kept where a signal handler may look; the programs install such a handler, the
//! library alone changes nothing about signals. Against SIGKILL nothing helps: the old picture stands, and a hidden
//! `.render-*.tmp` may stay beside it.

#![allow(unsafe_code)]

use std::ffi::{CString, c_char, c_int};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;
use std::sync::atomic::{AtomicPtr, Ordering};

/// A path that `unlink` takes, or null. Whoever swaps it out owns it.
static TEMPORARY: AtomicPtr<c_char> = AtomicPtr::new(ptr::null_mut());

/// Hangup, interruption, quit and termination have these numbers on every Unix.
const STOPS: [c_int; 4] = [1, 2, 3, 15];
/// The limit on processor time, and the one on file sizes, whose signal is better an error of the write.
#[cfg(any(target_os = "linux", target_os = "macos"))]
const LIMITS: Option<[c_int; 2]> = Some([24, 25]);
#[cfg(not(any(target_os = "linux", target_os = "macos")))]
const LIMITS: Option<[c_int; 2]> = None;

/// What a signal may be set to beside the address of a function.
const DEFAULT: usize = 0;
const IGNORE: usize = 1;

// SAFETY: the C library of every Unix has these, with these types; the standard library links it already.
unsafe extern "C" {
    fn signal(number: c_int, handler: usize) -> usize;
    fn raise(number: c_int) -> c_int;
    fn unlink(path: *const c_char) -> c_int;
}

/// From now on the file at `path` is removed when the process is asked to stop. One file at a time: a second takes the
/// place of the first.
pub(super) fn remember(path: &Path) {
    // A path with a NUL byte names no file that could be there.
    let name = CString::new(path.as_os_str().as_bytes()).map_or(ptr::null_mut(), CString::into_raw);
    free(TEMPORARY.swap(name, Ordering::SeqCst));
}

/// The file has its place or is gone.
pub(super) fn forget() {
    free(TEMPORARY.swap(ptr::null_mut(), Ordering::SeqCst));
}

fn free(name: *mut c_char) {
    if !name.is_null() {
        // SAFETY: it comes from `CString::into_raw` in `remember`, and having swapped it out nobody else has it.
        drop(unsafe { CString::from_raw(name) });
    }
}

/// Removes the file that is being written, if any: for whoever is about to end the process. Does nothing that a signal
/// handler may not do.
pub fn remove_temporary() {
    // Not freed: the process ends, and a signal handler may not free.
    let name = TEMPORARY.swap(ptr::null_mut(), Ordering::SeqCst);
    if !name.is_null() {
        // SAFETY: it is a C string from `remember` that only this swap took out, and it is never freed.
        unsafe { unlink(name) };
    }
}

/// From now on a signal that asks this process to stop removes the temporary file first; the process then ends by the
/// signal, as it would have. Signals that are ignored stay ignored, as `nohup` wants it. A write beyond the limit on file
/// sizes becomes an error and not a signal.
pub fn remove_temporary_when_stopped() {
    let [processor_time, file_size] = LIMITS.map_or([None; 2], |limits| limits.map(Some));
    for number in STOPS.into_iter().chain(processor_time) {
        // SAFETY: `stop` has the type of a handler, and calls nothing but what a handler may call.
        unsafe {
            if signal(number, stop as extern "C" fn(c_int) as usize) == IGNORE {
                signal(number, IGNORE);
            }
        }
    }
    if let Some(number) = file_size {
        // SAFETY: ignoring a signal runs no code.
        unsafe { signal(number, IGNORE) };
    }
}

extern "C" fn stop(number: c_int) {
    remove_temporary();
    // SAFETY: both may be called in a handler. The signal waits until the handler returns, and then ends the process.
    unsafe {
        signal(number, DEFAULT);
        raise(number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // One test for all: what is remembered is a single place for the whole process, and other tests write files.
    #[test]
    fn the_file_that_is_remembered_is_removed_and_no_other() {
        let path = |name| std::env::temp_dir().join(format!("render-stop-{name}-{}", std::process::id()));
        let (first, second) = (path("first"), path("second"));
        let mut removed = false;
        // Another test's file may take the place in between; a few tries are enough.
        for _ in 0..1000 {
            std::fs::write(&first, "1").expect("the temporary folder is writable");
            std::fs::write(&second, "2").expect("the temporary folder is writable");
            remember(&first);
            remember(&second);
            remove_temporary();
            assert!(first.exists(), "it was forgotten for the second");
            if !second.exists() {
                removed = true;
                break;
            }
        }
        assert!(removed);
        std::fs::remove_file(first).expect("it is there");
    }
}
