//! Why a file was not written.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// A file cannot be written. The file is unchanged, unless the message says otherwise.
#[derive(Debug)]
pub struct Error {
    /// The file as named by the caller.
    pub path: PathBuf,
    /// The error of the system.
    pub cause: io::Error,
}

impl Error {
    pub(crate) fn new(path: &Path, cause: io::Error) -> Self {
        Self { path: path.to_owned(), cause }
    }

    /// The message in bytes, since a file's name need not be UTF-8. `show` converts the name and the system's message
    /// before they are shown. For a terminal it escapes control characters.
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
