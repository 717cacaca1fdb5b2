//! A temporary file that becomes the new file when it is complete, and is removed if it does not become complete.

use std::ffi::{CStr, CString, OsStr};
use std::fs::{File, Metadata, Permissions};
use std::io::{self, ErrorKind};
use std::os::fd::AsRawFd;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
use std::path::Path;

use rustix::fs::{AtFlags, CWD, Mode, OFlags, fgetxattr, fremovexattr, linkat, openat, renameat};
use rustix::io::Errno;

use crate::links::{error, is_shared, parent};
use crate::stop::Name;

/// A file that is being written. [`Temporary::commit`] gives it the name `target` in an open folder. So the file goes
/// into this folder even if the folder is renamed meanwhile.
///
/// If the file system supports it, the file has no name until it is complete. Then no file is left, however the process
/// ends before. Otherwise the file has a hidden temporary name. It is removed when this value is dropped or when a
/// signal ends the process.
#[derive(Debug)]
pub struct Temporary {
    name: Option<&'static Name>,
    folder: File,
    target: CString,
    /// The file that will be replaced, and the permissions that the new file may get from it.
    old: Option<(Metadata, u32)>,
    sync: bool,
}

/// The permissions of a file's owner.
const OWNER: u32 = 0o700;

const ACCESS_LIST: &str = "system.posix_acl_access";

/// The errors that tell that a file has no access list, or that its file system has none at all.
const NO_LIST: [Errno; 3] = [Errno::NODATA, Errno::NOTSUP, Errno::NOSYS];

impl Temporary {
    /// Checks that `target`, which is no link, may be created or replaced, and creates the temporary file. Returns it
    /// open for writing.
    ///
    /// # Errors
    /// The reason why `target` cannot be written, as far as it is known before writing.
    pub fn new(target: &Path, sync: bool) -> io::Result<(File, Self)> {
        // Syncing a folder needs the right to read it.
        let access = if sync { OFlags::RDONLY } else { OFlags::PATH };
        let folder = openat(CWD, parent(target), access | OFlags::DIRECTORY | OFlags::CLOEXEC, Mode::empty())?;
        let (folder, name) = (File::from(folder), target.file_name().map(OsStr::as_bytes).unwrap_or_default());
        let target = CString::new(name)?;
        let old = old_file(&folder, &target)?;
        // Until a file that replaces another one is complete, only its owner may open it.
        let mode = Mode::from_raw_mode(if old.is_some() { 0o600 } else { 0o666 });
        let create = |name: &CStr, flags| openat(&folder, name, flags | OFlags::WRONLY | OFlags::CLOEXEC, mode);
        // A file without a name gets its name through /proc.
        let unnamed = create(c".", OFlags::TMPFILE).ok().filter(|file| Path::new(&own_link(file)).exists());
        let (name, file) = match unnamed {
            Some(file) => (None, file),
            None => Name::new(&folder, |name| create(name, OFlags::CREATE | OFlags::EXCL))?,
        };
        let file = File::from(file);
        let this = Self { name, folder, target, old, sync };
        let (own, folder) = (file.metadata()?.uid(), this.folder.metadata()?);
        let may_replace = |old: &Metadata| [0, old.uid(), folder.uid()].contains(&own) || !is_shared(&folder);
        if !this.old.as_ref().is_none_or(|(old, _)| may_replace(old)) {
            let text = "it is another user's file in a folder of all users, such as /tmp; choose another name";
            return error(ErrorKind::PermissionDenied, text);
        }
        Ok((file, this))
    }

    /// Gives the complete file `file` its final name, which replaces the old file.
    ///
    /// # Errors
    /// The error of the system. The old file is then unchanged, with one exception that the message names: the new file
    /// has its name, but its folder could not be synced.
    pub fn commit(mut self, file: &File) -> io::Result<()> {
        if let Some((old, mode)) = &self.old {
            give_rights(file, old, *mode)?;
        }
        let sync = |file: &File| if self.sync { file.sync_all() } else { Ok(()) };
        sync(file)?;
        let link = |name: &CStr| linkat(CWD, own_link(file), &self.folder, name, AtFlags::SYMLINK_FOLLOW);
        if self.name.is_none() {
            self.name = Name::new(&self.folder, link)?.0;
        }
        if let Some(name) = self.name {
            renameat(&self.folder, &name.name, &self.folder, &self.target)?;
            name.forget();
        }
        let explain = |error| format!("the new file is there, but a loss of power may bring the old one back: {error}");
        sync(&self.folder).map_err(|error| io::Error::new(error.kind(), explain(error)))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        self.name.inspect(|name| name.remove());
    }
}

/// Returns the file `name` in `folder`, and the permissions that the file which replaces it may get. Returns `None` if
/// there is no such file. If the file has an access list, the permissions are the owner's alone, because the other bits
/// then are the list's limit.
///
/// # Errors
/// The error of the system, which tells why the file may not be written.
fn old_file(folder: &File, name: &CStr) -> io::Result<Option<(Metadata, u32)>> {
    let flags = OFlags::WRONLY | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC;
    let file = match openat(folder, name, flags, Mode::empty()) {
        Err(Errno::NOENT) => return Ok(None),
        file => File::from(file?),
    };
    let metadata = file.metadata()?;
    let is_plain = fgetxattr(&file, ACCESS_LIST, &mut [0_u8; 0][..]).is_err_and(|error| NO_LIST.contains(&error));
    let mode = metadata.mode() & if is_plain { 0o7777 } else { OWNER };
    Ok(Some((metadata, mode)))
}

/// Gives the new file `file` the owner, the group and the permissions `mode` of the old file, as far as this process
/// may do so. Only the user who writes may get more rights than before, as the owner of the new file.
///
/// # Errors
/// The error of the system, if the owner of `file` cannot be read.
fn give_rights(file: &File, old: &Metadata, mode: u32) -> io::Result<()> {
    let is_kept = || file.metadata().map(|new| (new.uid(), new.gid()) == (old.uid(), old.gid()));
    if !is_kept()? {
        // Root may change the owner. Other users may change only the group, to one that they belong to. If both calls
        // fail, the new file keeps its owner and group.
        let _ = fchown(file, Some(old.uid()), Some(old.gid())).or_else(|_| fchown(file, None, Some(old.gid())));
    }
    // With another owner or group, the new owner gets the permissions of the old one, and other users get only what
    // owner, group and others had. The set-user-ID and set-group-ID bits go.
    let common = mode & mode >> 3 & mode >> 6 & 0o7;
    let mode = if is_kept()? { mode } else { mode & OWNER | common << 3 | common };
    // The folder may have given the new file an access list, which the old file did not have.
    let is_plain = fremovexattr(file, ACCESS_LIST).map_or_else(|error| NO_LIST.contains(&error), |()| true);
    // An error is ignored, since a file with fewer permissions is better than none.
    let _ = file.set_permissions(Permissions::from_mode(if is_plain { mode } else { mode & OWNER }));
    Ok(())
}

/// Returns the path of the link in /proc that leads to an open file.
fn own_link(file: &impl AsRawFd) -> String {
    format!("/proc/self/fd/{}", file.as_raw_fd())
}
