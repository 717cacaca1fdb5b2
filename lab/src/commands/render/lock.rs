//! Keeps two runs from writing one checkpoint.

use std::fs::{self, File, TryLockError};
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use crate::{Failure, terminal};

/// The lock of a checkpoint: a file beside it, locked by the system until this process ends, and removed before.
#[derive(Debug)]
pub struct Lock {
    file: File,
    path: PathBuf,
}

impl Lock {
    /// Locks the checkpoint `path`.
    ///
    /// # Errors
    /// Another run has the lock, or there can be no file beside the checkpoint.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        let mut name = path.as_os_str().to_owned();
        name.push(".lock");
        let place = PathBuf::from(name);
        let about = |error: io::Error| Failure::from(format!("{}: {error}", terminal::name(&place)));
        loop {
            let file = File::options().create(true).append(true).open(&place).map_err(about)?;
            if !file.metadata().map_err(about)?.is_file() {
                return Err(about(io::Error::other("it is not a regular file")));
            }
            match file.try_lock() {
                Ok(()) => {}
                // Some network file systems have no locks.
                Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {}
                Err(TryLockError::Error(error)) => return Err(about(error)),
                Err(TryLockError::WouldBlock) => {
                    let name = terminal::name(path);
                    return Err(format!("{name}: another run keeps this checkpoint; wait for its end").into());
                }
            }
            // The other run may have removed the file after this one opened it.
            let numbers = |about: fs::Metadata| (about.dev(), about.ino());
            if fs::metadata(&place).map(numbers).ok() == file.metadata().map(numbers).ok() {
                return Ok(Self { file, path: place });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.path).and_then(|()| self.file.unlock());
    }
}
