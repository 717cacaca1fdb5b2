//! Standard output as a file. It also detects whether standard output was closed when the process started.
//!
//! If standard output is closed, the standard library opens `/dev/null` in its place before `main`. It also reports
//! success for a write to a standard output that is not open for writing. In both cases the picture would be lost, and
//! the exit status would be 0.

#![allow(unsafe_code)]

use std::ffi::c_int;
use std::fs::File;
use std::io::{self, Write};
use std::os::fd::AsFd;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether descriptor 1 (standard output) was closed when the process started.
static CLOSED: AtomicBool = AtomicBool::new(false);

const STDOUT: c_int = 1;
/// The command of `fcntl` that returns the flags of a descriptor. It fails if the descriptor is closed.
const GET_DESCRIPTOR_FLAGS: c_int = 1;
/// The command of `fcntl` that returns the flags of an open file, which include its access mode.
const GET_FILE_FLAGS: c_int = 3;
/// The bits of the flags that hold the access mode, and the value of these bits for a file that is open only for
/// reading.
const ACCESS: c_int = 3;
const READ_ONLY: c_int = 0;

// SAFETY: the C library of every Unix has this function, with this type. Both commands have these values on every Unix.
unsafe extern "C" {
    fn fcntl(descriptor: c_int, command: c_int, ...) -> c_int;
}

/// Returns what `fcntl` says of standard output, or -1 if it is closed.
fn flags(command: c_int) -> c_int {
    // SAFETY: these two commands take no further argument and change nothing.
    unsafe { fcntl(STDOUT, command) }
}

/// A function that the loader calls before the standard library starts. It sets [`CLOSED`].
// SAFETY: the section holds addresses of functions of this type, and this function needs no part of the standard
// library that must be started first.
#[cfg(any(target_os = "linux", target_os = "macos"))]
#[used]
#[cfg_attr(target_os = "linux", unsafe(link_section = ".init_array"))]
#[cfg_attr(target_os = "macos", unsafe(link_section = "__DATA,__mod_init_func"))]
static BEFORE_MAIN: extern "C" fn() = {
    extern "C" fn look() {
        CLOSED.store(flags(GET_DESCRIPTOR_FLAGS) == -1, Ordering::SeqCst);
    }
    look
};

/// Returns standard output as a file without a buffer. Its writes return all errors of the system.
///
/// # Errors
/// [`io::ErrorKind::NotConnected`] if standard output was closed when the process started.
/// [`io::ErrorKind::PermissionDenied`] if it is open only for reading.
pub fn open() -> io::Result<File> {
    if CLOSED.load(Ordering::SeqCst) {
        return Err(io::Error::new(io::ErrorKind::NotConnected, "standard output is closed"));
    }
    let file_flags = flags(GET_FILE_FLAGS);
    if file_flags == -1 {
        return Err(io::Error::last_os_error());
    }
    if file_flags & ACCESS == READ_ONLY {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "standard output is open for reading only"));
    }
    let mut stdout = io::stdout();
    stdout.flush()?;
    Ok(File::from(stdout.as_fd().try_clone_to_owned()?))
}
