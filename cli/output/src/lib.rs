//! Writes a file so that its name always has either the complete old file or the complete new one.
//!
//! The bytes of a regular file are written to a temporary file, which replaces the old file when it is complete.
//! Devices and pipes such as `/dev/stdout` and `/dev/null` get the bytes directly. `docs/decisions.md` says what is
//! promised and why. Begin with [`Output`].
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

mod error;
#[cfg(unix)]
mod folder;
#[cfg(unix)]
mod place;
#[cfg(unix)]
pub mod stack;
#[cfg(unix)]
mod stdout;
#[cfg(unix)]
pub mod stop;
#[cfg(unix)]
mod temporary;

#[cfg(not(unix))]
#[path = "elsewhere.rs"]
mod place;

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub use crate::error::Error;
use crate::place::Place;

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
    written.or_else(|error| if error.cause.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(error) })
}

/// An output that is being written: a regular file, a device or a pipe. It implements [`Write`].
///
/// The output has no buffer, so write large pieces. If this value is dropped without [`Output::commit`], a regular file
/// is unchanged, and no temporary file is left.
#[derive(Debug)]
pub struct Output {
    /// The path as the caller named it, for error messages.
    named: PathBuf,
    place: Place,
    /// The error of the first write that failed. [`Output::commit`] returns it, because encoders such as `png` ignore
    /// the errors of their last writes.
    failure: Option<io::Error>,
}

impl Output {
    /// Checks as far as possible that `path` can be written, without changing the file. Call this before long work, so
    /// that an output that cannot be written is found early.
    ///
    /// # Errors
    /// [`Error`] in these cases: `path` is a folder or a socket; its folder does not exist, or no file can be created
    /// there; the file is read-only or mounted, or belongs to another user and may not be replaced; it is standard
    /// output, which is closed.
    pub fn open(path: &Path, options: Options) -> Result<Self, Error> {
        let place = Place::find(path, options.sync).map_err(|cause| Error::new(path, cause))?;
        Ok(Self { named: path.to_owned(), place, failure: None })
    }

    /// Whether the output is a regular file, which [`Output::commit`] replaces. A device or a pipe gets the bytes when
    /// they are written.
    #[must_use]
    pub const fn is_regular(&self) -> bool {
        matches!(self.place, Place::Regular(_))
    }

    /// Replaces the old file by the new one. Call this when all bytes are written.
    ///
    /// # Errors
    /// [`Error`] if the system returns an error now, or if any earlier write failed, even if the caller ignored that
    /// error. A regular file is then unchanged, with one exception that the message names: the new file has its name,
    /// but may not be on the disk yet.
    pub fn commit(self) -> Result<(), Error> {
        let result = match (self.failure, self.place) {
            (Some(cause), _) => Err(cause),
            (None, Place::Regular(file)) => file.commit(),
            // A pipe to which no bytes were written is opened and closed here, because its reader waits for that.
            (None, Place::Pipe(path)) => open_pipe(&path).map(drop),
            (None, Place::Direct(_)) => Ok(()),
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

impl Output {
    /// Stores `error` if it is the first failure of this output. An interruption is no failure, because callers repeat
    /// an interrupted write.
    fn remember(&mut self, error: &io::Error) {
        if error.kind() != io::ErrorKind::Interrupted && self.failure.is_none() {
            self.failure = Some(error.raw_os_error().map_or(error.kind().into(), io::Error::from_raw_os_error));
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let result = self.place.write(bytes);
        if let Err(error) = &result {
            self.remember(error);
        }
        result
    }

    fn flush(&mut self) -> io::Result<()> {
        // There is no buffer to flush.
        Ok(())
    }
}

impl Place {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Self::Pipe(path) = self {
            *self = Self::Direct(open_pipe(path)?);
        }
        match self {
            Self::Regular(file) => file.write(bytes),
            Self::Direct(file) => file.write(bytes),
            Self::Pipe(_) => Err(io::ErrorKind::NotConnected.into()),
        }
    }
}

/// Opens the named pipe at `path` for writing. The call waits until another process opens the pipe for reading.
fn open_pipe(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

/// Refuses an output that is the same file as one of the inputs, even if their paths differ. Call this before the
/// inputs are read. A device or a pipe may be both input and output.
///
/// # Errors
/// [`Error`] with a message that names the first such input.
pub fn refuse_inputs(out: &Path, inputs: &[&Path]) -> Result<(), Error> {
    match inputs.iter().find(|input| is_same_file(out, input)) {
        None => Ok(()),
        Some(input) => {
            let name = input.as_os_str().to_string_lossy();
            let text = format!("it is the same file as the input [{name}]; choose another file for the output");
            Err(Error::new(out, io::Error::new(io::ErrorKind::InvalidInput, text)))
        }
    }
}

/// Refuses outputs of which two are one file, even if their paths differ. Call this before they are opened. `/dev/null`
/// may be several outputs.
///
/// # Errors
/// [`Error`] with a message that names both outputs.
pub fn refuse_one_file(outs: &[&Path]) -> Result<(), Error> {
    let targets: Vec<_> = outs.iter().map(|out| target(out)).collect();
    for (index, out) in outs.iter().enumerate().filter(|(index, _)| targets[*index] != Path::new("/dev/null")) {
        if let Some(other) = targets[..index].iter().position(|other| *other == targets[index]) {
            let name = outs[other].to_string_lossy();
            let text = format!("it is the same file as the output [{name}]; the outputs need a file each");
            return Err(Error::new(out, io::Error::new(io::ErrorKind::InvalidInput, text)));
        }
    }
    Ok(())
}

/// Whether an output to `path` goes to standard output.
#[must_use]
pub fn is_stdout(path: &Path) -> bool {
    target(path) == Path::new("/dev/stdout")
}

/// Returns the path that an output to `path` gets, without links: `/dev/stdout` for all names of standard output. The
/// file need not exist.
fn target(path: &Path) -> PathBuf {
    let path = place::follow(path).unwrap_or_else(|_| path.to_owned());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match (fs::canonicalize(folder), path.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => path,
    }
}

/// Whether both paths lead to one regular file.
fn is_same_file(one: &Path, other: &Path) -> bool {
    match (fs::metadata(one), fs::metadata(other)) {
        #[cfg(unix)]
        (Ok(one), Ok(other)) => one.is_file() && folder::is_same(&one, &other),
        #[cfg(not(unix))]
        (Ok(metadata), Ok(_)) => {
            metadata.is_file() && matches!((fs::canonicalize(one), fs::canonicalize(other)), (Ok(a), Ok(b)) if a == b)
        }
        _ => false,
    }
}

#[cfg(all(test, unix))]
mod tests;
