//! Refuses an output that is one of the inputs.

use std::fmt;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use crate::Error;

/// Refuses an output that is the same file as one of the inputs, even if their paths differ. Call this before the
/// inputs are read. A device or a pipe may be both input and output.
///
/// # Errors
/// [`Error`] with a message that names the first such input.
pub fn refuse_inputs(out: &Path, inputs: &[&Path]) -> Result<(), Error> {
    let numbers = |path: &Path| path.metadata().ok().map(|file| (file.dev(), file.ino()));
    match inputs.iter().find(|input| out.is_file() && numbers(out) == numbers(input)) {
        Some(input) => Err(Error::same_file(out, "input", input, "choose another file for the output")),
        None => Ok(()),
    }
}

/// The cause that two paths lead to one file.
#[derive(Debug)]
pub(crate) struct SameFile {
    pub(crate) role: &'static str,
    pub(crate) other: PathBuf,
    pub(crate) remedy: &'static str,
}

impl SameFile {
    /// Returns the message as bytes, since a file's name need not be UTF-8.
    pub(crate) fn message(&self) -> Vec<u8> {
        let Self { role, other, remedy } = self;
        let name = other.as_os_str().as_encoded_bytes();
        let start = format!("it is the same file as the {role} [");
        [start.as_bytes(), name, b"]; ", remedy.as_bytes()].concat()
    }
}

impl fmt::Display for SameFile {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(&self.message()))
    }
}

impl std::error::Error for SameFile {}
