//! Bytes of files and names as text that is safe to print.

use std::path::Path;

/// A piece of a line: a character for each of its own, a question mark for each that a terminal would obey.
#[must_use]
pub fn line(bytes: &[u8]) -> String {
    let tame = |character: char| match character {
        '\t' => ' ',
        control if control.is_control() => '?',
        other => other,
    };
    String::from_utf8_lossy(bytes).chars().map(tame).collect()
}

/// A file's name, by the same rule.
#[must_use]
pub fn path(path: &Path) -> String {
    line(path.as_os_str().as_encoded_bytes())
}
