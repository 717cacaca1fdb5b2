//! Tests of input files that change while the page is served.

use std::fs;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;

use nix::sys::stat::Mode;
use test_support::folder::Folder;

use super::*;

#[test]
fn a_link_is_followed_at_the_start_and_never_later() {
    let folder = Folder::new();
    let [file, secret, link] = ["file", "secret", "link"].map(|name| folder.file(name));
    fs::create_dir(folder.file("a")).expect("the folder is writable");
    for path in [&file, &secret, &folder.file("a/file")] {
        fs::write(path, path.as_os_str().as_encoded_bytes()).expect("the folder is writable");
    }
    symlink(&file, &link).expect("the folder is writable");
    let input = Input::new(&link).expect("it leads to a file");
    assert_eq!(input.read().expect("it is a file"), file.as_os_str().as_encoded_bytes());
    let version = input.version();
    fs::remove_file(&file).expect("the folder is writable");
    symlink(&secret, &file).expect("the folder is writable");
    for error in [input.read().map(drop), without_last_link(&file).map(drop)] {
        assert_eq!(error.expect_err("it is a link").raw_os_error(), Some(nix::errno::Errno::ELOOP as i32));
    }
    assert_eq!(input.version(), MISSING);
    assert_ne!(version, MISSING);

    // A folder that becomes a link is not followed either.
    let input = Input::new(&folder.file("a/file")).expect("it is a file");
    fs::rename(folder.file("a"), folder.file("b")).expect("the folder is writable");
    symlink(folder.file("b"), folder.file("a")).expect("the folder is writable");
    assert!(folder.file("a/file").is_file() && input.read().is_err());
}

#[test]
fn a_pipe_a_device_or_a_folder_is_not_opened_for_its_content() {
    let folder = Folder::new();
    nix::unistd::mkfifo(&folder.file("pipe"), Mode::S_IRWXU).expect("the folder is writable");
    let _socket = UnixListener::bind(folder.file("socket")).expect("the folder is writable");
    for path in [folder.file("pipe"), "/dev/zero".into(), folder.path().to_owned()] {
        let message = Input::new(&path).expect_err("it is no file");
        assert!(message.contains("it is not a regular file"), "{message}");
    }
    assert!(Input::new(&folder.file("socket")).is_err());
}

#[test]
fn a_file_of_exactly_the_limit_is_read_and_one_byte_more_refused() {
    let folder = Folder::new();
    let path = folder.file("large");
    let file = File::create(&path).expect("the folder is writable");
    let resize = |length| file.set_len(length).expect("the disk has room");
    resize(MAX_TEXT);
    let input = Input::new(&path).expect("it is as large");
    assert_eq!(input.read().expect("it is as large").len() as u64, MAX_TEXT);
    assert_ne!(input.version(), MISSING);
    // If it grows after it was opened, no more bytes are read.
    let (opened, length) = input.open().expect("it is as large");
    resize(MAX_TEXT + 1);
    assert_eq!(content(opened, length).expect("it was as large").len() as u64, MAX_TEXT);
    assert_eq!(input.read().expect_err("it is larger").to_string(), "it is larger than 16777216 bytes");
}

#[test]
fn an_edit_with_the_same_size_and_the_same_time_is_another_version() {
    let folder = Folder::new();
    let path = folder.write("file", "abc");
    let input = Input::new(&path).expect("it is a file");
    let (version, time) = (input.version(), fs::metadata(&path).and_then(|file| file.modified()));
    assert_eq!(version, version_of(b"abc"));
    fs::write(&path, "abd").expect("the folder is writable");
    let file = File::options().write(true).open(&path).expect("it is writable");
    file.set_modified(time.expect("there is a time")).expect("it is writable");
    assert_ne!(input.version(), version);
}
