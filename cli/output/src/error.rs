//! The error of an output.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// The error of an output that cannot be written. A regular file is then unchanged, unless the message says otherwise.
#[derive(Debug)]
pub struct Error {
    /// The path of the output, as the caller named it.
    pub path: PathBuf,
    /// The cause, such as an error of the system.
    pub cause: io::Error,
}

impl Error {
    /// Returns the error of the file at `path`.
    pub(crate) fn new(path: &Path, cause: io::Error) -> Self {
        Self { path: path.to_owned(), cause }
    }

    /// Returns the message as bytes, since a file's name need not be UTF-8. `show` converts the name and the cause
    /// before they are put into the message; it can escape control characters for a terminal.
    #[must_use]
    pub fn message(&self, show: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
        let name = show(self.path.as_os_str().as_encoded_bytes());
        let cause = show(self.cause.to_string().as_bytes());
        [b"Cannot write file [", &name[..], b"]: ", &cause].concat()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(&self.message(<[u8]>::to_vec)))
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.cause)
    }
}
