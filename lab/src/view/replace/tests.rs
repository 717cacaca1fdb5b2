//! Tests of files that other programs change while they are replaced.

use std::cell::Cell;
use std::os::unix::fs::{PermissionsExt, symlink};

use test_support::folder::Folder;

use super::*;
use crate::view::input;

/// Replaces the file, and calls `edit` just before the replaced content is looked at.
fn replaced(path: &Path, edit: impl Fn()) -> Result<bool, output::Error> {
    let reads = Cell::new(0);
    let read = |path: &Path| {
        reads.set(reads.get() + 1);
        // The first reading is the check before anything is written.
        if reads.get() == 2 {
            edit();
        }
        fs::read(path)
    };
    replace(path, (b"old", b"new"), read, Options { sync: true })
}

#[test]
fn a_file_with_the_old_content_is_replaced_and_keeps_its_rights() {
    let folder = Folder::new();
    let path = folder.write("file", "old");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("it is ours");
    assert!(replaced(&path, || ()).expect("nobody has changed it"));
    assert_eq!(fs::read(&path).expect("it is there"), b"new");
    assert_eq!(fs::metadata(&path).expect("it is there").permissions().mode() & 0o777, 0o640);
    assert_eq!(folder.names(), ["file"], "no other file is left");
}

#[test]
fn an_edit_that_came_before_the_exchange_stays() {
    let folder = Folder::new();
    let path = folder.write("file", "edited");
    assert!(matches!(replaced(&path, || ()), Ok(false)));
    assert_eq!((fs::read(&path).expect("it is there"), folder.names()), (b"edited".to_vec(), vec!["file".into()]));
}

#[test]
fn an_edit_during_the_exchange_stays_whether_it_writes_or_renames() {
    let folder = Folder::new();
    let path = folder.write("file", "old");
    // The file that is replaced is still open in an editor, which writes into it.
    let mut editor = fs::OpenOptions::new().write(true).open(&path).expect("it is writable");
    let result = replaced(&path, || (&editor).write_all(b"typed").expect("it is open"));
    assert!(matches!(result, Ok(false)));
    editor.flush().expect("it is open");
    assert_eq!(fs::read(&path).expect("it is there"), b"typed");

    // Another editor renames its file to the name after the exchange, so it has replaced the new file.
    fs::write(&path, "old").expect("the folder is writable");
    let other = folder.write("other", "renamed");
    let result = replaced(&path, || fs::rename(&other, &path).expect("the folder is writable"));
    assert!(matches!(result, Ok(true)));
    assert_eq!((fs::read(&path).expect("it is there"), folder.names()), (b"renamed".to_vec(), vec!["file".into()]));
}

#[test]
fn a_link_is_never_followed() {
    let folder = Folder::new();
    let [target, path] = [folder.write("target", "old"), folder.file("link")];
    symlink(&target, &path).expect("the folder is writable");
    let read = |path: &Path| input::content(input::without_links(path)?, 3);
    let refused = |path: &Path, old: &[u8]| {
        let result = replace(path, (old, b"new"), read, Options::default());
        assert!(matches!(result, Ok(false)), "{result:?}");
    };
    refused(&path, b"old");
    assert_eq!(fs::read(&target).expect("it is there"), b"old");

    // A pipe is not opened for writing, which would wait for a reader. Reading it or the device gives no bytes.
    let [pipe, device] = ["pipe", "device"].map(|name| folder.file(name));
    nix::unistd::mkfifo(&pipe, nix::sys::stat::Mode::S_IRWXU).expect("the folder is writable");
    symlink("/dev/null", &device).expect("the folder is writable");
    refused(&pipe, b"");
    refused(&device, b"");
    assert_eq!(folder.names().len(), 4, "no other file is left");
}
