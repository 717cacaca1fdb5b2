//! Writing a file so that it is either the old one or the new one, never a mixture.
//!
//! A regular file is written beside its place under a temporary name and renamed over it. Anything else that can be
//! written to (`/dev/stdout`, `/dev/null`, a pipe) takes the bytes directly.

#[cfg(unix)]
pub mod stop;

use std::collections::hash_map::RandomState;
use std::fs::{self, File, OpenOptions, Permissions};
use std::hash::BuildHasher;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::Error;

/// A place to write to that was found writable when it was opened.
#[derive(Debug)]
pub struct Output {
    /// As the caller named it, for messages.
    named: PathBuf,
    place: Place,
}

#[derive(Debug)]
enum Place {
    /// This process' standard output, under any of its names.
    Stdout,
    /// Something that exists and is no regular file.
    Special,
    /// A regular file, or a name that is free: where links lead to, and what it may be done with once it is there.
    Regular { target: PathBuf, permissions: Option<Permissions> },
}

const STDOUT_NAMES: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

impl Output {
    /// Checks that `path` can be written, and changes nothing: a long rendering should not end in a refusal that could
    /// have come at its start.
    ///
    /// # Errors
    /// [`Error::Write`]: it is a folder, its folder does not exist or takes no file, or it is read-only.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let place = Place::find(path).map_err(|cause| Error::Write { path: path.to_owned(), cause })?;
        Ok(Self { named: path.to_owned(), place })
    }

    /// Replaces the content by what `write` writes.
    ///
    /// # Errors
    /// [`Error::Write`] when `write` or the system fails; a regular file is then as it was.
    pub fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
        let named = self.named;
        let result = match self.place {
            Place::Stdout => write(&mut io::stdout().lock()),
            Place::Special => OpenOptions::new().write(true).open(&named).and_then(|mut file| write(&mut file)),
            Place::Regular { target, permissions } => replace(&target, permissions, write),
        };
        result.map_err(|cause| Error::Write { path: named, cause })
    }
}

impl Place {
    fn find(path: &Path) -> io::Result<Self> {
        if STDOUT_NAMES.iter().any(|name| path == Path::new(name)) {
            return Ok(Self::Stdout);
        }
        let target = match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(metadata) if !metadata.is_file() => return Ok(Self::Special),
            // Through symbolic links: the file that they lead to is replaced, not the link.
            Ok(_) => fs::canonicalize(path)?,
            Err(error) if error.kind() == io::ErrorKind::NotFound => free_name(path)?,
            Err(error) => return Err(error),
        };
        // Opening for writing, without truncating, asks whether the old file may be changed at all.
        let permissions = match OpenOptions::new().write(true).open(&target) {
            Ok(file) => Some(file.metadata()?.permissions()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        drop(Temporary::beside(&target)?);
        Ok(Self::Regular { target, permissions })
    }
}

/// The place that a name which leads to no file stands for: itself, or where a dangling link points.
fn free_name(path: &Path) -> io::Result<PathBuf> {
    let target = match fs::read_link(path) {
        Ok(target) => path.parent().unwrap_or(Path::new("")).join(target),
        Err(_) => path.to_owned(),
    };
    if target.file_name().is_none() || path.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return Err(io::Error::new(io::ErrorKind::InvalidFilename, "it is not the name of a file"));
    }
    Ok(target)
}

/// A new file that is removed when it is dropped, and when the process is asked to stop.
struct Temporary {
    file: File,
    path: PathBuf,
}

impl Temporary {
    /// One in the folder of `target`, hidden, with a name that no other has.
    fn beside(target: &Path) -> io::Result<Self> {
        const TRIES: u32 = 100;

        let process = std::process::id();
        for _ in 0..TRIES {
            // Short and without the target's own name, which may be as long as a name can be. A number from the system
            // sets processes of the same number on other machines apart, and files that a killed one left.
            let random = RandomState::new().hash_one(process);
            let path = target.with_file_name(format!(".render-{process}-{random:016x}.tmp"));
            remember(&path);
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => return Ok(Self { file, path }),
                Err(error) => {
                    forget();
                    if error.kind() != io::ErrorKind::AlreadyExists {
                        return Err(error);
                    }
                }
            }
        }
        Err(io::Error::new(io::ErrorKind::AlreadyExists, "no temporary name is free beside it; remove .render-*.tmp"))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // After a failure that is the one to report; a leftover that cannot be removed either is named by it. After a
        // renaming there is nothing under this name.
        let _ = fs::remove_file(&self.path);
        forget();
    }
}

#[cfg(unix)]
use stop::{forget, remember};

/// Elsewhere nothing but dropping removes a temporary file.
#[cfg(not(unix))]
fn remember(_: &Path) {}
#[cfg(not(unix))]
fn forget() {}

fn replace(
    target: &Path,
    permissions: Option<Permissions>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut temporary = Temporary::beside(target)?;
    write(&mut temporary.file)?;
    if let Some(permissions) = permissions {
        temporary.file.set_permissions(permissions)?;
    }
    fs::rename(&temporary.path, target)
}

#[cfg(test)]
mod tests;
