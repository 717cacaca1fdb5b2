//! Replaces a file only if it still has the content that was read, so that no edit of another program is lost.
//!
//! A check before a renaming is not enough, because another program may save between the two. So the new file is
//! written under another name, and the two files exchange their names, which is one step for the system. If the file
//! that came out is not the one that was read, the names are exchanged back.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use output::{Options, Output};

use crate::terminal;

/// Replaces the content `old` of the regular file at `path` by `new`. `read` returns the present content. `how` tells
/// how the file is written. Returns false if the file has another content now.
///
/// Where the system cannot exchange names, the content is only compared directly before the renaming.
///
/// # Errors
/// The new file could not be written. The file then has a content that another program or the user has written. If only
/// the folder could not be synced, the file has the new content.
pub fn replace(
    path: &Path,
    (old, new): (&[u8], &[u8]),
    read: impl Fn(&Path) -> io::Result<Vec<u8>>,
    how: Options,
) -> Result<bool, output::Error> {
    let is_old = |path: &Path| read(path).is_ok_and(|content| content == old);
    // A pipe would block when it is opened for writing, and a device would take the bytes.
    if !fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_file()) || !is_old(path) {
        return Ok(false);
    }
    let write = |path: &Path| {
        let mut output = Output::open(path, how)?;
        output.write_all(new).map_err(|cause| output::Error { path: path.to_owned(), cause })?;
        Ok::<_, output::Error>(output)
    };
    let Some(beside) = Beside::new(path) else {
        let output = write(path)?;
        return if is_old(path) { output.commit().map(|()| true) } else { Ok(false) };
    };
    // The name beside the file is a link to the file itself, so the new file gets the rights of the old one.
    write(&beside.0)?.commit()?;
    exchange(&beside.0, path).map_err(|cause| output::Error { path: path.to_owned(), cause })?;
    if is_old(&beside.0) {
        drop(beside);
        return if how.sync { sync_folder(path).map(|()| true) } else { Ok(true) };
    }
    // The exchanged file was edited, so it gets its name back. The hidden name must then hold the new file. Otherwise
    // the hidden file is kept.
    if exchange(&beside.0, path).is_ok() && read(&beside.0).is_ok_and(|content| content == new) {
        return Ok(false);
    }
    let text = format!("it has changed meanwhile; a change is in [{}]", terminal::name(&beside.keep()));
    Err(output::Error { path: path.to_owned(), cause: io::Error::other(text) })
}

/// Waits until the names in the folder of the file at `path` are on the disk.
fn sync_folder(path: &Path) -> Result<(), output::Error> {
    let synced = fs::File::open(path.parent().unwrap_or(Path::new("."))).and_then(|folder| folder.sync_all());
    synced.map_err(|error| {
        let text = format!("the new file is there, but a loss of power may bring the old one back: {error}");
        output::Error { path: path.to_owned(), cause: io::Error::new(error.kind(), text) }
    })
}

/// A hidden name beside a file. It is removed when this value is dropped.
struct Beside(PathBuf);

impl Beside {
    /// Links the file at `path` under a hidden name in its folder. Returns `None` if the system cannot do that, or
    /// cannot exchange names there.
    fn new(path: &Path) -> Option<Self> {
        let mut number = [0; 8];
        getrandom::fill(&mut number).ok()?;
        let beside = Self(path.with_file_name(format!(".render-{:016x}.old", u64::from_ne_bytes(number))));
        fs::hard_link(path, &beside.0).ok()?;
        // Exchanging two names of one file changes nothing.
        let is_file = fs::symlink_metadata(&beside.0).is_ok_and(|metadata| metadata.is_file());
        (is_file && exchange(&beside.0, path).is_ok()).then_some(beside)
    }

    /// Returns the name, whose file stays.
    fn keep(mut self) -> PathBuf {
        std::mem::take(&mut self.0)
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

/// Exchanges the names of two files in one step.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    use nix::fcntl::{AT_FDCWD, RenameFlags, renameat2};
    Ok(renameat2(AT_FDCWD, one, AT_FDCWD, other, RenameFlags::RENAME_EXCHANGE)?)
}

#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

#[cfg(all(test, target_os = "linux", target_env = "gnu"))]
mod tests;
