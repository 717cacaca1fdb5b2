//! Files that come into being whole or not at all, special files, and what stands there afterwards.

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
