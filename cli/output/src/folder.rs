//! A folder that stays open, and the operations on the files in it.
//!
//! All names are looked up in the open folder. So a file goes into this folder even if the folder is renamed or
//! replaced meanwhile. The standard library has no such functions, but the C library of every Unix has them.

#![allow(unsafe_code)]

mod flags;

use std::ffi::{CStr, CString, c_char, c_int, c_uint};
use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, ErrorKind};
use std::os::fd::{AsFd, AsRawFd, BorrowedFd, FromRawFd};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::{Path, PathBuf};

use flags::{FLAGS, Flags};

// SAFETY: the C library of every Unix has these functions, with these types.
unsafe extern "C" {
    fn openat(folder: c_int, name: *const c_char, flags: c_int, ...) -> c_int;
    fn linkat(old: c_int, from: *const c_char, new: c_int, to: *const c_char, flags: c_int) -> c_int;
    fn renameat(old: c_int, from: *const c_char, new: c_int, to: *const c_char) -> c_int;
    fn unlinkat(folder: c_int, name: *const c_char, flags: c_int) -> c_int;
    fn faccessat(folder: c_int, path: *const c_char, mode: c_int, flags: c_int) -> c_int;
}

/// An open folder.
#[derive(Debug)]
pub struct Folder {
    file: File,
    path: PathBuf,
}

impl Folder {
    /// Opens the folder at `path`. It must be readable only if it will be [synced](Self::sync).
    ///
    /// # Errors
    /// The error of the system.
    pub fn open(path: &Path, sync: bool) -> io::Result<Self> {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        let flags = FLAGS.filter(|_| !sync).map_or(0, |flags| flags.path);
        Ok(Self { file: OpenOptions::new().read(true).custom_flags(flags).open(path)?, path: path.to_owned() })
    }

    /// Creates an empty file without a name in the folder's file system. If it gets no name, it vanishes when it is
    /// closed.
    ///
    /// # Errors
    /// [`ErrorKind::Unsupported`], or the error of the system, since not every file system supports such files.
    pub fn create_unnamed(&self, mode: u32) -> io::Result<File> {
        let flags = FLAGS.ok_or(ErrorKind::Unsupported)?;
        let file = self.open_at(c".", flags.unnamed | flags.close_on_exec, mode)?;
        // `link` names the file through this link in /proc, which is missing if /proc is not mounted.
        let seen = std::fs::metadata(own_link(&file))?;
        if is_same(&seen, &file.metadata()?) { Ok(file) } else { Err(ErrorKind::Unsupported.into()) }
    }

    /// Creates an empty file with a free name.
    ///
    /// # Errors
    /// [`ErrorKind::AlreadyExists`], also for a dangling link, or another error of the system.
    pub fn create(&self, name: &CStr, mode: u32) -> io::Result<File> {
        match FLAGS {
            Some(Flags { write, create, exclusive, close_on_exec, no_follow, .. }) => {
                self.open_at(name, write | create | exclusive | close_on_exec | no_follow, mode)
            }
            None => OpenOptions::new().write(true).create_new(true).mode(mode).open(self.path_of(name)),
        }
    }

    /// Opens an existing file for writing, without changing it. Does not follow a link and does not wait.
    ///
    /// # Errors
    /// The error of the system, which tells why the file may not be written.
    pub fn open_for_writing(&self, name: &CStr) -> io::Result<File> {
        match FLAGS {
            Some(Flags { write, close_on_exec, no_follow, nonblocking, .. }) => {
                self.open_at(name, write | close_on_exec | no_follow | nonblocking, 0)
            }
            None => OpenOptions::new().write(true).open(self.path_of(name)),
        }
    }

    fn open_at(&self, name: &CStr, flags: c_int, mode: u32) -> io::Result<File> {
        // SAFETY: the folder is open and `name` a C string. A result other than an error is a new descriptor, which the
        // `File` owns.
        retry(|| unsafe { openat(self.file.as_raw_fd(), name.as_ptr(), flags, c_uint::from(mode)) })
            .map(|descriptor| unsafe { File::from_raw_fd(descriptor) })
    }

    fn path_of(&self, name: &CStr) -> PathBuf {
        self.path.join(std::ffi::OsStr::from_bytes(name.to_bytes()))
    }

