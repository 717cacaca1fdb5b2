//! Writes the messages of this package's programs to standard output and standard error.
//!
//! The macros of the standard library panic when a stream cannot be written, and report no error for a closed stream.

use std::io::{self, Write};
use std::path::Path;

use output::{Options, Output};

/// Writes `text` to standard output, with all control characters but its line ends escaped.
///
/// It is no error if the reader has closed the pipe, as `head` does after ten lines.
///
/// # Errors
/// Standard output is closed, full or not writable.
pub fn print(text: &str) -> Result<(), output::Error> {
    let output = Output::open(Path::new("/dev/stdout"), Options::default());
    match output.and_then(|output| output.fill(|file| file.write_all(escaped(text).as_bytes()))) {
        Err(output::Error { cause, .. }) if cause.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// Writes `text` and a line end to standard error, with control characters escaped. An error is ignored, since there is
/// no other stream to report it to.
pub fn note(text: &str) {
    let _ = io::stderr().write_all(format!("{}\n", escaped(text)).as_bytes());
}

/// The text with all control characters escaped but its line ends, so that it cannot command the terminal.
fn escaped(text: &str) -> String {
    text.split('\n').map(|line| cpu::internals::input::text::escape(line.as_bytes())).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_line_ends_are_left_of_control_characters() {
        assert_eq!(escaped("one\x1b[2J\ntwo\r\n"), "one\\u{1b}[2J\ntwo\\r\n");
    }
}
