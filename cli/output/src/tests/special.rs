//! Tests of outputs that are not ordinary files: links, sockets, pipes and running programs.

use crate::tests::*;

#[test]
fn a_dangling_chain_of_links_is_followed_to_its_end() {
    let folder = Folder::new();
    fs::create_dir(folder.file("below")).expect("the folder is writable");
    for (link, target) in [("l1", "below/l2"), ("below/l2", "../l3"), ("l3", "t")] {
        symlink(target, folder.file(link)).expect("links are allowed");
    }
    for text in ["first", "second"] {
        write(&folder.file("l1"), text).expect("the folder is writable");
        assert_eq!(folder.names(), ["below", "l1", "l3", "t"]);
        assert!(["l1", "below/l2", "l3"].iter().all(|name| folder.file(name).is_symlink()));
        assert!(!folder.file("t").is_symlink());
        assert_eq!(fs::read_to_string(folder.file("t")).expect("written"), text);
    }
    symlink("loop", folder.file("loop")).expect("links are allowed");
    assert!(open(&folder.file("loop")).is_err());
}

#[test]
fn sockets_and_pipes_without_permission_are_refused_at_once() {
    let folder = Folder::new();
    let path = folder.file("socket");
    let _socket = std::os::unix::net::UnixListener::bind(&path).expect("the folder is writable");
    let error = open(&path).expect_err("it is a socket").to_string();
    assert!(error.ends_with(": it is a socket"), "{error}");
}

/// Checks that a pipe gets the bytes directly. The test uses a named pipe in its own folder and no device of the
/// machine, because a fault of this package could replace the device by a file.
#[test]
fn special_files_take_the_bytes_directly() {
    use std::io::Read;
    use std::os::unix::fs::FileTypeExt;
    let folder = Folder::new();
    let path = folder.file("pipe");
    let status = std::process::Command::new("mkfifo").arg(&path).status().expect("every Unix has mkfifo");
    assert!(status.success());
    let is_pipe = || fs::symlink_metadata(&path).expect("there").file_type().is_fifo();

    let from = path.clone();
    let reader = std::thread::spawn(move || {
        let mut text = String::new();
        File::open(from).and_then(|mut file| file.read_to_string(&mut text)).map(|_| text)
    });
    write(&path, "through a pipe").expect("the thread reads");
    assert!(is_pipe());
    assert_eq!(reader.join().expect("it reads").expect("it is text"), "through a pipe");

    let from = path.clone();
    let reader = std::thread::spawn(move || File::open(from).map(drop));
    // The text is larger than the buffer of a pipe.
    let error = write(&path, &"x".repeat(1 << 20)).expect_err("the reader has closed the pipe");
    assert!(error.to_string().starts_with(&format!("Cannot write file [{}]: ", path.display())), "{error}");
    reader.join().expect("it ends").expect("the pipe is there");
    assert!(is_pipe());
    assert_eq!(folder.names(), ["pipe"]);
}

/// Checks that a running program is not replaced. Even root may not write to it. Renaming another file over it would be
/// possible, but `open` refuses.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_may_not_be_written_is_not_replaced() {
    let folder = Folder::new();
    let path = folder.file("sleep");
    fs::copy("/bin/sleep", &path).expect("the folder is writable");
    let start = || std::process::Command::new(&path).arg("60").spawn();
    // Starting the copy fails while any process has it open for writing. A process that another test starts may inherit
    // that open file for a moment.
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
