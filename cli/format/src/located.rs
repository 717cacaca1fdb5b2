//! Tells the wrong lines of an input file: the file, the line number and the column, then the line with carets below
//! the wrong part, and then a hint what to write instead. `render-aos` and `render-soa` do not use this module: they
//! print the messages that the statement prescribes.

use std::io::BufRead;
use std::path::Path;

use cpu::Error;
use cpu::internals::input::text;

use crate::faults::{self, MOST_FAULTS};
use crate::hint::{Hint, Kind, Language, shown};
use crate::recorder::Recorder;

/// Largest number of characters that a message shows of each of three parts of a line: before the wrong token, the
/// token itself, and after it.
const AROUND: usize = 60;

/// Reads the content `input` of the file `path` with the function `parse`.
///
/// # Errors
/// The error of `parse`, and the message about all wrong lines up to [`MOST_FAULTS`]. There is no message for an error
/// that does not belong to a line.
pub fn read<R: BufRead, T>(
    input: R,
    kind: Kind,
    path: &Path,
    parse: impl FnOnce(&mut Recorder<R>) -> Result<T, Error>,
) -> Result<T, (Error, Option<String>)> {
    let mut recorder = Recorder::new(input);
    parse(&mut recorder).map_err(|first| {
        let (mut messages, mut others) = (Vec::new(), 0);
        faults::each(kind, &mut recorder, &first, |error, recorder| {
            let message = message(error, kind, path, recorder.last_line(), recorder.names());
            // If the two files are swapped, each of their lines has this error.
            let is_of_other = |message: &String| message.contains("a line of the other file");
            if message.as_ref().is_some_and(is_of_other) && messages.iter().any(is_of_other) {
                others += 1;
            } else {
                messages.extend(message);
            }
            messages.len() <= MOST_FAULTS && others <= MOST_FAULTS
        });
        if messages.len() > MOST_FAULTS {
            messages[MOST_FAULTS] = format!("these are the first {MOST_FAULTS} errors of the file, and there are more");
        }
        (first, (!messages.is_empty()).then(|| messages.join("\n\n")))
    })
}

/// Returns the message for an error in a line of the file `path`: the line's number, and its bytes `text`. Returns
/// `None` for an error that does not belong to a line. `names` are the materials defined above the line.
fn message(error: &Error, kind: Kind, path: &Path, (line, text): (u64, &[u8]), names: &[Vec<u8>]) -> Option<String> {
    let Hint { span, problem, remedy } = Hint::new(error, kind, text, names, Language::English)?;
    let column = String::from_utf8_lossy(&text[..span.start]).chars().count() + 1;
    let path = text::escape(path.as_os_str().as_encoded_bytes());
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
