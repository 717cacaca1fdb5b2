//! Bytes of files as text that is safe to print, one character for each of theirs: carets stand below the right ones.

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
