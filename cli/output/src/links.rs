//! Follows the links of an output's path.

use std::fs::{self, Metadata};
use std::io::{self, ErrorKind};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use rustix::io::Errno;

const STDOUT_NAMES: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// Whether an output to `path` goes to standard output.
pub fn is_stdout(path: &Path) -> bool {
    follow(path).is_ok_and(|path| STDOUT_NAMES.iter().any(|name| path == Path::new(name)))
}

/// Follows all links from `path`. Returns the path of a file that is no link, a path at which no file exists, or a name
/// of standard output.
///
/// # Errors
/// An error if there are too many links. [`ErrorKind::PermissionDenied`] if `path` or one of its folders is a link in a
/// folder of all users, because another user may have made the link. [`ErrorKind::InvalidFilename`] if `path` ends in
/// no name.
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
