//! Writes the messages of this package's programs to standard output and to standard error, and shows their progress.
//!
//! This module does not use the macros of the standard library, which panic if a stream cannot be written, and report
//! no error if a stream is closed.

use std::io::{self, Write};
use std::process::ExitCode;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Writes `text` to standard output. All control characters except line ends are escaped.
///
/// A closed pipe is not an error, because programs such as `head` stop reading before the end.
///
/// # Errors
/// An error if standard output is closed, full or not writable.
pub fn print(text: &str) -> Result<(), output::Error> {
    output::print(escaped(text).as_bytes())
}

/// Writes `text` and a line end to standard error, with control characters escaped. An error is ignored, because there
/// is no other stream on which to report it.
pub fn note(text: &str) {
    let _ = io::stderr().write_all(format!("{}\n", escaped(text)).as_bytes());
}

/// Exit status for an error.
pub const TROUBLE: u8 = 2;

/// Writes an error for the user, and returns the exit status for it.
pub fn failed(message: &str) -> ExitCode {
    note(&format!("Error: {message}"));
    ExitCode::from(TROUBLE)
}

/// Writes what clap answers instead of arguments, and returns the exit status. The help goes to standard output, and a
/// message to standard error. The message repeats the arguments, so its control characters are escaped.
pub fn answer(answer: &clap::Error) -> ExitCode {
    let text = answer.render().to_string();
    if answer.use_stderr() {
        note(text.trim_end());
        return ExitCode::from(TROUBLE);
    }
    print(&text).map_or_else(|error| failed(&error.to_string()), |()| ExitCode::SUCCESS)
}

/// Returns a bar on standard error for work of `parts` parts. Its text begins with `words`, and it vanishes when it is
/// dropped. It shows nothing if standard error is not a terminal.
#[must_use]
pub fn bar(words: &'static str, parts: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg}: {percent} %, about {eta} left");
    ProgressBar::with_draw_target(Some(parts as u64), ProgressDrawTarget::stderr())
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        .with_message(words)
}

/// Returns `text` with all control characters except line ends escaped, so that it cannot send commands to the
/// terminal.
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
