//! What the programs of this package say on standard output and standard error.
//!
//! The macros of the standard library panic where a stream takes no more, and lose what is written to a closed one.

use std::io::{self, Write};
use std::path::Path;

use cpu::internals::output::{Options, Output};

/// Writes `text` to standard output, with all control characters but its line ends escaped.
///
/// A reader that has gone, as `head` does after ten lines, is no error.
///
/// # Errors
/// [`cpu::internals::input::error::Error::Write`]: standard output is closed, full or not writable.
pub fn print(text: &str) -> Result<(), cpu::Error> {
    let output = Output::open(Path::new("/dev/stdout"), Options::default());
    match output.and_then(|output| output.fill(|file| file.write_all(escaped(text).as_bytes()))) {
        Err(cpu::internals::input::error::Error::Write { cause, .. }) if cause.kind() == io::ErrorKind::BrokenPipe => {
            Ok(())
        }
        result => result,
    }
}

/// Writes `text` and a line end to standard error, escaped in the same way. An error there cannot be told to anyone.
pub fn note(text: &str) {
    let _ = io::stderr().write_all(format!("{}\n", escaped(text)).as_bytes());
}

/// Text of several lines without characters that a terminal would obey.
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
