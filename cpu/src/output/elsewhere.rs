//! Places on systems that are no Unix: the standard library's functions alone, and none of the checks before writing.

use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A place that may be writable.
#[derive(Debug)]
pub enum Place {
    /// Takes the bytes as they come.
    Direct(File),
    /// A pipe with a name.
    #[allow(dead_code, reason = "a file system of Unix alone has these")]
    Pipe(PathBuf),
    /// A regular file, to be replaced or made.
    Regular(Temporary),
}

impl Place {
    /// # Errors
    /// What the system says.
    pub fn find(path: &Path, sync: bool) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            Ok(metadata) if !metadata.is_file() => OpenOptions::new().write(true).open(path).map(Self::Direct),
            Ok(_) => Temporary::beside(fs::canonicalize(path)?, sync).map(Self::Regular),
            Err(_) => Temporary::beside(path.to_owned(), sync).map(Self::Regular),
        }
    }
}

/// A file with a name of its own beside the one that it will replace. Nothing but dropping removes it.
#[derive(Debug)]
pub struct Temporary {
    /// Closed before the renaming.
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

    /// Puts the file in its place.
    ///
    /// # Errors
    /// What the system says.
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
        // After a renaming there is nothing under this name.
        let _ = fs::remove_file(&self.path);
    }
}
