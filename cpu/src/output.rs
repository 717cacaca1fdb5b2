//! Writing a file so that it is either the old one or the new one, never a mixture.
//!
//! A regular file is written beside its place under a temporary name and renamed over it. Anything else that can be
//! written to (`/dev/stdout`, `/dev/null`, a pipe) takes the bytes directly.

#[cfg(unix)]
pub mod stop;

use std::collections::hash_map::RandomState;
use std::fs::{self, File, OpenOptions, Permissions};
use std::hash::BuildHasher;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::Error;

/// A place to write to that was found writable when it was opened.
#[derive(Debug)]
pub struct Output {
    /// As the caller named it, for messages.
    named: PathBuf,
    place: Place,
}

#[derive(Debug)]
enum Place {
    /// This process' standard output, under any of its names.
    Stdout,
    /// Something that exists and is no regular file.
    Special,
    /// A regular file, or a name that is free: where links lead to, and what it may be done with once it is there.
    Regular { target: PathBuf, permissions: Option<Permissions> },
}

const STDOUT_NAMES: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

impl Output {
    /// Checks that `path` can be written, and changes nothing: a long rendering should not end in a refusal that could
    /// have come at its start.
    ///
    /// # Errors
    /// [`Error::Write`]: it is a folder, its folder does not exist or takes no file, or it is read-only.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let place = Place::find(path).map_err(|cause| Error::Write { path: path.to_owned(), cause })?;
        Ok(Self { named: path.to_owned(), place })
    }

    /// Replaces the content by what `write` writes.
    ///
    /// # Errors
    /// [`Error::Write`] when `write` or the system fails; a regular file is then as it was.
    pub fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
        let named = self.named;
        let result = match self.place {
            Place::Stdout => write(&mut io::stdout().lock()),
            Place::Special => OpenOptions::new().write(true).open(&named).and_then(|mut file| write(&mut file)),
            Place::Regular { target, permissions } => replace(&target, permissions, write),
        };
        result.map_err(|cause| Error::Write { path: named, cause })
    }
}

impl Place {
    fn find(path: &Path) -> io::Result<Self> {
        if STDOUT_NAMES.iter().any(|name| path == Path::new(name)) {
            return Ok(Self::Stdout);
        }
        let target = match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(metadata) if !metadata.is_file() => return Ok(Self::Special),
            // Through symbolic links: the file that they lead to is replaced, not the link.
            Ok(_) => fs::canonicalize(path)?,
            Err(error) if error.kind() == io::ErrorKind::NotFound => free_name(path)?,
            Err(error) => return Err(error),
        };
        // Opening for writing, without truncating, asks whether the old file may be changed at all.
        let permissions = match OpenOptions::new().write(true).open(&target) {
            Ok(file) => Some(file.metadata()?.permissions()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        drop(Temporary::beside(&target)?);
        Ok(Self::Regular { target, permissions })
    }
}

/// The place that a name which leads to no file stands for: itself, or where a dangling link points.
fn free_name(path: &Path) -> io::Result<PathBuf> {
    let target = match fs::read_link(path) {
        Ok(target) => path.parent().unwrap_or(Path::new("")).join(target),
        Err(_) => path.to_owned(),
    };
    if target.file_name().is_none() || path.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return Err(io::Error::new(io::ErrorKind::InvalidFilename, "it is not the name of a file"));
    }
    Ok(target)
}

/// A new file that is removed when it is dropped, and when the process is asked to stop.
struct Temporary {
    file: File,
    path: PathBuf,
}

impl Temporary {
    /// One in the folder of `target`, hidden, with a name that no other has.
    fn beside(target: &Path) -> io::Result<Self> {
        const TRIES: u32 = 100;

        let process = std::process::id();
        for _ in 0..TRIES {
            // Short and without the target's own name, which may be as long as a name can be. A number from the system
            // sets processes of the same number on other machines apart, and files that a killed one left.
            let random = RandomState::new().hash_one(process);
            let path = target.with_file_name(format!(".render-{process}-{random:016x}.tmp"));
            remember(&path);
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => return Ok(Self { file, path }),
                Err(error) => {
                    forget();
                    if error.kind() != io::ErrorKind::AlreadyExists {
                        return Err(error);
                    }
                }
            }
        }
        Err(io::Error::new(io::ErrorKind::AlreadyExists, "no temporary name is free beside it; remove .render-*.tmp"))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // After a failure that is the one to report; a leftover that cannot be removed either is named by it. After a
        // renaming there is nothing under this name.
        let _ = fs::remove_file(&self.path);
        forget();
    }
}

#[cfg(unix)]
use stop::{forget, remember};

/// Elsewhere nothing but dropping removes a temporary file.
#[cfg(not(unix))]
fn remember(_: &Path) {}
#[cfg(not(unix))]
fn forget() {}

