//! Writes a file so that its name always has either the complete old file or the complete new one.
//!
//! The bytes of a regular file are written to a temporary file, which replaces the old file when it is complete.
//! Devices and pipes such as `/dev/stdout` and `/dev/null` get the bytes directly. `docs/decisions.md` says what is
//! promised and why. Begin with [`Output`]. This crate needs Linux.
//!
//! ```
//! use output::{Options, Output};
//!
//! let path = std::env::temp_dir().join(format!("text-{}.txt", std::process::id()));
//! let output = Output::open(&path, Options::default())?;
//! // The long work comes here. Most reasons why the file could not be written have been found by `open`.
//! output.fill(|file| file.write_all(b"text"))?;
//! assert_eq!(std::fs::read(&path)?, b"text");
//! # std::fs::remove_file(path)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod links;
mod place;
mod same_file;
pub mod stop;
mod temporary;

use std::fmt;
use std::fs::File;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

pub use crate::links::{follow, is_stdout};
use crate::same_file::SameFile;
pub use crate::same_file::refuse_inputs;
use crate::temporary::Temporary;

/// Options for writing an output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Whether [`Output::commit`] waits until the file and its name are on the disk. If true, a loss of power leaves
    /// the complete old or the complete new file. If false, the result depends on the file system.
    pub sync: bool,
}

/// Writes `bytes` to standard output. A broken pipe is not an error, because programs such as `head` stop reading
/// before the end. The macros of the standard library panic instead, and report no error if the stream is closed.
///
/// # Errors
/// [`Error`] if standard output is closed, full or not writable.
pub fn print(bytes: &[u8]) -> Result<(), Error> {
    let written =
        Output::open(Path::new("/dev/stdout"), Options::default()).and_then(|out| out.fill(|out| out.write_all(bytes)));
    written.or_else(|error| if error.cause.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(error) })
}

/// An output that is being written: a regular file, a device or a pipe. It implements [`Write`].
///
/// The output has no buffer, so write large pieces. If this value is dropped without [`Output::commit`], a regular file
/// is unchanged, and no temporary file is left.
#[derive(Debug)]
pub struct Output {
    /// The path as the caller named it, for error messages.
    named: PathBuf,
    /// The open file; `None` for a named pipe before the first write.
    file: Option<File>,
    /// What gives a regular file its name; `None` for a device or a pipe.
    temporary: Option<Temporary>,
    /// What kind of error the first failed write had. [`Output::commit`] returns it, because encoders such as `png`
    /// ignore the errors of their last writes.
    failure: Option<ErrorKind>,
}

impl Output {
    /// Checks as far as possible that `path` can be written, without changing the file. Call this before long work, so
    /// that an output that cannot be written is found early.
    ///
    /// # Errors
    /// [`Error`] in these cases: `path` is a folder or a socket; its folder does not exist, or no file can be created
    /// there; the file is read-only; it is standard output, which is closed; `path` leads through a link in a folder of
    /// all users such as `/tmp`, or to the file of another user there.
    pub fn open(path: &Path, options: Options) -> Result<Self, Error> {
        let named = path.to_owned();
        let found = place::find(path, options.sync);
        let (file, temporary) = found.map_err(|cause| Error { path: path.to_owned(), cause })?;
        Ok(Self { named, file, temporary, failure: None })
    }

    /// Whether the output is a regular file, which [`Output::commit`] replaces. A device or a pipe gets the bytes when
    /// they are written.
    pub const fn is_regular(&self) -> bool {
        self.temporary.is_some()
    }

    /// Replaces the old file by the new one. Call this when all bytes are written.
    ///
    /// # Errors
    /// [`Error`] if the system returns an error now, or if any earlier write failed, even if the caller ignored that
    /// error. A regular file is then unchanged, with one exception that the message names: the new file has its name,
    /// but may not be on the disk yet.
    pub fn commit(self) -> Result<(), Error> {
        let result = match (self.failure, self.file, self.temporary) {
            (Some(kind), ..) => Err(kind.into()),
            (None, Some(file), Some(temporary)) => temporary.commit(&file),
            // A pipe to which no bytes were written is opened and closed here, because its reader waits for that.
            (None, None, _) => place::open(&self.named).map(drop),
            (None, Some(_), None) => Ok(()),
        };
        result.map_err(|cause| Error { path: self.named, cause })
    }

    /// Calls `write` with this output, and then [`Output::commit`] if `write` succeeds.
    ///
    /// # Errors
    /// [`Error`] if `write` or [`Output::commit`] fails.
    pub fn fill(mut self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
        match write(&mut self) {
            Ok(()) => self.commit(),
            Err(cause) => Err(Error { path: self.named, cause }),
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let file = match &mut self.file {
            Some(file) => file,
            pipe => pipe.insert(place::open(&self.named)?),
        };
        let written = file.write(bytes);
        // An interruption is no failure, because callers repeat an interrupted write.
        let failure = written.as_ref().err().map(io::Error::kind).filter(|kind| *kind != ErrorKind::Interrupted);
        self.failure = self.failure.or(failure);
        written
    }

    fn flush(&mut self) -> io::Result<()> {
        // There is no buffer to flush.
        Ok(())
    }
}

/// The error of an output that cannot be written. A regular file is then unchanged, unless the message says otherwise.
#[derive(Debug)]
pub struct Error {
    /// The path of the output, as the caller named it.
    pub path: PathBuf,
    /// The cause, such as an error of the system.
    pub cause: io::Error,
}

impl Error {
    /// Returns the message as bytes, since a file's name need not be UTF-8. `show` converts the name and the cause
    /// before they are put into the message; it can escape control characters for a terminal.
    #[must_use]
    pub fn message(&self, show: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
        let name = show(self.path.as_os_str().as_encoded_bytes());
        let same_file = self.cause.get_ref().and_then(|cause| cause.downcast_ref::<SameFile>());
        let cause = same_file.map_or_else(|| self.cause.to_string().into_bytes(), SameFile::message);
        [b"Cannot write file [", &name[..], b"]: ", &show(&cause)].concat()
    }

    /// Returns the error that the output `path` is the same file as `other`, which has the role "input" or "output".
    /// `remedy` says what to do.
    #[must_use]
    pub fn same_file(path: &Path, role: &'static str, other: &Path, remedy: &'static str) -> Self {
        let cause = SameFile { role, other: other.to_owned(), remedy };
        Self { path: path.to_owned(), cause: io::Error::new(ErrorKind::InvalidInput, cause) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(&self.message(<[u8]>::to_vec)))
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests;
