//! Writes to standard output and standard error, and escapes names for them.
//!
//! This module does not use `print!` of the standard library, which panics if the stream cannot be written, and reports
//! no error if the stream is closed.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

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

/// Writes `value` as JSON to standard output.
///
/// # Errors
/// The errors of [`print()`].
pub fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(value).map_err(|error| error.to_string())?;
    // JSON escapes only some of the characters that a terminal obeys. All of these have four hexadecimal digits.
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        if letter != '\n' && is_obeyed(letter) {
            shown += &format!("\\u{:04x}", u32::from(letter));
        } else {
            shown.push(letter);
        }
    }
    print(&shown)
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

/// Returns the rows as lines whose columns are aligned. Columns of numbers are aligned to the right.
pub fn table(rows: &[Vec<String>]) -> String {
    // A line end in a cell would forge a row.
    let escape = |cell: &String| cpu::internals::input::text::escape(cell.as_bytes());
    let rows: Vec<Vec<_>> = rows.iter().map(|row| row.iter().map(escape).collect()).collect();
    let width = |place: usize| rows.iter().filter_map(|row| Some(row.get(place)?.chars().count())).max().unwrap_or(0);
    let starts_a_number = |cell: &String| cell.is_empty() || cell.starts_with(|c: char| c.is_ascii_digit());
    let is_number = |place: usize| rows.iter().skip(1).filter_map(|row| row.get(place)).all(starts_a_number);
    let columns: Vec<_> = (0..rows.first().map_or(0, Vec::len)).map(|place| (width(place), is_number(place))).collect();
    let line = |row: &Vec<String>| {
        let cell = |(cell, &(width, is_number)): (&String, &(usize, bool))| {
            if is_number { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
        };
        row.iter().zip(&columns).map(cell).collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect::<Vec<_>>().join("\n")
}

/// Returns a progress bar of `steps` steps on standard error, with their name `what`. It shows nothing if standard
/// error is not a terminal.
pub fn progress(steps: usize, what: &'static str) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{wide_bar} {percent} %  {pos} of {len} {msg}  {per_sec:>14}  {eta:>4} left");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(steps as u64).with_style(style).with_message(what)
}

/// Returns `words` as a command that a user can copy into a shell: unusual words are quoted.
pub fn quoted<'a>(words: impl IntoIterator<Item = &'a OsStr>) -> String {
    let words: Vec<_> = words.into_iter().map(|word| name(Path::new(word))).collect();
    // The only error is a zero byte, which a name for messages does not have.
    shlex::try_join(words.iter().map(String::as_str)).unwrap_or_default()
}

/// Returns the name of a file for messages, with all control characters escaped, including line ends.
pub fn name(path: &Path) -> String {
    cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes())
}

/// Returns what another program or a stranger's file says, for a message of one or more lines: control characters and
/// bytes that are no text are escaped, and line ends at the end are left out.
pub fn foreign(text: &[u8]) -> String {
    escape_lines(String::from_utf8_lossy(text).trim_end_matches(['\n', '\r']))
}

/// Whether a terminal obeys this character instead of showing it: a control character, or one that changes the
/// direction of writing.
pub fn is_obeyed(letter: char) -> bool {
    cpu::internals::input::text::escape(letter.encode_utf8(&mut [0; 4]).as_bytes()).len() > letter.len_utf8()
}

/// Returns a text as the cell of a table for a spreadsheet: on one line, and never a formula.
pub fn cell(text: &str) -> String {
    let text = cpu::internals::input::text::escape(text.as_bytes());
    if text.starts_with(['=', '+', '-', '@', '\t']) { format!("'{text}") } else { text }
}

/// Returns a message of one or more lines with all control characters escaped, except its line ends.
pub fn escape_lines(text: &str) -> String {
    text.split('\n').map(|line| cpu::internals::input::text::escape(line.as_bytes())).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_aligned_to_the_right() {
        let rows = [["name", "time"], ["a", "12 s"], ["ñandú", "3 s"]].map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(table(&rows), "name   time\na      12 s\nñandú   3 s");
    }

    #[test]
    fn a_command_can_be_copied() {
        let words = ["a b", "it's", "./x", ""].map(OsStr::new);
        assert_eq!(quoted(words), r#"'a b' "it's" ./x ''"#);
    }
}
