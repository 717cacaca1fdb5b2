//! A folder that stays open, and the operations on the files in it.
//!
//! All names are looked up in the open folder. So a file goes into this folder even if the folder is renamed or
//! replaced meanwhile. The standard library has no such functions, but the C library of every Unix has them.

#![allow(unsafe_code)]

mod flags;
mod link;

use std::ffi::{CStr, CString, OsStr, c_char, c_int, c_uint};
use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, ErrorKind};
use std::os::fd::{AsFd, AsRawFd, BorrowedFd, FromRawFd};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::{Path, PathBuf};

use flags::{FLAGS, Flags};

// SAFETY: these declarations have the types that the C library of every Unix uses.
unsafe extern "C" {
    fn openat(folder: c_int, name: *const c_char, flags: c_int, ...) -> c_int;
    fn linkat(old: c_int, from: *const c_char, new: c_int, to: *const c_char, flags: c_int) -> c_int;
    fn renameat(old: c_int, from: *const c_char, new: c_int, to: *const c_char) -> c_int;
    fn unlinkat(folder: c_int, name: *const c_char, flags: c_int) -> c_int;
    fn faccessat(folder: c_int, path: *const c_char, mode: c_int, flags: c_int) -> c_int;
}

/// An open folder. A file is named by its name in this folder, without a path.
#[derive(Debug)]
pub struct Folder {
    file: File,
    path: PathBuf,
}

impl Folder {
    /// Opens the folder at `path`. If `sync` is true, [`Self::sync`] may be called later, and the process needs the
    /// right to read the folder.
    ///
    /// # Errors
    /// The error of the system.
    pub fn open(path: &Path, sync: bool) -> io::Result<Self> {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        let flags = FLAGS.filter(|_| !sync).map_or(0, |flags| flags.path);
        Ok(Self { file: OpenOptions::new().read(true).custom_flags(flags).open(path)?, path: path.to_owned() })
    }

    /// Creates an empty file without a name, on the file system of the folder. The file is open for writing. It
    /// vanishes when it is closed, unless [`Folder::link`] has given it a name.
    ///
    /// # Errors
    /// [`ErrorKind::Unsupported`] if this system has no such files or `/proc` is not mounted; otherwise the error of
    /// the system. Many file systems do not support files without a name.
    pub fn create_unnamed(&self, mode: u32) -> io::Result<File> {
        let flags = FLAGS.ok_or(ErrorKind::Unsupported)?;
        let file = self.open_at(c".", flags.unnamed | flags.close_on_exec, mode)?;
        // [`Folder::link`] names the file through this link in /proc, which is missing if /proc is not mounted.
        let seen = std::fs::metadata(own_link(&file))?;
        if is_same(&seen, &file.metadata()?) { Ok(file) } else { Err(ErrorKind::Unsupported.into()) }
    }

    /// Creates the empty file `name` and opens it for writing.
    ///
    /// # Errors
    /// [`ErrorKind::AlreadyExists`] if a file or a link, even a dangling one, has this name; otherwise the error of the
    /// system.
    pub fn create(&self, name: &CStr, mode: u32) -> io::Result<File> {
        match FLAGS {
            Some(Flags { write, create, exclusive, close_on_exec, no_follow, .. }) => {
                self.open_at(name, write | create | exclusive | close_on_exec | no_follow, mode)
            }
            None => OpenOptions::new().write(true).create_new(true).mode(mode).open(self.path_of(name)),
        }
    }

    /// Opens the existing file `name` for writing, without changing it. It follows no link, and does not wait for the
    /// reader of a pipe.
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

    /// Opens or makes the file `name` of the folder.
    fn open_at(&self, name: &CStr, flags: c_int, mode: u32) -> io::Result<File> {
        // SAFETY: the folder is open and `name` a C string. If the call succeeds, its result is a new descriptor, which
        // the `File` owns.
        retry(|| unsafe { openat(self.file.as_raw_fd(), name.as_ptr(), flags, c_uint::from(mode)) })
            .map(|descriptor| unsafe { File::from_raw_fd(descriptor) })
    }

    /// Returns the path of the file `name` of the folder.
    fn path_of(&self, name: &CStr) -> PathBuf {
        self.path.join(OsStr::from_bytes(name.to_bytes()))
    }

