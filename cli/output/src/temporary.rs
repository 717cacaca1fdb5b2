//! A temporary file that becomes the new file when it is complete, and is removed if it does not become complete.

mod rights;

use std::ffi::{CStr, CString};
use std::fs::{File, Permissions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, Write};
use std::os::fd::{AsFd, AsRawFd};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::Path;

use crate::folder::Folder;
use crate::stop::Remembered;
use rights::Rights;

/// The permissions to read and write for the owner, and no permissions for other users.
const PRIVATE: u32 = 0o600;
/// The permissions to read and write for all users. The system removes those in the umask of the process.
const COMMON: u32 = 0o666;
/// A file that is being written. [`Temporary::commit`] gives it the name `target` in an open folder.
///
/// If the file system supports it, the file has no name until it is complete. Then no file is left, however the process
/// ends. Otherwise the file has a hidden temporary name. It is removed when this value is dropped or when a signal ends
/// the process.
#[derive(Debug)]
pub struct Temporary {
    // Stands before `folder` and so is dropped first, since removing the file needs the open folder.
    name: Option<Name>,
    file: File,
    folder: Folder,
    target: CString,
    /// The rights of the file that will be replaced; `None` if there is no old file.
    old: Option<Rights>,
    /// The permissions that `commit` must set; `None` if the new file has them already, or if they depend on `old`.
    mode: Option<u32>,
    sync: bool,
}

impl Temporary {
    /// Checks that `target`, which is no link, may be created or replaced, and creates the temporary file.
    ///
    /// # Errors
    /// The reason why `target` cannot be written, as far as it is known before writing.
    pub fn new(target: &Path, sync: bool) -> io::Result<Self> {
        Self::with(target, sync, Folder::create_unnamed)
    }

    /// Creates a file with a temporary name, as [`Self::new`] does on a file system without support for files without a
    /// name.
    #[cfg(test)]
    pub fn named(target: &Path, sync: bool) -> io::Result<Self> {
        Self::with(target, sync, |_, _| Err(ErrorKind::Unsupported.into()))
    }

    /// Creates the temporary file with the function `unnamed`. If that fails, creates it with a temporary name.
    fn with(target: &Path, sync: bool, unnamed: impl Fn(&Folder, u32) -> io::Result<File>) -> io::Result<Self> {
        let name = file_name(target)?;
        let folder = Folder::open(target.parent().unwrap_or(Path::new("")), sync)?;
        let old = old_file(&folder, &name)?;
        let mode = if old.is_some() { PRIVATE } else { COMMON };
        if let Ok(file) = unnamed(&folder, mode) {
            return Ok(Self { name: None, file, folder, target: name, old, mode: None, sync });
        }
        let (temporary, file) = Name::new(&folder, |name| folder.create(name, mode))?;
        let mut this = Self { name: Some(temporary), file, folder, target: name, old, mode: None, sync };
        if this.old.is_none() {
            this.mode = Some(this.file.metadata()?.mode());
            // An error is ignored: some file systems, such as those of memory cards, have no permissions.
            let _ = this.file.set_permissions(Permissions::from_mode(PRIVATE));
        }
        Ok(this)
    }

    /// Gives the complete file its final name, which replaces the old file.
    ///
    /// # Errors
    /// The error of the system. The old file is then unchanged, with one exception that the message names: the new file
    /// has its name, but its folder could not be synced.
    pub fn commit(mut self) -> io::Result<()> {
        let mode = match &self.old {
            Some(old) => Some(old.give(&self.file)?),
            None => self.mode,
        };
        if let Some(mode) = mode {
            // An error is ignored, since a file with fewer permissions is better than none.
            let _ = self.file.set_permissions(Permissions::from_mode(mode));
        }
        if self.name.is_none() && self.old.is_none() {
            self.sync_file()?;
            match self.folder.link(&self.file, &self.target) {
                // Another process has created a file of this name meanwhile. It is replaced like an old file, if this
                // process may replace it.
                Err(error) if error.kind() == ErrorKind::AlreadyExists => self.folder.may_replace(&self.target)?,
                result => return result.and_then(|()| self.sync_folder()),
            }
        }
        if self.name.is_none() {
            self.name = Some(Name::new(&self.folder, |name| self.folder.link(&self.file, name))?.0);
        }
        self.sync_file()?;
        if let Some(name) = &self.name {
            self.folder.rename(&name.name, &self.target)?;
        }
        // After the renaming no file has the temporary name, so no file must be removed.
        if let Some(name) = self.name.take() {
            name.remembered.forget();
        }
        self.sync_folder()
    }

