//! Standard output as a file, and whether it was open when the process started.
//!
//! If standard output is closed, the standard library opens `/dev/null` in its place before `main`. And it reports
//! success for a write to a standard output that is not writable. In both cases the picture would be lost, and the exit
//! status would be 0.

#![allow(unsafe_code)]

use std::ffi::c_int;
use std::fs::File;
use std::io::{self, Write};
use std::os::fd::AsFd;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether descriptor 1 was closed when the process started.
static CLOSED: AtomicBool = AtomicBool::new(false);

const STDOUT: c_int = 1;
/// The command of `fcntl` that returns the flags of a descriptor. It fails if the descriptor is closed.
const GET_DESCRIPTOR_FLAGS: c_int = 1;
/// The command of `fcntl` that returns the flags of the open file, its access mode among them.
const GET_FILE_FLAGS: c_int = 3;
/// The bits that tell for what a file is open, and their value for reading only.
const ACCESS: c_int = 3;
const READ_ONLY: c_int = 0;

// SAFETY: the C library of every Unix has this function, with this type, and these commands.
unsafe extern "C" {
    fn fcntl(descriptor: c_int, command: c_int, ...) -> c_int;
}

fn flags(command: c_int) -> c_int {
    // SAFETY: these two commands take no further argument and change nothing.
    unsafe { fcntl(STDOUT, command) }
}

/// A function that the loader calls before the standard library starts.
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

/// Standard output as a file, which has no buffer and reports all errors.
///
/// # Errors
/// Standard output was closed when the process started, or it is not open for writing.
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
