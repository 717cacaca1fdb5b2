//! Outputs on systems other than Unix. This module uses only the standard library, so [`Place::find`] finds few errors
//! before the first write.

use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The target of an output, found by [`Place::find`].
#[derive(Debug)]
pub enum Place {
    /// A device, to which the bytes are written directly.
    Direct(File),
    /// A named pipe. This module never returns it, because only Unix has named pipes in the file system.
    #[allow(dead_code, reason = "only Unix has named pipes in the file system")]
    Pipe(PathBuf),
    /// A temporary file that will become a new regular file, or replace an old one.
    Regular(Temporary),
}

impl Place {
    /// Opens the device, or creates the temporary file, that an output to `path` needs. If `sync` is true,
    /// [`Temporary::commit`] waits until the file is on the disk.
    ///
    /// # Errors
    /// The error of the system, for example because `path` is a folder.
    pub fn find(path: &Path, sync: bool) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            Ok(metadata) if !metadata.is_file() => OpenOptions::new().write(true).open(path).map(Self::Direct),
            Ok(_) => Temporary::beside(fs::canonicalize(path)?, sync).map(Self::Regular),
            Err(_) => Temporary::beside(path.to_owned(), sync).map(Self::Regular),
        }
    }
}

/// Returns the path to which `path` leads.
///
/// # Errors
/// The error of the system, for example because no file exists there.
pub fn follow(path: &Path) -> io::Result<PathBuf> {
    fs::canonicalize(path)
}

/// A temporary file in the folder of the file that it will replace. It is removed when this value is dropped, but not
/// when a signal ends the process.
#[derive(Debug)]
pub struct Temporary {
    /// The open file. [`Self::commit`] closes it before it renames it, and leaves `None`.
    file: Option<File>,
    path: PathBuf,
    target: PathBuf,
    sync: bool,
}

impl Temporary {
    /// Makes an empty file beside `target`, with a name that no other program chooses.
    fn beside(target: PathBuf, sync: bool) -> io::Result<Self> {
        let process = std::process::id();
        let path =
            target.with_file_name(format!(".render-{process}-{:016x}.tmp", RandomState::new().hash_one(process)));
        let file = Some(OpenOptions::new().write(true).create_new(true).open(&path)?);
        Ok(Self { file, path, target, sync })
    }

    /// Closes the temporary file, and renames it to its target.
    ///
    /// # Errors
    /// The error of the system.
    pub fn commit(mut self) -> io::Result<()> {
        if let Some(file) = self.file.take().filter(|_| self.sync) {
            file.sync_all()?;
        }
        fs::rename(&self.path, &self.target)
    }
}

impl Write for Temporary {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.as_mut().map_or(Ok(0), |file| file.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        self.file = None;
        // Always fails after renaming, because then no file has the temporary name.
        let _ = fs::remove_file(&self.path);
    }
}
