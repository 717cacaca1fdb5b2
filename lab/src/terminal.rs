//! What the person sees: standard output, standard error, and names as they are shown there.
//!
//! The macros of the standard library panic where a stream takes no more, and lose what is written to a closed one.

use std::io::{self, Write};
use std::path::Path;

use cpu::internals::output::{Options, Output};

use crate::Failure;

/// Writes `text` and a line end to standard output.
///
/// A reader that has gone, as `head` does after ten lines, is no failure.
///
/// # Errors
/// Standard output is closed, full or not writable.
pub fn print(text: &str) -> Result<(), Failure> {
    write(format!("{text}\n").as_bytes())
}

/// Writes `bytes` to standard output, as [`print()`] does.
///
/// # Errors
/// As [`print()`].
pub fn write(bytes: &[u8]) -> Result<(), Failure> {
    let written =
        Output::open(Path::new("/dev/stdout"), Options::default()).and_then(|out| out.fill(|out| out.write_all(bytes)));
    match written {
        Err(cpu::internals::input::error::Error::Write { cause, .. }) if cause.kind() == io::ErrorKind::BrokenPipe => {
            Ok(())
        }
        other => Ok(other?),
    }
}

/// Writes `text` and a line end to standard error. Where that takes no more there is nobody left to tell.
pub fn note(text: &str) {
    let _ = io::stderr().write_all(format!("{}\n", escape_lines(text)).as_bytes());
}

/// The name of a file, with control characters escaped, line ends among them.
#[must_use]
pub fn name(path: &Path) -> String {
    cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes())
}

/// A message of one or more lines, with all control characters but its line ends escaped.
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
