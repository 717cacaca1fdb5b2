//! Writes to standard output and standard error, and escapes names for them.
//!
//! This module does not use `print!` of the standard library, which panics if the stream cannot be written, and reports
//! no error if the stream is closed.

use std::io::{self, Write};
use std::path::Path;

use crate::Failure;

/// Writes `text` and a line end to standard output.
///
/// A broken pipe is not an error, because programs such as `head` stop reading before the end.
///
/// # Errors
/// An error if standard output is closed, full or not writable.
pub fn print(text: &str) -> Result<(), Failure> {
    write(format!("{text}\n").as_bytes())
}

/// Writes `bytes` to standard output, as [`print()`] does.
///
/// # Errors
/// The errors of [`print()`].
pub fn write(bytes: &[u8]) -> Result<(), Failure> {
    Ok(output::print(bytes)?)
}

/// Writes `text` and a line end to standard error. An error is ignored, because there is no other place to report it.
pub fn note(text: &str) {
    let _ = io::stderr().write_all(format!("{}\n", escape_lines(text)).as_bytes());
}

/// Returns the name of a file for messages, with all control characters escaped, including line ends.
#[must_use]
pub fn name(path: &Path) -> String {
    cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes())
}

/// Returns a message of one or more lines with all control characters escaped, except its line ends.
#[must_use]
pub fn escape_lines(text: &str) -> String {
    text.split('\n').map(|line| cpu::internals::input::text::escape(line.as_bytes())).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_messages_cannot_command_a_terminal() {
        assert_eq!(name(Path::new("a\x1b[2J\nb")), r"a\u{1b}[2J\nb");
        assert_eq!(escape_lines("one\x1b\ntwo\r"), "one\\u{1b}\ntwo\\r");
    }
}