    /// Gives a file from [`Folder::create_unnamed`] a free name.
    ///
    /// # Errors
    /// [`ErrorKind::AlreadyExists`], or another error of the system.
    pub fn link(&self, file: &File, name: &CStr) -> io::Result<()> {
        let flags = FLAGS.ok_or(ErrorKind::Unsupported)?;
        let from = CString::new(own_link(file))?;
        let folder = self.file.as_raw_fd();
        // SAFETY: the folder is open, and both names are C strings. The first is an absolute path, so the system
        // ignores the folder before it.
        retry(|| unsafe { linkat(folder, from.as_ptr(), folder, name.as_ptr(), flags.follow) }).map(drop)
    }

    /// Renames the file `from` to `to`, and so replaces the file that has this name.
    ///
    /// # Errors
    /// The error of the system.
    pub fn rename(&self, from: &CStr, to: &CStr) -> io::Result<()> {
        let folder = self.file.as_raw_fd();
        // SAFETY: the folder is open, and both names are C strings.
        retry(|| unsafe { renameat(folder, from.as_ptr(), folder, to.as_ptr()) }).map(drop)
    }

    /// Checks whether the existing file `name` may be replaced, and changes nothing.
    ///
    /// It asks the system to remove the file as if it were a folder, which always fails. But Linux checks the rights
    /// first, so the error tells whether this process has them. It lacks them in an append-only folder, and in a folder
    /// where users may remove only their own files.
    ///
    /// # Errors
    /// The error that replacing the file would give.
    pub fn may_replace(&self, name: &CStr) -> io::Result<()> {
        let Some(flags) = FLAGS else { return Ok(()) };
        // SAFETY: the folder is open and `name` a C string.
        match retry(|| unsafe { unlinkat(self.file.as_raw_fd(), name.as_ptr(), flags.folder) }) {
            Err(error) if error.kind() == ErrorKind::NotADirectory => Ok(()),
            Err(error) => Err(error),
            Ok(_) => Err(ErrorKind::IsADirectory.into()),
        }
    }

    /// Whether a file system or another file is mounted over `file` of this folder. Then the file cannot be replaced.
    ///
    /// # Errors
    /// The error of the system for the folder or the file.
    pub fn is_mount_point(&self, file: &File) -> io::Result<bool> {
        let other_device = self.file.metadata()?.dev() != file.metadata()?.dev();
        let mounts = [mount_of(&self.file), mount_of(file)];
        Ok(other_device || matches!(mounts, [Some(one), Some(other)] if one != other))
    }

    /// Waits until the names in the folder are on the disk.
    ///
    /// # Errors
    /// The error of the system.
    pub fn sync(&self) -> io::Result<()> {
        self.file.sync_all()
    }
}

impl AsFd for Folder {
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.file.as_fd()
    }
}

/// Removes a file. Returns -1 for an error. A signal handler may call it, since it makes only a system call.
pub fn unlink(folder: c_int, name: &CStr) -> c_int {
    // SAFETY: `name` is a C string. If the descriptor is not open, the call returns an error.
    unsafe { unlinkat(folder, name.as_ptr(), 0) }
}

/// Whether both are the same file.
pub fn is_same(one: &Metadata, other: &Metadata) -> bool {
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

/// Checks whether a file may be opened for writing, without opening it.
///
/// # Errors
/// The error of the system.
pub fn may_write(path: &Path) -> io::Result<()> {
    const WRITE: c_int = 2;
    let Some(flags) = FLAGS else { return Ok(()) };
    let path = CString::new(path.as_os_str().as_bytes())?;
    // SAFETY: `path` is a C string.
    retry(|| unsafe { faccessat(flags.here, path.as_ptr(), WRITE, flags.effective) }).map(drop)
}

/// The link in /proc to an open file.
fn own_link(file: &File) -> String {
    format!("/proc/self/fd/{}", file.as_raw_fd())
}

/// The number of the mount through which an open file was reached; `None` if the system does not tell.
fn mount_of(file: &File) -> Option<String> {
    let text = std::fs::read_to_string(format!("/proc/self/fdinfo/{}", file.as_raw_fd())).ok()?;
    text.lines().find_map(|line| line.strip_prefix("mnt_id:")).map(|number| number.trim().to_owned())
}

/// Repeats a system call as long as signals interrupt it.
fn retry(mut call: impl FnMut() -> c_int) -> io::Result<c_int> {
    loop {
        let result = call();
        if result != -1 {
            return Ok(result);
        }
        let error = io::Error::last_os_error();
        if error.kind() != ErrorKind::Interrupted {
            return Err(error);
        }
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests;
