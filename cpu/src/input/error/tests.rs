//! Tests the words of the messages.

use crate::input::error::*;

#[test]
fn lines_are_shown_byte_for_byte() {
    let error = Error::InvalidParameters { entity: "sphere", line: b"sphere: \xff \0 ".to_vec() };
    assert_eq!(error.message(), b"Invalid sphere parameters\nLine: \"sphere: \xff \0 \"");
    assert!(error.to_string().contains('\u{fffd}'), "as text, what is not UTF-8 is replaced");
    assert_eq!(error.message_for_terminal(), b"Invalid sphere parameters\nLine: \"sphere: \\xff \\u{0} \"");
}

#[test]
fn a_file_is_named_where_the_error_lacks_one() {
    let path = Path::new("config.txt");
    let read = Error::from(io::Error::other("gone")).in_file(path);
    assert_eq!(read.to_string(), "Cannot read file [config.txt]: gone");
    let picture = Error::from(Picture::CameraAtTarget).in_file(path);
    assert!(picture.to_string().starts_with("Invalid configuration [config.txt]: camera_position"));
    let other = Error::OutOfMemory { what: "x" }.in_file(path);
    assert_eq!(other.to_string(), "Not enough memory for x");
}

#[test]
fn causes_are_kept() {
    use std::error::Error as _;
    let read = Error::Read { path: "c.txt".into(), cause: io::Error::other("gone") };
    assert_eq!(read.to_string(), "Cannot read file [c.txt]: gone");
    assert!(read.source().is_some());
    assert!(Error::OutOfMemory { what: "the image" }.source().is_none());
}

#[test]
fn an_image_too_large_says_how_large_and_what_to_change() {
    let error = Error::from(Picture::TooLarge { width: 100_000, height: 100_000 });
    let text = error.to_string();
    assert!(text.contains("100000 x 100000") && text.contains("image_width"), "{text}");
}
