//! Tests of writes that fail while the caller ignores the error.

use crate::tests::*;

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
    let folder = Folder::new("interrupted");
    let path = folder.0.join("out.ppm");
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
