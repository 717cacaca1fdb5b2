//! Formats an error in a line of an input file. The message has the file, the line number and the column, then the line
//! with carets below the wrong part, and then a hint what to write instead. `render-aos` and `render-soa` do not use
//! this module: they print the messages that the statement prescribes.

use std::path::Path;

use cpu::Error;

use crate::format::hint::{Hint, Kind, Language, shown};
use crate::terminal;

/// Largest number of characters that a message shows of each of three parts of a line: before the wrong token, the
/// token itself, and after it.
const AROUND: usize = 60;

/// Returns the message for an error in a line of the file `path`: the line's number, and its bytes `text`. Returns
/// `None` for an error that does not belong to a line. `names` are the materials defined above the line.
pub fn message(
    error: &Error,
    kind: Kind,
    path: &Path,
    (line, text): (u64, &[u8]),
    names: &[Vec<u8>],
) -> Option<String> {
    let Hint { span, problem, remedy } = Hint::new(error, kind, text, names, Language::English)?;
    let column = String::from_utf8_lossy(&text[..span.start]).chars().count() + 1;
    let path = terminal::name(path);
    Some(format!("{path}:{line}:{column}: {problem}\n{}{remedy}", excerpt(line, text, span.start, span.end)))
}

/// Returns the line with its number, and below it carets under the bytes from `start` to `end`. A long line is
/// shortened.
fn excerpt(line: u64, text: &[u8], start: usize, end: usize) -> String {
    let [before, meant, after] = [&text[..start], &text[start..end], &text[end..]].map(shown);
    let cut = before.chars().count().saturating_sub(AROUND);
    let before: String = before.chars().skip(cut).collect();
    let meant: String = meant.chars().take(AROUND).collect();
    let after: String = after.chars().take(AROUND).collect();
    let margin = format!("{line} | {}", if cut > 0 { "..." } else { "" });
    let missing = if meant.is_empty() { 1 } else { 0 };
    let indent = margin.chars().count() + before.chars().count() + missing;
    format!("{margin}{before}{meant}{after}\n{:indent$}{}\n", "", "^".repeat(meant.chars().count().max(1)))
}