    /// Gives the name `name` to `file`, which must come from [`Folder::create_unnamed`].
    ///
    /// # Errors
    /// [`ErrorKind::AlreadyExists`] if a file has this name; otherwise the error of the system.
    pub fn link(&self, file: &File, name: &CStr) -> io::Result<()> {
        let flags = FLAGS.ok_or(ErrorKind::Unsupported)?;
        let from = CString::new(own_link(file))?;
        let folder = self.file.as_raw_fd();
        // SAFETY: the folder is open, and both names are C strings. The first is an absolute path, so the system
        // ignores the folder before it.
        retry(|| unsafe { linkat(folder, from.as_ptr(), folder, name.as_ptr(), flags.follow) }).map(drop)
    }

    /// Renames the file `from` to `to`. If a file `to` exists, the renamed file replaces it.
    ///
    /// # Errors
    /// The error of the system.
    pub fn rename(&self, from: &CStr, to: &CStr) -> io::Result<()> {
        let folder = self.file.as_raw_fd();
        // SAFETY: the folder is open, and both names are C strings.
        retry(|| unsafe { renameat(folder, from.as_ptr(), folder, to.as_ptr()) }).map(drop)
    }

    /// Returns `Ok` if the existing file `name` may be replaced. It changes nothing.
    ///
    /// This function asks the system to remove the file as a folder. The call always fails, but Linux checks the rights
    /// first, so its error tells whether this process has them. A process lacks them in an append-only folder, and in a
    /// folder where users may remove only their own files.
    ///
    /// # Errors
    /// The error that the system would return for replacing the file.
    pub fn may_replace(&self, name: &CStr) -> io::Result<()> {
        let Some(flags) = FLAGS else { return Ok(()) };
        // SAFETY: the folder is open and `name` a C string.
        match retry(|| unsafe { unlinkat(self.file.as_raw_fd(), name.as_ptr(), flags.folder) }) {
            Err(error) if error.kind() == ErrorKind::NotADirectory => Ok(()),
            Err(error) => Err(error),
            Ok(_) => Err(ErrorKind::IsADirectory.into()),
        }
    }

    /// Whether a file system or another file is mounted over `file`, a file in this folder. Such a file cannot be
    /// replaced.
    ///
    /// # Errors
    /// The error of the system, if the metadata of the folder or the file cannot be read.
    pub fn is_mount_point(&self, file: &File) -> io::Result<bool> {
        let other_device = self.file.metadata()?.dev() != file.metadata()?.dev();
        let mounts = [mount_of(&self.file), mount_of(file)];
        Ok(other_device || matches!(mounts, [Some(one), Some(other)] if one != other))
    }

    /// Waits until all changes of names in the folder are on the disk.
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

/// Removes the file `name` of an open folder. Returns 0, or -1 for an error. A signal handler may call this function,
/// because it only makes a system call.
pub fn unlink(folder: c_int, name: &CStr) -> c_int {
    // SAFETY: `name` is a C string. If the descriptor is not open, the call returns an error.
    unsafe { unlinkat(folder, name.as_ptr(), 0) }
}

/// Whether `one` and `other` are the metadata of the same file.
pub fn is_same(one: &Metadata, other: &Metadata) -> bool {
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

/// Checks whether this process may open the file at `path` for writing, without opening it.
///
/// # Errors
/// The error of the system that explains why the file cannot be written.
pub fn may_write(path: &Path) -> io::Result<()> {
    const WRITE: c_int = 2;
    let Some(flags) = FLAGS else { return Ok(()) };
    let path = CString::new(path.as_os_str().as_bytes())?;
    // SAFETY: `path` is a C string.
    retry(|| unsafe { faccessat(flags.here, path.as_ptr(), WRITE, flags.effective) }).map(drop)
}

/// Returns the path of the link in /proc that leads to an open file.
fn own_link(file: &File) -> String {
    format!("/proc/self/fd/{}", file.as_raw_fd())
}

/// Returns the number of the mount through which `file` was opened, or `None` if the system does not tell it.
fn mount_of(file: &File) -> Option<String> {
    let text = std::fs::read_to_string(format!("/proc/self/fdinfo/{}", file.as_raw_fd())).ok()?;
    text.lines().find_map(|line| line.strip_prefix("mnt_id:")).map(|number| number.trim().to_owned())
}

/// Repeats the system call `call` until no signal interrupts it. Returns its result, or the error of the system if the
/// result is -1.
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
