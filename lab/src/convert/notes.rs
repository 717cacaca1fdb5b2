//! Collects what a conversion leaves out or approximates, with the file and the lines.

use indexmap::IndexMap;

use crate::terminal;

/// A line of one of the files that are read: the position of the file in [`Notes::files`], and the line's number.
pub type Place = (usize, usize);

/// What the conversion could not do exactly.
#[derive(Debug, Default)]
pub struct Notes {
    /// The names of the files that are read, for messages.
    pub files: Vec<String>,
    /// The lines of a file to which each text applies.
    found: IndexMap<(usize, String), Vec<usize>>,
}

impl Notes {
    /// Returns no notes, about these files.
    pub fn of(files: Vec<String>) -> Self {
        Self { files, ..Self::default() }
    }

    /// Adds a note about the line `place`. Notes of one text about several lines are printed as one.
    pub fn add(&mut self, (file, line): Place, text: impl Into<String>) {
        self.found.entry((file, text.into())).or_default().push(line);
    }

    /// Returns the notes as lines of text: file, line, what has no match and what is done instead.
    pub fn to_lines(&self) -> Vec<String> {
        /// Number of further lines that a note names.
        const MOST: usize = 5;
        let line = |((file, text), lines): (&(usize, String), &Vec<usize>)| {
            let others = &lines[1..];
            let named: Vec<_> = others.iter().take(MOST).map(usize::to_string).collect();
            let more = match others.len() {
                0 => String::new(),
                1..=MOST => format!(" (also line {})", named.join(", ")),
                count => format!(" (also line {} and {} more)", named.join(", "), count - MOST),
            };
            format!("{}:{}: {text}{more}", self.files[*file], lines[0])
        };
        self.found.iter().map(line).collect()
    }

    /// Prints the notes on standard error.
    pub fn print(&self) {
        self.to_lines().iter().for_each(|line| terminal::note(line));
    }
}
