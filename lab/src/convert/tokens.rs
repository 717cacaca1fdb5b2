//! Cuts the text of a pbrt file into tokens, with their lines, through all files that it includes.

use std::path::Path;

use cpu::internals::input::reader::read_text;

use super::notes::{Fault, Place};

/// Largest size of a file in bytes, and of all files together. The tokens take many times as much memory.
pub const MAX_BYTES: u64 = 1 << 28;

/// Largest number of files. A file that includes itself reaches it.
const MAX_FILES: usize = 1000;

/// The tokens that are still to be read, the last of them first. A token is a bracket, a word, or a text, which begins
/// with `"` and has no `"` at its end.
#[derive(Debug, Default)]
pub struct Tokens {
    rest: Vec<(String, Place)>,
    files: usize,
    bytes: u64,
    /// The place of the token that was taken last.
    pub last: Place,
}

impl Tokens {
    /// Puts the tokens of the file `path` before the others. `place` is the line that includes it.
    ///
    /// # Errors
    /// A fault if the file cannot be read, if a text in it has no end, or if there are too many files.
    pub fn include(&mut self, path: &Path, place: Place) -> Result<(), Fault> {
        if self.files == MAX_FILES {
            return Err((place, format!("more than {MAX_FILES} files are included; does a file include itself?")));
        }
        let text = read_text(path, MAX_BYTES - self.bytes)
            .map_err(|error| (place, format!("[{}] cannot be read: {error}", path.display())))?;
        let start = self.rest.len();
        // A byte order mark is no part of the text.
        let (mut rest, mut line) = (text.trim_start_matches('\u{feff}'), 1);
        while let Some(first) = rest.chars().next() {
            let is_end = |letter: char| letter.is_whitespace() || "[]\"#".contains(letter);
            let length = match first {
                '#' => rest.find('\n').unwrap_or(rest.len()),
                '"' => {
                    1 + rest[1..].find(['"', '\n']).filter(|&at| rest[1 + at..].starts_with('"')).ok_or_else(|| {
                        ((self.files, line), "a text begins here; close it with \" on its line".to_owned())
                    })?
                }
                '[' | ']' => 1,
                _ => rest.find(is_end).unwrap_or(rest.len()).max(first.len_utf8()),
            };
            if first != '#' && !first.is_whitespace() {
                self.rest.push((rest[..length].to_owned(), (self.files, line)));
            }
            line += usize::from(first == '\n');
            rest = &rest[length + usize::from(first == '"')..];
        }
        self.rest[start..].reverse();
        self.files += 1;
        self.bytes += text.len() as u64;
        Ok(())
    }

    /// Returns the next token without taking it.
    pub fn peek(&self) -> Option<&str> {
        self.rest.last().map(|(token, _)| &token[..])
    }

    /// Takes the next token, and returns it with its line.
    ///
    /// # Errors
    /// A fault if there is none.
    pub fn take(&mut self) -> Result<(String, Place), Fault> {
        let next = self.rest.pop().ok_or((self.last, "the file ends here, and a value is missing".to_owned()))?;
        self.last = next.1;
        Ok(next)
    }
}
