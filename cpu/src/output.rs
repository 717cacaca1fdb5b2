//! Writing a file so that it is either the old one or the new one, never a mixture.
//!
//! A regular file is written aside and put in its place when it is complete. Anything else that can be written to
//! (`/dev/stdout`, `/dev/null`, a pipe) takes the bytes directly. What is promised and why stands in
//! `docs/decisions.md`. Uses [`input::error`](crate::input::error) alone. Begin with [`Output`].
//!
//! ```
//! use cpu::internals::output::{Options, Output};
//!
//! let path = std::env::temp_dir().join(format!("text-{}.txt", std::process::id()));
//! let output = Output::open(&path, Options::default())?;
//! // The long work comes here: whatever forbids writing is known by now.
//! output.fill(|file| file.write_all(b"text"))?;
//! assert_eq!(std::fs::read(&path)?, b"text");
//! # std::fs::remove_file(path)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(unix)]
mod folder;
#[cfg(unix)]
mod place;
#[cfg(unix)]
mod stdout;
#[cfg(unix)]
pub mod stop;
#[cfg(unix)]
mod temporary;

#[cfg(not(unix))]
#[path = "output/elsewhere.rs"]
mod place;

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::input::error::Error;
use crate::output::place::Place;

/// How a file is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// [`Output::commit`] waits until the file and its name are on the disk. Then a loss of power leaves the old file
    /// or the new one too. Without it the file system decides what a loss of power leaves.
    pub sync: bool,
}

/// A place to write to that was found writable when it was opened.
///
/// The bytes are not buffered: hand them over in large pieces. Dropped without [`Output::commit`], a regular file is as
/// it was, and nothing else is left.
#[derive(Debug)]
pub struct Output {
    /// As the caller named it, for messages.
    named: PathBuf,
    place: Place,
    /// Why the first write failed that did. Encoders such as `png` lose errors of the bytes that they write at their
    /// end.
    failure: Option<io::Error>,
}

impl Output {
    /// Checks that `path` can be written, and changes nothing: a long rendering should not end in a refusal that could
    /// have come at its start.
    ///
    /// # Errors
    /// [`Error::Write`]: it is a folder or a socket, its folder does not exist or takes no file, it is read-only or
    /// mounted, or it is another user's and may not be replaced; or it is standard output, which is closed.
    pub fn open(path: &Path, options: Options) -> Result<Self, Error> {
        let place = Place::find(path, options.sync).map_err(|cause| Error::Write { path: path.to_owned(), cause })?;
        Ok(Self { named: path.to_owned(), place, failure: None })
    }

    /// Puts what was written in its place.
    ///
    /// # Errors
    /// [`Error::Write`] when the system fails, or when a write has failed, even if its error was ignored. A regular
    /// file is then as it was, unless the message says that only its way onto the disk is uncertain.
    pub fn commit(self) -> Result<(), Error> {
        let result = match (self.failure, self.place) {
            (Some(cause), _) => Err(cause),
            (None, Place::Regular(file)) => file.commit(),
            // One that got no bytes is opened and closed: its reader waits for that.
            (None, Place::Pipe(path)) => open_pipe(&path).map(drop),
            (None, Place::Direct(_)) => Ok(()),
        };
        result.map_err(|cause| Error::Write { path: self.named, cause })
    }

    /// Writes what `write` writes, and commits it.
    ///
    /// # Errors
    /// [`Error::Write`] when `write` or the system fails; a regular file is then as for [`Output::commit`].
    pub fn fill(mut self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
        match write(&mut self) {
            Ok(()) => self.commit(),
            Err(cause) => Err(Error::Write { path: self.named, cause }),
        }
    }
}

impl Output {
    /// Keeps the first error of a write. Callers write again after an interruption, so that is none.
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
        // Neither a file nor a descriptor has a buffer of its own.
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

/// Waits for a reader.
fn open_pipe(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

/// Refuses an output that is one of the files that are read, under whatever name. To be called before they are read.
///
/// # Errors
/// [`Error::Write`]. Devices and pipes may be both.
pub fn refuse_inputs(out: &Path, inputs: &[&Path]) -> Result<(), Error> {
    match inputs.iter().find(|input| is_same_file(out, input)) {
        None => Ok(()),
        Some(input) => {
            let name = input.as_os_str().to_string_lossy();
            let text = format!("it is the same file as the input [{name}]; choose another file for the output");
            Err(Error::Write { path: out.to_owned(), cause: io::Error::new(io::ErrorKind::InvalidInput, text) })
        }
    }
}

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