fn replace(
    target: &Path,
    permissions: Option<Permissions>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut temporary = Temporary::beside(target)?;
    write(&mut temporary.file)?;
    if let Some(permissions) = permissions {
        temporary.file.set_permissions(permissions)?;
    }
    fs::rename(&temporary.path, target)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of its own for each test, removed at its end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("render-output-{name}-{}", std::process::id()));
            fs::create_dir_all(&path).expect("the temporary folder is writable");
            Self(path)
        }

        fn names(&self) -> Vec<String> {
            let entries = fs::read_dir(&self.0).expect("the folder exists");
            let mut names: Vec<_> =
                entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
            names.sort();
            names
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn write(path: &Path, text: &str) -> Result<(), Error> {
        Output::open(path)?.write(|out| out.write_all(text.as_bytes()))
    }

    #[test]
    fn a_file_is_made_and_replaced_whole() {
        let folder = Folder::new("replace");
        let path = folder.0.join("out.ppm");
        write(&path, "a longer first text").expect("the folder is writable");
        write(&path, "second").expect("the folder is writable");
        assert_eq!(fs::read_to_string(&path).expect("written"), "second");
        assert_eq!(folder.names(), ["out.ppm"]);
    }

    #[test]
    fn after_a_failure_the_old_file_stands_alone() {
        let folder = Folder::new("failure");
        let path = folder.0.join("out.ppm");
        write(&path, "old").expect("the folder is writable");
        let result = Output::open(&path).expect("the folder is writable").write(|out| {
            out.write_all(b"half of the ne")?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(matches!(result, Err(Error::Write { .. })));
        assert_eq!(fs::read_to_string(&path).expect("still there"), "old");
        assert_eq!(folder.names(), ["out.ppm"]);
    }

    #[test]
    fn opening_changes_nothing() {
        let folder = Folder::new("open");
        let path = folder.0.join("out.ppm");
        Output::open(&path).expect("the folder is writable");
        assert!(folder.names().is_empty());
    }

    #[test]
    fn folders_and_missing_folders_are_refused_at_once() {
        let folder = Folder::new("refused");
        assert!(Output::open(&folder.0).is_err());
        assert!(Output::open(&folder.0.join("missing/out.ppm")).is_err());
        assert!(Output::open(&folder.0.join("out.ppm/")).is_err());
        assert!(Output::open(Path::new("")).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_permissions_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = Folder::new("links");
        let (path, link) = (folder.0.join("out.ppm"), folder.0.join("link.ppm"));
        symlink("out.ppm", &link).expect("links are allowed");
        write(&link, "through a dangling link").expect("the folder is writable");
        fs::set_permissions(&path, Permissions::from_mode(0o640)).expect("it is ours");
        write(&link, "through a link").expect("the folder is writable");
        assert_eq!(fs::read_to_string(&path).expect("written"), "through a link");
        assert!(fs::symlink_metadata(&link).expect("there").is_symlink());
        assert_eq!(fs::metadata(&path).expect("there").permissions().mode() & 0o777, 0o640);
    }

    /// Even root may not write to a program while it runs; renaming over it would go round that.
    #[cfg(target_os = "linux")]
    #[test]
    fn what_may_not_be_written_to_is_not_replaced() {
        let folder = Folder::new("busy");
        let path = folder.0.join("sleep");
        fs::copy("/bin/sleep", &path).expect("the folder is writable");
        let start = || std::process::Command::new(&path).arg("60").spawn();
        // While another test starts a process of its own, that one may hold the copy open for a moment.
        let mut running = (0..100)
            .find_map(|_| {
                std::thread::sleep(std::time::Duration::from_millis(5));
                start().ok()
            })
            .expect("the copy runs");
        let result = Output::open(&path);
        running.kill().expect("it is ours");
        running.wait().expect("it ends");
        let message = result.expect_err("it was running").to_string();
        assert!(message.starts_with(&format!("Cannot write file [{}]: ", path.display())), "{message}");
    }

    /// A pipe with a name, of the test's own: where this module is wrong it renames files over whatever it is given, and
    /// the devices of the machine belong to all.
    #[cfg(unix)]
    #[test]
    fn special_files_take_the_bytes_directly() {
        use std::io::Read;
        use std::os::unix::fs::FileTypeExt;
        let folder = Folder::new("special");
        let path = folder.0.join("pipe");
        let status = std::process::Command::new("mkfifo").arg(&path).status().expect("every Unix has mkfifo");
        assert!(status.success());
        let is_pipe = || fs::symlink_metadata(&path).expect("there").file_type().is_fifo();

        let from = path.clone();
        let reader = std::thread::spawn(move || {
            let mut text = String::new();
            File::open(from).and_then(|mut file| file.read_to_string(&mut text)).map(|_| text)
        });
        write(&path, "through a pipe").expect("somebody reads");
        assert!(is_pipe());
        assert_eq!(reader.join().expect("it reads").expect("it is text"), "through a pipe");

        let from = path.clone();
        let reader = std::thread::spawn(move || File::open(from).map(drop));
        // More than a pipe holds.
        let error = write(&path, &"x".repeat(1 << 20)).expect_err("nobody reads");
        assert!(error.to_string().starts_with(&format!("Cannot write file [{}]: ", path.display())), "{error}");
        reader.join().expect("it ends").expect("the pipe is there");
        assert!(is_pipe());
        assert_eq!(folder.names(), ["pipe"]);
    }
}
