//! Files that come into being whole or not at all, special files, and what stands there afterwards.

use std::fs::Permissions;
use std::os::unix::fs::{PermissionsExt, symlink};

use crate::output::*;

mod failures;

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
    open(path)?.fill(|out| out.write_all(text.as_bytes()))
}

fn open(path: &Path) -> Result<Output, Error> {
    Output::open(path, Options::default())
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).expect("it is there").permissions().mode() & 0o7777
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
    let result = open(&path).expect("the folder is writable").fill(|out| {
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
    let output = open(&path).expect("the folder is writable");
    drop(output);
    assert!(folder.names().is_empty());
    write(&path, "old").expect("the folder is writable");
    let mut output = open(&path).expect("the folder is writable");
    output.write_all(b"half").expect("the disk has room");
    drop(output);
    assert_eq!(fs::read_to_string(&path).expect("still there"), "old");
    assert_eq!(folder.names(), ["out.ppm"]);
}

#[test]
fn folders_and_missing_folders_are_refused_at_once() {
    let folder = Folder::new("refused");
    assert!(open(&folder.0).is_err());
    assert!(open(&folder.0.join("missing/out.ppm")).is_err());
    assert!(open(&folder.0.join("out.ppm/")).is_err());
    assert!(open(&folder.0.join("out.ppm/.")).is_err());
    assert!(open(Path::new("")).is_err());
}

#[test]
fn links_are_followed_and_permissions_kept() {
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

#[test]
fn a_dangling_chain_of_links_is_followed_to_its_end() {
    let folder = Folder::new("chain");
    fs::create_dir(folder.0.join("below")).expect("the folder is writable");
    for (link, target) in [("l1", "below/l2"), ("below/l2", "../l3"), ("l3", "t")] {
        symlink(target, folder.0.join(link)).expect("links are allowed");
    }
    for text in ["first", "second"] {
        write(&folder.0.join("l1"), text).expect("the folder is writable");
        assert_eq!(folder.names(), ["below", "l1", "l3", "t"]);
        assert!(["l1", "below/l2", "l3"].iter().all(|name| folder.0.join(name).is_symlink()));
        assert!(!folder.0.join("t").is_symlink());
        assert_eq!(fs::read_to_string(folder.0.join("t")).expect("written"), text);
    }
    symlink("loop", folder.0.join("loop")).expect("links are allowed");
    assert!(open(&folder.0.join("loop")).is_err());
}

#[test]
fn a_file_that_is_being_written_is_for_its_owner_alone() {
    use crate::output::temporary::Temporary;

    let folder = Folder::new("private");
    let path = folder.0.join("out.ppm");
    let half = |folder: &Folder| folder.names().into_iter().find(|name| name.starts_with(".render-"));
    let common = {
        File::create(folder.0.join("common")).expect("the folder is writable");
        mode(&folder.0.join("common"))
    };
    // With a temporary name and without one, for a new file and for an old one.
    for named in [true, false] {
        for (old, new) in [(None, common), (Some(0o600), 0o600), (Some(0o640), 0o640), (Some(0o4755), 0o4755)] {
            let _ = fs::remove_file(&path);
            if let Some(old) = old {
                fs::write(&path, "old").expect("the folder is writable");
                fs::set_permissions(&path, Permissions::from_mode(old)).expect("it is ours");
            }
            let file = if named { Temporary::named(&path, false) } else { Temporary::new(&path, false) };
            let mut file = file.expect("the folder is writable");
            file.write_all(b"half").expect("the disk has room");
            match half(&folder) {
                Some(name) => assert_eq!(mode(&folder.0.join(name)), 0o600),
                None => assert!(!named, "where is it?"),
            }
            file.commit().expect("the folder is writable");
            assert_eq!(mode(&path), new);
            assert_eq!(fs::read_to_string(&path).expect("written"), "half");
            assert_eq!(half(&folder), None);
        }
    }
}

#[test]
fn a_named_temporary_file_goes_when_it_is_dropped() {
    use crate::output::temporary::Temporary;

    let folder = Folder::new("named");
    let path = folder.0.join("out.ppm");
    // Half of the names that a process has at a time: other tests of this process write files meanwhile.
    let files: Vec<_> = (0..8).map(|_| Temporary::named(&path, true).expect("the folder is writable")).collect();
    assert_eq!(folder.names().len(), 8);
    drop(files);
    assert!(folder.names().is_empty());
}

#[test]
fn a_file_that_came_up_meanwhile_is_replaced() {
    let folder = Folder::new("meanwhile");
    let path = folder.0.join("out.ppm");
    for sync in [false, true] {
        let mut output = Output::open(&path, Options { sync }).expect("the folder is writable");
        fs::write(&path, "another's").expect("the folder is writable");
        output.write_all(b"new").expect("the disk has room");
        output.commit().expect("the folder is writable");
        assert_eq!(fs::read_to_string(&path).expect("written"), "new");
        assert_eq!(folder.names(), ["out.ppm"]);
        fs::remove_file(&path).expect("it is ours");
    }
}

#[test]
fn a_folder_that_is_renamed_meanwhile_gets_the_file() {
    let folder = Folder::new("renamed");
    let [before, after] = ["before", "after"].map(|name| folder.0.join(name));
    fs::create_dir(&before).expect("the folder is writable");
    let mut output = open(&before.join("out.ppm")).expect("the folder is writable");
    fs::rename(&before, &after).expect("it is ours");
    fs::create_dir(&before).expect("the folder is writable");
    output.write_all(b"text").expect("the disk has room");
    output.commit().expect("the folder is writable");
    assert_eq!(fs::read_to_string(after.join("out.ppm")).expect("written"), "text");
    assert_eq!(fs::read_dir(&before).expect("it is there").count(), 0);
}

#[test]
fn sockets_and_pipes_without_permission_are_refused_at_once() {
    let folder = Folder::new("sockets");
    let path = folder.0.join("socket");
    let _socket = std::os::unix::net::UnixListener::bind(&path).expect("the folder is writable");
    let error = open(&path).expect_err("it is a socket").to_string();
    assert!(error.ends_with(": it is a socket"), "{error}");
}

#[test]
fn an_output_that_is_an_input_is_refused_under_any_name() {
    let folder = Folder::new("inputs");
    let [scene, link, hard, other] = ["scene", "link", "hard", "other"].map(|name| folder.0.join(name));
    fs::write(&scene, "text").expect("the folder is writable");
    fs::write(&other, "text").expect("the folder is writable");
    symlink("scene", &link).expect("links are allowed");
    fs::hard_link(&scene, &hard).expect("links are allowed");
    for out in [&scene, &link, &hard] {
        let error = refuse_inputs(out, &[&other, &scene]).expect_err("it is the scene").to_string();
        let expected =
            format!("Cannot write file [{}]: it is the same file as the input [{}]", out.display(), scene.display());
        assert!(error.starts_with(&expected), "{error}");
    }
    assert!(refuse_inputs(&other, &[&scene]).is_ok());
    assert!(refuse_inputs(&folder.0.join("new"), &[&scene]).is_ok());
    assert!(refuse_inputs(Path::new("/dev/null"), &[Path::new("/dev/null")]).is_ok());
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
    let result = open(&path);
    running.kill().expect("it is ours");
    running.wait().expect("it ends");
    let message = result.expect_err("it was running").to_string();
    assert!(message.starts_with(&format!("Cannot write file [{}]: ", path.display())), "{message}");
}

/// A pipe with a name, of the test's own: where this module is wrong it renames files over whatever it is given, and
/// the devices of the machine belong to all.
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