    /// Brings the file to the disk, if that is asked for.
    fn sync_file(&self) -> io::Result<()> {
        if self.sync { self.file.sync_all() } else { Ok(()) }
    }

    /// Brings the folder's entry to the disk, if that is asked for.
    fn sync_folder(&self) -> io::Result<()> {
        if !self.sync {
            return Ok(());
        }
        let explain = |error| format!("the new file is there, but a loss of power may bring the old one back: {error}");
        self.folder.sync().map_err(|error| io::Error::new(error.kind(), explain(error)))
    }
}

impl Write for Temporary {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Returns the last part of `path`.
///
/// # Errors
/// An error if that part cannot be the name of a file.
pub fn file_name(path: &Path) -> io::Result<CString> {
    let name = path.file_name().map(OsStrExt::as_bytes).unwrap_or_default();
    // Refuses `folder/` and `folder/.`, because for both `Path::file_name` returns `folder`.
    if name.is_empty() || !path.as_os_str().as_bytes().ends_with(name) {
        return Err(io::Error::new(ErrorKind::InvalidFilename, "it is not the name of a file"));
    }
    Ok(CString::new(name)?)
}

/// Checks that the file `name` can be replaced, and returns its rights. Returns `None` if there is no such file.
fn old_file(folder: &Folder, name: &CStr) -> io::Result<Option<Rights>> {
    let file = match folder.open_for_writing(name) {
        Ok(file) => file,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    };
    if !file.metadata()?.is_file() {
        return Err(io::Error::other("it is no longer a regular file"));
    }
    if folder.is_mount_point(&file)? {
        let text = "a file is mounted here, which cannot be replaced; write to another name and copy it";
        return Err(io::Error::new(ErrorKind::ResourceBusy, text));
    }
    folder.may_replace(name)?;
    Rights::of(&file).map(Some)
}

/// A hidden temporary name in a folder. Its file is removed when this value is dropped, and when a signal ends the
/// process.
#[derive(Debug)]
struct Name {
    name: CString,
    remembered: Remembered,
}

impl Name {
    /// Calls `make` with random names, at most 100, until it succeeds or fails for a reason other than a name in use.
    /// Returns the name, and the result of `make`.
    fn new<T>(folder: &Folder, make: impl Fn(&CStr) -> io::Result<T>) -> io::Result<(Self, T)> {
        const TRIES: u32 = 100;

        let process = std::process::id();
        for _ in 0..TRIES {
            // The name does not contain the target's name, which may already have the largest length. The random number
            // makes the name differ from those of processes on other machines, and from files that a killed process
            // left.
            let random = RandomState::new().hash_one(process);
            let name = CString::new(format!(".render-{process}-{random:016x}.tmp"))?;
            let remembered = Remembered::new(folder.as_fd().as_raw_fd(), &name)?;
            match make(&name) {
                Ok(made) => return Ok((Self { name, remembered }, made)),
                Err(error) => {
                    // No file was created, or the name belongs to a file of another process, which must not be removed.
                    remembered.forget();
                    if error.kind() != ErrorKind::AlreadyExists {
                        return Err(error);
                    }
                }
            }
        }
        Err(io::Error::new(ErrorKind::AlreadyExists, "no temporary name is free beside it; remove .render-*.tmp"))
    }
}
