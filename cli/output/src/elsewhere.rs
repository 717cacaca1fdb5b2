//! Places on systems other than Unix. They use only functions of the standard library, and few errors are found before
//! writing.

use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What an output is written to.
#[derive(Debug)]
pub enum Place {
    /// A device, to which the bytes are written directly.
    Direct(File),
    /// A named pipe.
    #[allow(dead_code, reason = "only Unix has named pipes in the file system")]
    Pipe(PathBuf),
    /// A regular file, to be replaced or created.
    Regular(Temporary),
}

impl Place {
    /// Opens the place that `path` names.
    ///
    /// # Errors
    /// The error of the system.
    pub fn find(path: &Path, sync: bool) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            Ok(metadata) if !metadata.is_file() => OpenOptions::new().write(true).open(path).map(Self::Direct),
            Ok(_) => Temporary::beside(fs::canonicalize(path)?, sync).map(Self::Regular),
            Err(_) => Temporary::beside(path.to_owned(), sync).map(Self::Regular),
        }
    }
}

/// A temporary file beside the file that it will replace. It is removed when this is dropped, but not when a signal
/// ends the process.
#[derive(Debug)]
pub struct Temporary {
    /// The open file. It is closed before it is renamed.
    file: Option<File>,
    path: PathBuf,
    target: PathBuf,
    sync: bool,
}

impl Temporary {
    fn beside(target: PathBuf, sync: bool) -> io::Result<Self> {
        let process = std::process::id();
        let path =
            target.with_file_name(format!(".render-{process}-{:016x}.tmp", RandomState::new().hash_one(process)));
        let file = Some(OpenOptions::new().write(true).create_new(true).open(&path)?);
        Ok(Self { file, path, target, sync })
    }

    /// Renames the file to its target.
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
        // Fails after renaming, since no file has this name then.
        let _ = fs::remove_file(&self.path);
    }
}
