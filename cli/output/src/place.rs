//! Finds out whether the path of an output is a regular file, a device or a pipe, and opens it.

use std::fs::{self, File, FileType, OpenOptions};
use std::io::{self, ErrorKind};
use std::os::unix::fs::FileTypeExt;
use std::path::{Path, PathBuf};

use crate::folder::{Folder, is_same, may_write};
use crate::stdout;
use crate::temporary::{Temporary, file_name};

/// The target of an output. [`Place::find`] has checked that it can be written, as far as that is known before.
#[derive(Debug)]
pub enum Place {
    /// Standard output or a device, to which the bytes are written directly.
    Direct(File),
    /// A named pipe. It is opened at the first write, because opening it waits for a reader.
    Pipe(PathBuf),
    /// A temporary file that will become a new regular file, or replace an old one.
    Regular(Temporary),
}

const STDOUT_NAMES: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// Largest number of links that [`follow`] follows; Linux has the same limit.
const MAX_LINKS: u32 = 40;

impl Place {
    /// Follows the links of `path`, checks that the target can be written, and opens it. A named pipe is not opened
    /// yet. If `sync` is true, the commit of a regular file waits until the file is on the disk.
    ///
    /// # Errors
    /// The reason why the target cannot be written, as far as it is known before writing.
    pub fn find(path: &Path, sync: bool) -> io::Result<Self> {
        if is_stdout(path) {
            return stdout::open().map(Self::Direct);
        }
        // `fs::metadata` follows the links before `follow` does, because Linux may forbid to follow links of other
        // users.
        let metadata = match fs::metadata(path) {
            Ok(metadata) => Some(metadata),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let target = follow(path)?;
        if is_stdout(&target) {
            return stdout::open().map(Self::Direct);
        }
        if let Some(kind) = metadata.as_ref().map(fs::Metadata::file_type).filter(|kind| !kind.is_file()) {
            return special(path, kind);
        }
        if metadata.is_some() && !has_name(path, &target)? {
            return Err(io::Error::new(ErrorKind::NotFound, "it is an open file that has lost its name"));
        }
        Temporary::new(&target, sync).map(Self::Regular)
    }
}

/// Whether the path is a name of standard output.
fn is_stdout(path: &Path) -> bool {
    STDOUT_NAMES.iter().any(|name| path == Path::new(name))
}

/// Follows all links from `path`. Returns the path of a file that is no link, a path at which no file exists, or the
/// first of the names of standard output.
///
/// # Errors
/// An error if there are too many links, or if a link belongs to another user and may not be followed
/// ([`Folder::read_link`]). Any other error is found when the file is created, so it is ignored here.
pub fn follow(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MAX_LINKS {
        if is_stdout(&target) {
            return Ok(STDOUT_NAMES[0].into());
        }
        let Ok(name) = file_name(&target) else { return Ok(target) };
        let parent = target.parent().unwrap_or(Path::new(""));
        let Ok(folder) = Folder::open(parent, false) else { return Ok(target) };
        match folder.read_link(&name)? {
            Some(next) => target = parent.join(next),
            None => return Ok(target),
        }
    }
    Err(io::Error::other("too many links lead on from it"))
}

/// Whether `target`, to which the links of `path` lead, is the name of the file at `path`. It is not if `path` leads to
/// an open file that was removed.
///
/// Another program may replace the file between the two calls. So the calls are repeated if they find different files.
///
/// # Errors
/// The error of the system if it does not tell which file is at `path`, for example because the process may not follow
/// a link.
fn has_name(path: &Path, target: &Path) -> io::Result<bool> {
    const TRIES: u32 = 20;
    if path == target {
        return Ok(true);
    }
    for _ in 0..TRIES {
        match (fs::metadata(path), fs::symlink_metadata(target)) {
            (Ok(file), Ok(named)) if is_same(&file, &named) => return Ok(true),
            // The file was removed meanwhile. A new one can be created.
            (Err(error), _) if error.kind() == ErrorKind::NotFound => return Ok(true),
            (Err(error), _) => return Err(error),
            (Ok(_), _) => {}
        }
    }
    Ok(false)
}

/// Returns the place for a file that is not regular, such as a device: it is written where it is.
fn special(path: &Path, kind: FileType) -> io::Result<Place> {
    if kind.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if kind.is_socket() {
        return Err(io::Error::new(ErrorKind::InvalidInput, "it is a socket"));
    }
    if kind.is_fifo() {
        return may_write(path).map(|()| Place::Pipe(path.to_owned()));
    }
    let file = OpenOptions::new().write(true).open(path)?;
    if file.metadata()?.is_file() {
        return Err(io::Error::other("it was a device, and is a file now"));
    }
    Ok(Place::Direct(file))
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn only_a_missing_file_counts_as_removed() {
        let folder = Folder::new();
        let (file, missing) = (folder.write("file", ""), folder.file("missing"));
        let [link, endless] = ["link", "endless"].map(|name| folder.file(name));
        std::os::unix::fs::symlink("file", &link).expect("links are allowed");
        std::os::unix::fs::symlink("endless", &endless).expect("links are allowed");
        let found = [
            has_name(&link, &file).ok(),
            has_name(&link, &missing).ok(),
            has_name(&missing, &file).ok(),
            // The system refuses to follow this link, as it refuses a forbidden one.
            has_name(&endless, &file).ok(),
        ];
        assert_eq!(found, [Some(true), Some(false), Some(true), None]);
    }
}
