//! Opens the regular file, the device or the pipe to which an output's path leads.
//!
//! Standard output needs care. If it is closed, the standard library opens `/dev/null` in its place before `main`. It
//! also reports success for a write to a standard output that is not open for writing. In both cases the picture would
//! be lost, and the exit status would be 0.

#![allow(unsafe_code)]

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::os::unix::fs::FileTypeExt;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use rustix::fs::{Access, AtFlags, CWD, OFlags, accessat, fcntl_getfl};
use rustix::io::fcntl_getfd;
use rustix::stdio::stdout;

use crate::links::{error, follow, is_stdout};
use crate::temporary::Temporary;

/// Whether standard output was closed when the process started.
static STDOUT_IS_CLOSED: AtomicBool = AtomicBool::new(false);

/// The loader calls [`look`] before the standard library starts.
// SAFETY: the section holds addresses of functions of this type, and this function only makes a system call, which
// needs no part of the standard library that must be started first.
#[used]
#[unsafe(link_section = ".init_array")]
static BEFORE_MAIN: extern "C" fn() = look;

extern "C" fn look() {
    STDOUT_IS_CLOSED.store(fcntl_getfd(stdout()).is_err(), Ordering::SeqCst);
}

/// Follows the links of `path`, checks that the target can be written, and opens it. If `sync` is true, the commit of a
/// regular file waits until the file is on the disk.
///
/// Returns an open file, and what gives it its name if it is a regular file. A device has no such second part. For a
/// named pipe both are `None`: it is opened at the first write, because opening it waits for a reader.
///
/// # Errors
/// The reason why the target cannot be written, as far as it is known before writing.
pub fn find(path: &Path, sync: bool) -> io::Result<(Option<File>, Option<Temporary>)> {
    let target = follow(path)?;
    match fs::metadata(path).map(|file| file.file_type()) {
        _ if is_stdout(&target) => Ok((Some(open_stdout()?), None)),
        Ok(kind) if kind.is_fifo() => {
            Ok(accessat(CWD, path, Access::WRITE_OK, AtFlags::EACCESS).map(|()| (None, None))?)
        }
        // Opening a folder or a socket is an error of the system.
        Ok(kind) if !kind.is_file() => Ok((Some(open(path)?), None)),
        // A link in /proc leads to an open file. If that file was removed, the link's text is no path.
        Ok(_) if !target.exists() => error(ErrorKind::NotFound, "it is an open file that has lost its name"),
        _ => Temporary::new(&target, sync).map(|(file, temporary)| (Some(file), Some(temporary))),
    }
}

/// Opens a device or a pipe for writing. Opening a pipe waits until another process opens it for reading.
///
/// # Errors
/// The error of the system.
pub fn open(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

/// Returns standard output as a file without a buffer. Its writes return all errors of the system.
fn open_stdout() -> io::Result<File> {
    if STDOUT_IS_CLOSED.load(Ordering::SeqCst) {
        return error(ErrorKind::NotConnected, "standard output is closed");
    }
    if fcntl_getfl(stdout())?.intersection(OFlags::RWMODE) == OFlags::RDONLY {
        return error(ErrorKind::PermissionDenied, "standard output is open for reading only");
    }
    io::stdout().flush()?;
    Ok(File::from(stdout().try_clone_to_owned()?))
}
