//! A new file that takes the place of an old one when it is complete, and leaves nothing where it is not.

use std::ffi::{CStr, CString};
use std::fs::{File, Permissions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, Write};
use std::os::fd::{AsFd, AsRawFd};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
use std::path::Path;

use crate::output::folder::Folder;
use crate::output::stop::Remembered;

/// Reading and writing for the owner, nothing for all others.
const PRIVATE: u32 = 0o600;
/// Reading and writing for all, less what the process' mask takes away.
const COMMON: u32 = 0o666;
/// The bits that run a program with its owner's and its group's rights.
const SET_USER: u32 = 0o4000;
const SET_GROUP: u32 = 0o2000;

/// Whose a file is, and who may do what with it.
#[derive(Clone, Copy, Debug)]
struct Rights {
    user: u32,
    group: u32,
    mode: u32,
}

impl Rights {
    fn of(file: &File) -> io::Result<Self> {
        let metadata = file.metadata()?;
        Ok(Self { user: metadata.uid(), group: metadata.gid(), mode: metadata.mode() })
    }

    /// The permissions as far as they mean the same for a file of another owner or group.
    fn mode_for(self, new: Self) -> u32 {
        let mut mode = self.mode & 0o7777;
        if new.user != self.user {
            mode &= !SET_USER;
        }
        if new.group != self.group {
            // Another group may do what all may do.
            mode &= !SET_GROUP & (!0o070 | (mode & 0o007) << 3);
        }
        mode
    }
}

/// A file that is being written, for a place in an open folder.
///
/// Where the file system allows it, the file has no name until it is complete. Then whatever ends the process leaves
/// nothing. Elsewhere the file has a hidden name of its own, which is removed when this is dropped or when a signal
/// ends the process.
#[derive(Debug)]
pub struct Temporary {
    // Before the folder: the name is removed while the folder is open.
    name: Option<Name>,
    file: File,
    folder: Folder,
    target: CString,
    /// The file that is replaced, if there is one.
    old: Option<Rights>,
    /// The permissions that a new file gets, where they are not there yet.
    mode: Option<u32>,
    sync: bool,
}

impl Temporary {
    /// Checks that `target`, which is no link, may be written or replaced, and makes the file that will replace it.
    ///
    /// # Errors
    /// Whatever the system is known to refuse.
    pub fn new(target: &Path, sync: bool) -> io::Result<Self> {
        Self::with(target, sync, Folder::create_unnamed)
    }

    /// The same where the file system makes no files without a name.
    #[cfg(test)]
    pub fn named(target: &Path, sync: bool) -> io::Result<Self> {
        Self::with(target, sync, |_, _| Err(ErrorKind::Unsupported.into()))
    }

    /// The same with a way to make files without a name, which may fail.
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
            this.mode = Some(Rights::of(&this.file)?.mode);
            // Where there are no permissions to set, as on a stick for a camera, there is nothing to keep back.
            let _ = this.file.set_permissions(Permissions::from_mode(PRIVATE));
        }
        Ok(this)
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// What the system says. Then the old file is as it was, but for a last step: where the folder cannot be synced,
    /// the new file has its place already, and the message says so.
    pub fn commit(mut self) -> io::Result<()> {
        if let Some(mode) = self.mode_at_last()? {
            // Fewer permissions than wanted are no reason to lose what was written.
            let _ = self.file.set_permissions(Permissions::from_mode(mode));
        }
        if self.name.is_none() && self.old.is_none() {
            self.sync_file()?;
            match self.folder.link(&self.file, &self.target) {
                // Another process has made it meanwhile: it is replaced like any old file, if that is allowed.
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
        // Under this name is nothing any more.
        if let Some(name) = self.name.take() {
            name.remembered.forget();
        }
        self.sync_folder()
    }

    /// Gives the new file the owner of the old one, where this process may, and returns the permissions that the new
    /// file must get when it is complete. `None` if it has them already.
    ///
    /// # Errors
    /// The system's, where the rights of the new file cannot be read.
    fn mode_at_last(&self) -> io::Result<Option<u32>> {
        let Some(old) = self.old else { return Ok(self.mode) };
        let mut new = Rights::of(&self.file)?;
        if (new.user, new.group) != (old.user, old.group) {
            // Root may change the owner; others may change only the group, to one of their own. Where neither is
            // allowed, the new file keeps the user of this process.
            let _ = fchown(&self.file, Some(old.user), Some(old.group))
                .or_else(|_| fchown(&self.file, None, Some(old.group)));
            new = Rights::of(&self.file)?;
        }
        Ok(Some(old.mode_for(new)))
    }

    fn sync_file(&self) -> io::Result<()> {
        if self.sync { self.file.sync_all() } else { Ok(()) }
    }

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

/// The last part of a path, where it is a file's.
fn file_name(path: &Path) -> io::Result<CString> {
    let name = path.file_name().map(OsStrExt::as_bytes).unwrap_or_default();
    // Not so for `folder/` and `folder/.`.
    if name.is_empty() || !path.as_os_str().as_bytes().ends_with(name) {
        return Err(io::Error::new(ErrorKind::InvalidFilename, "it is not the name of a file"));
    }
    Ok(CString::new(name)?)
}

/// The file that has the name, after every check that replacing it may fail.
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

/// A hidden name in a folder. It is removed when this is dropped, and when a signal ends the process.
#[derive(Debug)]
struct Name {
    name: CString,
    remembered: Remembered,
}

impl Name {
    /// A name that is free, and what `make` makes of it.
    fn new<T>(folder: &Folder, make: impl Fn(&CStr) -> io::Result<T>) -> io::Result<(Self, T)> {
        const TRIES: u32 = 100;

        let process = std::process::id();
        for _ in 0..TRIES {
            // Short and without the target's own name, which may be as long as a name can be. The random number makes
            // it differ from the names of processes on other machines, and from files that a killed process left.
            let random = RandomState::new().hash_one(process);
            let name = CString::new(format!(".render-{process}-{random:016x}.tmp"))?;
            let remembered = Remembered::new(folder.as_fd().as_raw_fd(), &name)?;
            match make(&name) {
                Ok(made) => return Ok((Self { name, remembered }, made)),
                Err(error) => {
                    // Nothing was made, or the name is another's.
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

#[cfg(test)]
mod tests;
