//! Tests of how a folder opens its files, as Linux reports it.

use test_support::folder::Folder as Own;

use super::*;

fn open(own: &Own) -> Folder {
    Folder::open(own.path(), false).expect("it is there")
}

/// Returns the flags with which `file` was opened.
fn flags(file: &File) -> c_int {
    let text = std::fs::read_to_string(format!("/proc/self/fdinfo/{}", file.as_raw_fd())).expect("it is open");
    let line = text.lines().find_map(|line| line.strip_prefix("flags:")).expect("every file has flags");
    c_int::from_str_radix(line.trim(), 8).expect("they are octal")
}

#[test]
fn files_are_opened_only_for_writing_and_closed_when_a_program_is_started() {
    let Some(Flags { write, close_on_exec, no_follow, nonblocking, .. }) = FLAGS else { return };
    let own = Own::new();
    let folder = open(&own);
    let expected = write | close_on_exec | no_follow;
    // 3 are the bits that tell whether a file is open for reading, writing or both.
    let bits = 3 | close_on_exec | no_follow | nonblocking;
    let created = folder.create(c"new", 0o600).expect("the name is free");
    assert_eq!(flags(&created) & bits, expected);
    let opened = folder.open_for_writing(c"new").expect("it is there");
    assert_eq!(flags(&opened) & bits, expected | nonblocking);
}

#[test]
fn a_new_file_does_not_get_the_name_of_an_existing_file_or_link() {
    let own = Own::new();
    let folder = open(&own);
    std::os::unix::fs::symlink("nothing", own.file("link")).expect("links are allowed");
    drop(folder.create(c"new", 0o600).expect("the name is free"));
    for name in [c"new", c"link"] {
        let error = folder.create(name, 0o600).expect_err("the name is taken");
        assert_eq!(error.kind(), ErrorKind::AlreadyExists);
    }
    assert!(folder.open_for_writing(c"link").is_err(), "a link is not followed");
    assert!(!own.file("nothing").exists());
}

#[test]
fn a_file_may_be_replaced_but_no_folder_and_no_missing_file() {
    let own = Own::new();
    let folder = open(&own);
    drop(folder.create(c"file", 0o600).expect("the name is free"));
    folder.may_replace(c"file").expect("the folder is ours");
    assert_eq!(folder.may_replace(c"missing").map_err(|error| error.kind()), Err(ErrorKind::NotFound));
    std::fs::create_dir(own.file("full")).expect("the folder is writable");
    std::fs::write(own.file("full/file"), "").expect("the folder is writable");
    assert!(folder.may_replace(c"full").is_err());
    assert!(own.file("file").exists() && own.file("full/file").exists());
}

#[test]
fn the_right_to_write_is_checked_without_opening_the_file() {
    let own = Own::new();
    std::fs::write(own.file("file"), "").expect("the folder is writable");
    may_write(&own.file("file")).expect("it is ours");
    assert_eq!(may_write(&own.file("missing")).map_err(|error| error.kind()), Err(ErrorKind::NotFound));
}

#[test]
fn a_file_on_another_mount_is_noticed() {
    let own = Own::new();
    let folder = open(&own);
    let file = folder.create(c"file", 0o600).expect("the name is free");
    assert!(!folder.is_mount_point(&file).expect("both are open"));
    // /proc is another file system on every Linux.
    let other = File::open("/proc/self/status").expect("Linux has it");
    assert!(folder.is_mount_point(&other).expect("both are open"));
    let mounts = [mount_of(&file), mount_of(&other)];
    assert!(mounts.iter().flatten().all(|number| number.parse::<u32>().is_ok()), "{mounts:?}");
    assert!(mounts[0].is_some() && mounts[0] != mounts[1], "{mounts:?}");
}
