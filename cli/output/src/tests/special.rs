//! Tests of outputs that are not ordinary files: links, sockets, pipes, open files and running programs.

use std::io::Read;
use std::os::fd::AsRawFd;
use std::os::unix::fs::FileTypeExt;
use std::process::Command;

use crate::tests::*;

#[test]
fn a_dangling_chain_of_links_is_followed_to_its_end_and_the_links_stay() {
    let folder = Folder::new();
    fs::create_dir(folder.file("below")).expect("the folder is writable");
    for (link, target) in [("l1", "below/l2"), ("below/l2", "../l3"), ("l3", "t"), ("loop", "loop")] {
        symlink(target, folder.file(link)).expect("links are allowed");
    }
    for text in ["first", "second"] {
        write(&folder.file("l1"), text).expect("the folder is writable");
        assert_eq!(folder.names(), ["below", "l1", "l3", "loop", "t"]);
        assert!(["l1", "below/l2", "l3"].iter().all(|name| folder.file(name).is_symlink()));
        assert_eq!((folder.file("t").is_symlink(), folder.read("t")), (false, text.into()));
    }
    let end = follow(&folder.file("l1")).and_then(fs::canonicalize).expect("it leads to a file");
    assert_eq!(end, folder.file("t").canonicalize().expect("it is there"));
    assert!(open(&folder.file("loop")).is_err());
}

#[test]
fn a_link_in_a_folder_of_all_users_is_refused() {
    let folder = Folder::new();
    let shared = folder.file("shared");
    fs::create_dir_all(folder.file("own/below")).expect("the folder is writable");
    fs::create_dir(&shared).expect("the folder is writable");
    symlink("../own/out.ppm", shared.join("link")).expect("links are allowed");
    symlink("../own", shared.join("folder")).expect("links are allowed");
    symlink("../shared/link", folder.file("own/chain")).expect("links are allowed");
    let paths = ["shared/link", "shared/folder/out.ppm", "shared/folder/below/out.ppm", "own/chain"];
    for (mode, is_refused) in [(0o1777, true), (0o755, false), (0o777, false)] {
        fs::set_permissions(&shared, Permissions::from_mode(mode)).expect("it is ours");
        for path in paths {
            let opened = open(&folder.file(path)).map(drop);
            assert_eq!(opened.is_err(), is_refused, "{path} {mode:o}");
            if let Err(error) = opened {
                assert!(error.to_string().contains("it leads through a link in a folder of all users"), "{error}");
            }
        }
    }
    fs::set_permissions(&shared, Permissions::from_mode(0o1777)).expect("it is ours");
    write(&shared.join("file"), "no link").expect("the folder is writable");
}

#[test]
fn folders_and_sockets_are_refused_at_once() {
    let folder = Folder::new();
    let _socket = std::os::unix::net::UnixListener::bind(folder.file("socket")).expect("the folder is writable");
    for path in [folder.path().to_owned(), folder.file("socket")] {
        assert!(open(&path).is_err());
    }
}

/// Checks that a pipe gets the bytes directly. The test uses a named pipe in its own folder and no device of the
/// machine, because a fault of this package could replace the device by a file.
#[test]
fn a_pipe_takes_the_bytes_directly_and_waits_for_its_reader_only_when_it_is_written() {
    let folder = Folder::new();
    let path = folder.file("pipe");
    let status = Command::new("mkfifo").arg(&path).status().expect("every Unix has mkfifo");
    assert!(status.success());
    drop(open(&path).expect("it is not opened yet"));
    let read = |most: u64| {
        let from = path.clone();
        std::thread::spawn(move || {
            let mut text = String::new();
            File::open(from).and_then(|file| file.take(most).read_to_string(&mut text)).map(|_| text)
        })
    };
    for text in ["", "through a pipe"] {
        let reader = read(u64::MAX);
        write(&path, text).expect("the thread reads");
        assert_eq!(reader.join().expect("it reads").expect("it is text"), text);
    }
    let reader = read(1);
    // The text is larger than the buffer of a pipe.
    let error = write(&path, &"x".repeat(1 << 20)).expect_err("the reader has closed the pipe");
    assert!(error.to_string().starts_with(&format!("Cannot write file [{}]: ", path.display())), "{error}");
    reader.join().expect("it ends").expect("the pipe is there");
    assert!(fs::symlink_metadata(&path).expect("there").file_type().is_fifo());
    assert_eq!(folder.names(), ["pipe"]);
}

#[test]
fn an_open_file_is_replaced_under_its_name_and_refused_without_one() {
    let folder = Folder::new();
    let file = File::create(folder.file("out.ppm")).expect("the folder is writable");
    let path = format!("/proc/self/fd/{}", file.as_raw_fd());
    write(path.as_ref(), "text").expect("the folder is writable");
    assert_eq!(folder.read("out.ppm"), b"text");
    // The descriptor leads to the old file, which has lost its name.
    assert!(open(path.as_ref()).is_err());
    let (mut reader, writer) = io::pipe().expect("a pipe is made");
    write(format!("/dev/fd/{}", writer.as_raw_fd()).as_ref(), "piped").expect("the buffer takes it");
    drop(writer);
    let mut text = String::new();
    reader.read_to_string(&mut text).expect("it is text");
    assert_eq!((&text[..], folder.names()), ("piped", vec!["out.ppm".to_owned()]));
}

#[test]
fn standard_output_is_known_by_its_names_and_links() {
    let folder = Folder::new();
    symlink("/dev/stdout", folder.file("link")).expect("links are allowed");
    for name in [Path::new("/dev/stdout"), Path::new("/dev/fd/1"), &folder.file("link")] {
        assert!(is_stdout(name) && !open(name).expect("it is open").is_regular());
    }
    assert!(!is_stdout(&folder.file("out.ppm")) && !is_stdout(Path::new("/dev/null")));
    print(b"").expect("standard output is open");
}

/// Checks that a running program is not replaced. Even root may not write to it. Renaming another file over it would be
/// possible, but `open` refuses.
#[test]
fn a_file_that_may_not_be_written_is_not_replaced() {
    let folder = Folder::new();
    let path = folder.file("sleep");
    fs::copy("/bin/sleep", &path).expect("the folder is writable");
    let start = || Command::new(&path).arg("60").spawn();
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
