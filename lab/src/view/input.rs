//! An input file of the page. It is read again and again, while other programs replace it.
//!
//! The page must get the file that the user has named, and nothing else. So links are followed once, when the program
//! starts. Later the program opens the path that they led to, follows no link, and reads only regular files.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use cpu::internals::input::reader::text_of;
use sha2::{Digest, Sha256};

use crate::terminal;

/// Largest size of an input file that the page can edit, in bytes.
pub const MAX_TEXT: u64 = 16 << 20;

/// The version of a file that does not exist, or cannot be read.
pub const MISSING: &str = "missing";

/// An input file.
#[derive(Clone, Debug)]
pub struct Input {
    /// The path that the user has named, for messages.
    named: PathBuf,
    /// The path to which its links led when the program started.
    path: PathBuf,
}

impl Input {
    /// Returns the input file at `named`, whose links are followed now. The file may be missing, but its folder may
    /// not.
    ///
    /// # Errors
    /// A message if there is something else than a regular file that can be read, or no folder.
    pub fn new(named: &Path) -> Result<Self, String> {
        let mut this = Self { named: named.to_owned(), path: named.to_owned() };
        this.path = place(named).map_err(|error| this.message(&error))?;
        match this.open() {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(this.message(&error)),
            _ => Ok(this),
        }
    }

    /// The path to which the links of the file's name led when the program started.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the message for an error of this file.
    pub fn message(&self, error: &io::Error) -> String {
        format!("Cannot read file [{}]: {error}", terminal::name(&self.named))
    }

    /// Opens the file and returns its size. It follows no link, and does not wait for the writer of a pipe.
    ///
    /// # Errors
    /// The error of the system, or another one if the file is not regular or larger than [`MAX_TEXT`].
    pub fn open(&self) -> io::Result<(File, u64)> {
        let file = without_links(&self.path)?;
        let metadata = file.metadata()?;
        if !metadata.is_file() {
            let text = "it is not a regular file, and the page needs one that can be read again";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, text));
        }
        if metadata.len() > MAX_TEXT {
            let text = format!("it is larger than {MAX_TEXT} bytes");
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, text));
        }
        Ok((file, metadata.len()))
    }

    /// Returns the bytes of the file.
    ///
    /// # Errors
    /// Those of [`Input::open`] and [`content`].
    pub fn read(&self) -> io::Result<Vec<u8>> {
        let (file, length) = self.open()?;
        content(file, length)
    }

    /// Returns the text of the file.
    ///
    /// # Errors
    /// Those of [`Input::read`], or [`io::ErrorKind::InvalidData`] if the bytes are not UTF-8.
    pub fn text(&self) -> io::Result<String> {
        text_of(self.read()?)
    }

    /// Returns a text that changes when the content of the file changes. Its time of modification would not do, because
    /// a program may set it.
    pub fn version(&self) -> String {
        let digest = || -> io::Result<String> {
            let (file, length) = self.open()?;
            let (mut file, mut hasher) = (file.take(length), Sha256::new());
            let mut piece = [0; 1 << 16];
            loop {
                match file.read(&mut piece)? {
                    0 => return Ok(format::digest::hexadecimal(&hasher.finalize())),
                    count => hasher.update(&piece[..count]),
                }
            }
        };
        digest().unwrap_or_else(|_| MISSING.to_owned())
    }
}

/// Returns the path to which the links of `named` lead. If there is no such file, the links of its folder are followed.
fn place(named: &Path) -> io::Result<PathBuf> {
    match (named.canonicalize(), named.file_name()) {
        (Err(error), Some(name)) if error.kind() == io::ErrorKind::NotFound => {
            // The parent of a name without a folder is the empty path.
            Ok(Path::new(".").join(named).parent().unwrap_or(named).canonicalize()?.join(name))
        }
        (path, _) => path,
    }
}

/// Returns the bytes of an open file that had `length` bytes.
///
/// # Errors
/// The error of the system. Bytes that were added since are not read.
pub fn content(file: File, length: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(length as usize)?;
    file.take(length).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Returns the version of a file with this content.
pub fn version_of(content: &[u8]) -> String {
    format::digest::sha256(content)
}

/// Opens the file at `path` for reading, if no part of the path is a link. On a system without `openat2`, only the last
/// part is checked.
///
/// # Errors
/// The error of the system.
#[cfg(target_os = "linux")]
pub fn without_links(path: &Path) -> io::Result<File> {
    use nix::errno::Errno;
    use nix::fcntl::{AT_FDCWD, OFlag, OpenHow, ResolveFlag, openat2};

    let flags = OFlag::O_RDONLY | OFlag::O_CLOEXEC | OFlag::O_NONBLOCK;
    match openat2(AT_FDCWD, path, OpenHow::new().flags(flags).resolve(ResolveFlag::RESOLVE_NO_SYMLINKS)) {
        Ok(file) => Ok(file.into()),
        // Linux before 5.6 does not know the call, and some containers forbid it.
        Err(Errno::ENOSYS | Errno::EPERM) => without_last_link(path),
        Err(errno) => Err(errno.into()),
    }
}

#[cfg(not(target_os = "linux"))]
pub use without_last_link as without_links;

/// Opens the file at `path` for reading, if the last part of the path is no link.
///
/// # Errors
/// The error of the system.
pub fn without_last_link(path: &Path) -> io::Result<File> {
    use nix::fcntl::OFlag;
    use std::os::unix::fs::OpenOptionsExt;

    let flags = OFlag::O_NOFOLLOW | OFlag::O_NONBLOCK;
    std::fs::OpenOptions::new().read(true).custom_flags(flags.bits()).open(path)
}

#[cfg(test)]
mod tests;
