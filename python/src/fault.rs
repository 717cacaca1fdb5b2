//! The errors of the module, as exceptions of Python.

use std::io;

use format::hint::{Hint, Kind, Language, MOST_NAMES};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

pyo3::create_exception!(
    exact_renderer,
    Error,
    PyValueError,
    "A configuration, a scene or a picture that is not valid.\n\n\
     `message` says what is wrong and what to write instead. `line` and `column` are the place in the text, counted\n\
     from 1 in lines and characters. For an error without a place they are None."
);

/// Why a text was refused, or why there is no picture.
#[derive(Debug)]
pub enum Fault {
    /// An error in a line of a text.
    Line {
        /// The number of the line, from 1.
        line: u64,
        /// The number of the first wrong character, from 1.
        column: usize,
        /// What is wrong, and what to write instead.
        message: String,
    },
    /// An error without a line.
    Other(cpu::Error),
}

impl Fault {
    /// Returns the fault for `error`, which occurred in line number `line`, with the bytes `text`. `names` are the
    /// materials defined above the line.
    pub fn in_line<'a>(
        error: cpu::Error,
        kind: Kind,
        (line, text): (u64, &[u8]),
        names: impl Iterator<Item = &'a Vec<u8>>,
    ) -> Self {
        let mut names: Vec<_> = names.take(MOST_NAMES).cloned().collect();
        names.sort_unstable();
        let Some(hint) = Hint::new(&error, kind, text, &names, Language::English) else { return Self::Other(error) };
        let column = String::from_utf8_lossy(&text[..hint.span.start]).chars().count() + 1;
        Self::Line { line, column, message: hint.to_string() }
    }
}

impl From<cpu::Error> for Fault {
    fn from(error: cpu::Error) -> Self {
        Self::Other(error)
    }
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        Self::Other(error.into())
    }
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        let (place, message) = match fault {
            Fault::Line { line, column, message } => (Some((line, column)), message),
            Fault::Other(error @ cpu::Error::OutOfMemory { .. }) => return PyMemoryError::new_err(error.to_string()),
            Fault::Other(error) => (None, error.to_string()),
        };
        let text = match place {
            Some((line, column)) => format!("line {line}, column {column}: {message}"),
            None => message.clone(),
        };
        Python::attach(|py| {
            let error = Error::new_err(text);
            let value = error.value(py);
            let (line, column) = place.unzip();
            let is_set = value
                .setattr("message", message)
                .and_then(|()| value.setattr("line", line))
                .and_then(|()| value.setattr("column", column));
            is_set.err().unwrap_or(error)
        })
    }
}
