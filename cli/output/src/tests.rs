//! Tests that an output is replaced completely or not at all.

use std::ffi::OsStr;
use std::fs::{self, File, Permissions};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};

use test_support::folder::Folder;

use crate::*;

mod signals;
mod special;

fn open(path: &Path) -> Result<Output, Error> {
    Output::open(path, Options::default())
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    open(path)?.fill(|out| out.write_all(text.as_bytes()))
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).expect("it is there").permissions().mode() & 0o7777
}

#[test]
fn a_file_is_created_and_replaced_whole_and_leaves_nothing_beside_it() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    for (sync, text) in [(false, "a longer first text"), (false, "second"), (true, "third")] {
        let output = Output::open(&path, Options { sync }).expect("the folder is writable");
        assert!(output.is_regular());
        output.fill(|out| out.write_all(text.as_bytes())).expect("the disk has room");
        assert_eq!(fs::read_to_string(&path).expect("written"), text);
        assert_eq!(folder.names(), ["out.ppm"]);
    }
}

#[test]
fn an_output_without_a_commit_changes_nothing() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    for old in [None, Some("old")] {
        old.into_iter().for_each(|old| drop(folder.write("out.ppm", old)));
        let names = folder.names();
        let mut dropped = open(&path).expect("the folder is writable");
        dropped.write_all(b"half").expect("the disk has room");
        drop(dropped);
        let failed = open(&path).expect("the folder is writable").fill(|out| {
            out.write_all(b"half of the ne")?;
            Err(ErrorKind::StorageFull.into())
        });
        assert!(failed.is_err());
        assert_eq!((fs::read_to_string(&path).ok().as_deref(), folder.names()), (old, names));
    }
}

#[test]
fn folders_missing_folders_and_too_long_names_are_refused_at_once() {
    let folder = Folder::new();
    folder.write("file", "");
    let long = "x".repeat(256);
    for bad in ["", "missing/out.ppm", "out.ppm/", "out.ppm/.", "..", "file/out.ppm", &long] {
        assert!(open(&folder.path().join(bad)).is_err(), "{bad}");
    }
    assert!(open(Path::new("")).is_err());
    write(&folder.file(&long[..255]), "the longest name").expect("the folder is writable");
    assert_eq!(folder.names(), ["file", &long[..255]]);
}

#[test]
fn permissions_stay_and_a_half_file_is_its_owners_alone() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    File::create(folder.file("common")).expect("the folder is writable");
    write(&path, "new").expect("the folder is writable");
    assert_eq!(mode(&path), mode(&folder.file("common")));
    for old in [0o600, 0o640, 0o666, 0o4755, 0o2070 | 0o200] {
        fs::set_permissions(&path, Permissions::from_mode(old)).expect("it is ours");
        let mut output = open(&path).expect("the folder is writable");
        output.write_all(b"half").expect("the disk has room");
        let half = output.file.as_ref().expect("it is open").metadata().expect("it is open");
        assert_eq!(half.permissions().mode() & 0o7777, 0o600);
        output.commit().expect("the folder is writable");
        assert_eq!(mode(&path), old);
    }
}

#[test]
fn the_other_names_of_a_file_keep_the_old_content() {
    let folder = Folder::new();
    fs::hard_link(folder.write("out.ppm", "old"), folder.file("other")).expect("links are allowed");
    write(&folder.file("out.ppm"), "new").expect("the folder is writable");
    assert_eq!((folder.read("out.ppm"), folder.read("other")), (b"new".to_vec(), b"old".to_vec()));
}

#[test]
fn a_file_that_appears_meanwhile_is_replaced_and_a_folder_is_not() {
    let folder = Folder::new();
    let path = folder.file("out.ppm");
    let [first, second] = [(); 2].map(|()| open(&path).expect("the folder is writable"));
    fs::write(&path, "another's").expect("the folder is writable");
    first.fill(|out| out.write_all(b"new")).expect("the folder is writable");
    assert_eq!(folder.read("out.ppm"), b"new");
    fs::remove_file(&path).expect("it is ours");
    fs::create_dir(&path).expect("the folder is writable");
    assert!(second.fill(|out| out.write_all(b"new")).is_err());
    assert_eq!((folder.names(), folder.names_in("out.ppm").len()), (vec!["out.ppm".to_owned()], 0));
}

#[test]
fn a_folder_that_is_renamed_meanwhile_gets_the_file() {
    let folder = Folder::new();
    let [before, after] = ["before", "after"].map(|name| folder.file(name));
    fs::create_dir(&before).expect("the folder is writable");
    let output = open(&before.join("out.ppm")).expect("the folder is writable");
    fs::rename(&before, &after).expect("it is ours");
    fs::create_dir(&before).expect("the folder is writable");
    output.fill(|out| out.write_all(b"text")).expect("the disk has room");
    assert_eq!(folder.read("after/out.ppm"), b"text");
    assert!(folder.names_in("before").is_empty());
}

#[test]
fn an_output_that_is_an_input_is_refused_under_any_name() {
    let folder = Folder::new();
    let [scene, other] = ["scene", "other"].map(|name| folder.write(name, "text"));
    let [link, hard] = ["link", "hard"].map(|name| folder.file(name));
    symlink("scene", &link).expect("links are allowed");
    fs::hard_link(&scene, &hard).expect("links are allowed");
    for out in [&scene, &link, &hard] {
        let error = refuse_inputs(out, &[&other, &scene]).expect_err("it is the scene").to_string();
        let expected =
            format!("Cannot write file [{}]: it is the same file as the input [{}]", out.display(), scene.display());
        assert!(error.starts_with(&expected), "{error}");
    }
    // A name that is not UTF-8 is kept.
    let input = scene.with_file_name(OsStr::from_bytes(b"\xff"));
    fs::hard_link(&scene, &input).expect("links are allowed");
    let message = refuse_inputs(&scene, &[&input]).expect_err("it is the scene").message(<[u8]>::to_vec);
    assert!(message.ends_with(b"\xff]; choose another file for the output"), "{}", message.escape_ascii());
    let message = Error::same_file(&other, "output", &scene, "write to one").to_string();
    assert!(message.ends_with(&format!("it is the same file as the output [{}]; write to one", scene.display())));
    assert!(refuse_inputs(&other, &[&scene]).is_ok());
    assert!(refuse_inputs(&folder.file("new"), &[&scene, &folder.file("missing")]).is_ok());
    assert!(refuse_inputs(Path::new("/dev/null"), &[Path::new("/dev/null")]).is_ok());
}

/// Checks that `commit` returns the error of an ignored write. Every write to `/dev/full` fails as on a full disk.
#[test]
fn a_failed_write_fails_the_commit_too_when_its_error_was_ignored() {
    let full = Path::new("/dev/full");
    let mut output = open(full).expect("it is a device that may be opened");
    assert!(!output.is_regular() && output.write(b"lost").is_err());
    let message = output.commit().expect_err("bytes were lost");
    assert_eq!(message.to_string(), "Cannot write file [/dev/full]: no storage space");
    assert_eq!(message.message(|_| b"?".to_vec()), b"Cannot write file [?]: ?");
    let told = write(full, "lost").expect_err("bytes were lost").to_string();
    assert!(told.starts_with("Cannot write file [/dev/full]: No space left on device"), "{told}");
    open(full).and_then(Output::commit).expect("nothing was lost");
}
