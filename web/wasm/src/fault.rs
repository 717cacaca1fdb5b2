//! A message about the texts or the picture, and the place in a text that it is about.

use cpu::internals::input::error::Error;
use format::hint::spanish_without_line;
use serde::Serialize;

/// The place of a fault in a text. The three numbers are 0 if the fault is not about a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Place {
    /// The text: 0 is the configuration, 1 the scene. A fault that is about no text, such as too little memory, has 2.
    pub text: usize,
    /// The number of the line, counted from 1.
    pub line: usize,
    /// The first character of the wrong token, counted from 1. Characters are counted in units of UTF-16, as editors
    /// and JavaScript do.
    pub column: usize,
    /// Number of characters of the wrong token, in units of UTF-16. It is 0 if a token is missing.
    pub length: usize,
}

/// A message with its place.
#[derive(Clone, Debug, Serialize)]
pub struct Fault {
    /// The message, which is that of `render-aos` for its errors.
    #[serde(skip)]
    pub message: Vec<u8>,
    /// The place of the error.
    #[serde(flatten)]
    pub place: Place,
    /// What is wrong and what to write instead, in English and in Spanish. For an error without a line the first one is
    /// empty, and the second one is the message in Spanish.
    pub hints: [String; 2],
}

impl Fault {
    /// Returns the fault for an error that is about no line of the text number `text`.
    pub fn without_line(error: Error, text: usize) -> Self {
        let text = if matches!(error, Error::OutOfMemory { .. }) { 2 } else { text };
        let hints = [String::new(), spanish_without_line(&error)];
        Self { message: error.message(), place: Place { text, ..Place::default() }, hints }
    }

    /// Returns the fault for a message that is not one of `render-aos`, and its Spanish words.
    pub fn own(message: String, spanish: &str, text: usize) -> Self {
        let hints = [String::new(), spanish.to_owned()];
        Self { message: message.into_bytes(), place: Place { text, ..Place::default() }, hints }
    }
}
