//! Tests that an output is replaced completely or not at all.

use std::fs::Permissions;
use std::os::unix::fs::{PermissionsExt, symlink};

use test_support::folder::Folder;

use crate::*;

mod special;

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
fn a_file_is_created_and_replaced_whole() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    write(&path, "a longer first text").expect("the folder is writable");
    write(&path, "second").expect("the folder is writable");
    assert_eq!(fs::read_to_string(&path).expect("written"), "second");
    assert_eq!(folder.names(), ["out.ppm"]);
}

#[test]
fn an_output_without_a_commit_changes_nothing() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    for old in [None, Some("old")] {
        old.into_iter().for_each(|old| drop(folder.write("out.ppm", old)));
        let names = folder.names();
        drop(open(&path).expect("the folder is writable"));
        let mut dropped = open(&path).expect("the folder is writable");
        dropped.write_all(b"half").expect("the disk has room");
        drop(dropped);
        let failed = open(&path).expect("the folder is writable").fill(|out| {
            out.write_all(b"half of the ne")?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(failed.is_err());
        assert_eq!((fs::read_to_string(&path).ok().as_deref(), folder.names()), (old, names));
    }
}

#[test]
fn folders_and_missing_folders_are_refused_at_once() {
    let folder = Folder::new();
    assert!(open(folder.path()).is_err());
    assert!(open(&folder.file("missing/out.ppm")).is_err());
    assert!(open(&folder.file("out.ppm/")).is_err());
    assert!(open(&folder.file("out.ppm/.")).is_err());
    assert!(open(Path::new("")).is_err());
}

#[test]
fn only_the_owner_may_open_a_file_that_is_being_written() {
    use crate::temporary::Temporary;

    let folder = Folder::new();
    let path = folder.file("out.ppm");
    let half = |folder: &Folder| folder.names().into_iter().find(|name| name.starts_with(".render-"));
    let common = {
        File::create(folder.file("common")).expect("the folder is writable");
        mode(&folder.file("common"))
    };
    // Cases: with and without a temporary name; the file is new, or replaces a file with these permissions.
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
                Some(name) => assert_eq!(mode(&folder.file(name)), 0o600),
                None => assert!(!named, "the temporary file has no name"),
            }
            file.commit().expect("the folder is writable");
            assert_eq!(mode(&path), new);
            assert_eq!(fs::read_to_string(&path).expect("written"), "half");
            assert_eq!(half(&folder), None);
        }
    }
}

#[test]
fn a_named_temporary_file_is_removed_when_it_is_dropped() {
    use crate::temporary::Temporary;

    let folder = Folder::new();
    let path = folder.file("out.ppm");
    // Uses 8 of the 16 slots for names of a process, since other tests of this process write files at the same time.
    let files: Vec<_> = (0..8).map(|_| Temporary::named(&path, true).expect("the folder is writable")).collect();
    assert_eq!(folder.names().len(), 8);
    drop(files);
    assert!(folder.names().is_empty());
}

#[test]
fn a_file_that_another_process_creates_meanwhile_is_replaced() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
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
    let folder = Folder::new();
    let [before, after] = ["before", "after"].map(|name| folder.file(name));
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
fn an_output_that_is_an_input_is_refused_under_any_name() {
    let folder = Folder::new();
    let [scene, link, hard, other] = ["scene", "link", "hard", "other"].map(|name| folder.file(name));
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
    assert!(refuse_inputs(&folder.file("new"), &[&scene]).is_ok());
    assert!(refuse_inputs(Path::new("/dev/null"), &[Path::new("/dev/null")]).is_ok());
}

/// Checks that `commit` returns the error of an ignored write. Every write to `/dev/full` fails as on a full disk.
#[cfg(target_os = "linux")]
#[test]
fn a_failed_write_fails_the_commit_too_when_its_error_was_ignored() {
    let full = Path::new("/dev/full");
    let mut output = open(full).expect("it is a device that may be opened");
    assert!(output.write(b"lost").is_err());
    let message = output.commit().expect_err("bytes were lost").to_string();
    assert!(message.starts_with("Cannot write file [/dev/full]: No space left on device"), "{message}");
    let ignored = open(full).and_then(|output| {
        output.fill(|file| {
            let _ = file.write_all(b"lost");
            Ok(())
        })
    });
    assert!(matches!(ignored, Err(Error { .. })), "{ignored:?}");
    open(full).and_then(Output::commit).expect("nothing was lost");
}

#[test]
fn an_interrupted_write_is_no_failure_and_the_first_failure_is_reported() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    let mut output = open(&path).expect("the folder is writable");
    output.remember(&io::ErrorKind::Interrupted.into());
    output.write_all(b"whole").expect("the disk has room");
    output.commit().expect("nothing was lost");
    assert_eq!(fs::read(&path).expect("written"), b"whole");
    let mut output = open(&path).expect("the folder is writable");
    for kind in [io::ErrorKind::StorageFull, io::ErrorKind::BrokenPipe] {
        output.remember(&kind.into());
    }
    let result = output.commit();
    assert!(matches!(&result, Err(Error { cause, .. }) if cause.kind() == io::ErrorKind::StorageFull), "{result:?}");
    assert_eq!(fs::read(&path).expect("it stands"), b"whole");
}

#[test]
fn two_outputs_to_one_file_are_refused_and_named() {
    let folder = Folder::new();
    let (path, link) = (folder.file("out.ppm"), folder.file("link.ppm"));
    symlink("out.ppm", &link).expect("links are allowed");
    let error = refuse_one_file(&[&path, &link]).expect_err("the link leads to the file");
    assert!(error.to_string().contains(&format!("the same file as the output [{}]", path.display())), "{error}");
    assert!(error.message(|_| b"?".to_vec()).starts_with(b"Cannot write file [?]: ?"));
    refuse_one_file(&[&path, Path::new("/dev/null"), Path::new("/dev/null")]).expect("the files differ");
}

#[test]
fn standard_output_is_known_by_its_names_and_is_no_regular_file() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    assert!(is_stdout(Path::new("/dev/stdout")) && !is_stdout(&path));
    assert!(open(&path).expect("the folder is writable").is_regular());
    assert!(!open(Path::new("/dev/null")).expect("everybody may write to it").is_regular());
    print(b"").expect("standard output is open");
}
