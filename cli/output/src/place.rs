//! Follows the links of an output's path, and opens the regular file, the device or the pipe to which it leads.
//!
//! Standard output needs care. If it is closed, the standard library opens `/dev/null` in its place before `main`. It
//! also reports success for a write to a standard output that is not open for writing. In both cases the picture would
//! be lost, and the exit status would be 0.

#![allow(unsafe_code)]

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{FileTypeExt, MetadataExt};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use rustix::fs::{Access, AtFlags, CWD, OFlags, accessat, fcntl_getfl};
use rustix::io::{Errno, fcntl_getfd};
use rustix::stdio::stdout;

use crate::temporary::Temporary;

const STDOUT_NAMES: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

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

/// Whether an output to `path` goes to standard output.
pub fn is_stdout(path: &Path) -> bool {
    follow(path).is_ok_and(|path| STDOUT_NAMES.iter().any(|name| path == Path::new(name)))
}

/// Follows all links from `path`. Returns the path of a file that is no link, a path at which no file exists, or a name
/// of standard output.
///
/// # Errors
/// An error if there are too many links. [`ErrorKind::PermissionDenied`] if `path` or one of its folders is a link in a
/// folder of all users, because another user may have made the link. [`ErrorKind::InvalidFilename`] if `path` ends in no
/// name.
pub fn follow(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    // Linux follows so many links at most.
    for _ in 0..40 {
        // For `folder/` and `folder/.` the standard library returns the name `folder`.
        let Some(_) = path.file_name().filter(|name| path.as_os_str().as_bytes().ends_with(name.as_bytes())) else {
            return error(ErrorKind::InvalidFilename, "it is not the name of a file");
        };
        let is_foreign =
            |part: &Path| part.is_symlink() && parent(part).metadata().is_ok_and(|folder| is_shared(&folder));
        if path.ancestors().any(is_foreign) {
            let text = "it leads through a link in a folder of all users, such as /tmp; name the file itself";
            return error(ErrorKind::PermissionDenied, text);
        }
        match fs::read_link(&path) {
            Ok(text) if !STDOUT_NAMES.iter().any(|name| path == Path::new(name)) => path = parent(&path).join(text),
            _ => return Ok(path),
        }
    }
    Err(Errno::LOOP.into())
}

/// Returns the folder of the file at `path`.
pub fn parent(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether all users may create files in a folder, and remove only their own, as in `/tmp`: it is "sticky".
pub fn is_shared(folder: &Metadata) -> bool {
    folder.mode() & 0o1002 == 0o1002
}

/// Returns an error with these words.
pub fn error<T>(kind: ErrorKind, text: &str) -> io::Result<T> {
    Err(io::Error::new(kind, text))
}
