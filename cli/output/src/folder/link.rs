//! Reads the links of a folder, but not those by which another user could choose the output of this process.

use std::ffi::{CStr, OsString, c_char, c_int, c_uint};
use std::fs::File;
use std::io::{self, ErrorKind};
use std::os::fd::AsRawFd;
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;

use super::{FLAGS, Folder};

// SAFETY: these declarations have the types that the C library of every Unix uses. `geteuid` always succeeds.
unsafe extern "C" {
    fn readlinkat(folder: c_int, name: *const c_char, buffer: *mut c_char, size: usize) -> isize;
    safe fn geteuid() -> c_uint;
}

/// Permission bits of a folder in which all users may create files, and remove only their own, such as `/tmp`.
const STICKY_FOR_ALL: u32 = 0o1002;

/// Length in bytes that the path in a link has at most; Linux has the same limit.
const MAX_PATH: usize = 4096;

impl Folder {
    /// Returns the path that the link `name` contains, or `None` if `name` cannot be read as a link.
    ///
    /// In a sticky folder of all users, a link of another user is refused, unless that user owns the folder. Linux has
    /// the same rule for links that it follows itself, and this process must apply the rule to links that it reads. The
    /// owner and the path come from one open link. So they belong together even if another user exchanges files
    /// meanwhile.
    ///
    /// # Errors
    /// [`ErrorKind::PermissionDenied`] if the link may not be followed, or the error of the system.
    pub fn read_link(&self, name: &CStr) -> io::Result<Option<OsString>> {
        let (path, metadata) = match FLAGS {
            Some(flags) => {
                let opened = self.open_at(name, flags.path | flags.no_follow | flags.close_on_exec, 0);
                let Ok(link) = opened else { return Ok(None) };
                (path_in(&link), link.metadata())
            }
            None => {
                let link = self.path_of(name);
                (std::fs::read_link(&link).ok().map(PathBuf::into_os_string), link.symlink_metadata())
            }
        };
        let Some(path) = path else { return Ok(None) };
        let (folder, owner) = (self.file.metadata()?, metadata?.uid());
        let is_shared = folder.mode() & STICKY_FOR_ALL == STICKY_FOR_ALL;
        if is_shared && owner != geteuid() && owner != folder.uid() {
            let text = "it leads through another user's link in a folder of all users; choose another folder";
            return Err(io::Error::new(ErrorKind::PermissionDenied, text));
        }
        Ok(Some(path))
    }
}

/// Returns the path that the open link `link` contains, or `None` if `link` is not a link.
fn path_in(link: &File) -> Option<OsString> {
    let mut buffer = vec![0_u8; MAX_PATH];
    // SAFETY: the descriptor is open, the empty name is a C string, and the buffer has the given size.
    let length = unsafe { readlinkat(link.as_raw_fd(), c"".as_ptr(), buffer.as_mut_ptr().cast(), buffer.len()) };
    buffer.truncate(usize::try_from(length).ok()?);
    Some(OsString::from_vec(buffer))
}
