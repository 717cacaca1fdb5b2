//! The access list of a file: rights of single users and groups, beyond those of owner, group and all others.
//!
//! Linux keeps the list as an attribute of the file. A file without that attribute has only its permission bits. If it
//! has the attribute, the bits of the group are the limit of all entries, and not the rights of the group. On other
//! systems these functions find no list and change none.

#![allow(unsafe_code)]

#[cfg(target_os = "linux")]
pub use linux::{of, remove, set};

#[cfg(target_os = "linux")]
mod linux {
    use std::ffi::{CStr, c_char, c_int, c_void};
    use std::fs::File;
    use std::io::{self, ErrorKind};
    use std::os::fd::AsRawFd;

    // SAFETY: these declarations have the types of Linux's C libraries.
    unsafe extern "C" {
        fn fgetxattr(file: c_int, name: *const c_char, value: *mut c_void, size: usize) -> isize;
        fn fsetxattr(file: c_int, name: *const c_char, value: *const c_void, size: usize, flags: c_int) -> c_int;
        fn fremovexattr(file: c_int, name: *const c_char) -> c_int;
    }

    const NAME: &CStr = c"system.posix_acl_access";

    /// Largest size in bytes of an attribute on Linux.
    const MAX_SIZE: usize = 1 << 16;

    /// The error code `ENODATA`: the file lacks the attribute.
    const NO_DATA: i32 = 61;

    /// Returns the access list of `file`, or `None` if it has none.
    ///
    /// # Errors
    /// The error of the system.
    pub fn of(file: &File) -> io::Result<Option<Vec<u8>>> {
        let mut list = vec![0_u8; MAX_SIZE];
        // SAFETY: the file is open, the name is a C string, and the list has the given size.
        let size = unsafe { fgetxattr(file.as_raw_fd(), NAME.as_ptr(), list.as_mut_ptr().cast(), list.len()) };
        match usize::try_from(size) {
            Ok(size) => {
                list.truncate(size);
                Ok(Some(list))
            }
            Err(_) => none_is_no_error(None),
        }
    }

    /// Gives `file` the access list `list`, which [`of`] returned for another file.
    ///
    /// # Errors
    /// The error of the system.
    pub fn set(file: &File, list: &[u8]) -> io::Result<()> {
        // SAFETY: the file is open, the name is a C string, and the list has the given size.
        let result = unsafe { fsetxattr(file.as_raw_fd(), NAME.as_ptr(), list.as_ptr().cast(), list.len(), 0) };
        if result == 0 { Ok(()) } else { Err(io::Error::last_os_error()) }
    }

    /// Removes the access list of `file`, if it has one.
    ///
    /// # Errors
    /// The error of the system.
    pub fn remove(file: &File) -> io::Result<()> {
        // SAFETY: the file is open and the name is a C string.
        let result = unsafe { fremovexattr(file.as_raw_fd(), NAME.as_ptr()) };
        if result == 0 { Ok(()) } else { none_is_no_error(()) }
    }

    /// Returns `value` if the last system call failed because there is no access list, or because the file system has
    /// none at all. Returns any other error of that call.
    fn none_is_no_error<T>(value: T) -> io::Result<T> {
        let error = io::Error::last_os_error();
        let is_none = error.raw_os_error() == Some(NO_DATA) || error.kind() == ErrorKind::Unsupported;
        if is_none { Ok(value) } else { Err(error) }
    }
}

#[cfg(not(target_os = "linux"))]
mod elsewhere {
    use std::fs::File;
    use std::io;

    pub fn of(_: &File) -> io::Result<Option<Vec<u8>>> {
        Ok(None)
    }

    pub fn set(_: &File, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    pub fn remove(_: &File) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(not(target_os = "linux"))]
pub use elsewhere::{of, remove, set};
