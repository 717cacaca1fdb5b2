//! The texts that the caller wrote, and the result of the last call.

use cpu::internals::input::error::Error;
use cpu::{Config, Scene};
use format::faults::{self, MOST_FAULTS};
use format::hint::{Hint, Kind, Language};
use format::recorder::Recorder;

use crate::fault::{Fault, Place};
use crate::live::Live;

/// The configuration and the scene as the caller wrote them, and the result of the last call.
#[derive(Debug)]
pub struct State {
    /// The bytes of the configuration and of the scene.
    pub texts: [Vec<u8>; 2],
    /// A file, a message or a list: the result of the last call that has one.
    pub result: Vec<u8>,
    /// The faults of the last text that was checked.
    pub faults: Vec<Fault>,
    /// The last fault.
    pub fault: Option<Fault>,
    /// The scene for the shaders, after it has been asked for.
    pub live: Option<Live>,
}

impl State {
    /// Returns a state without texts.
    pub const fn new() -> Self {
        Self { texts: [Vec::new(), Vec::new()], result: Vec::new(), faults: Vec::new(), fault: None, live: None }
    }

    /// Returns the configuration, if it is valid and describes a picture that can be made.
    ///
    /// # Errors
    /// The first fault of the text, or else that of the picture.
    pub fn config(&self) -> Result<Config, Fault> {
        let config = parse(&self.texts[0], 0, |input| Config::parse(input))?;
        config.check_picture().map_err(|error| Fault::without_line(error, 0))?;
        Ok(config)
    }

    /// Returns the scene, if it is valid.
    ///
    /// # Errors
    /// The first fault of the text.
    pub fn scene(&self) -> Result<Scene, Fault> {
        parse(&self.texts[1], 1, |input| Scene::parse(input))
    }

    /// Returns the faults of a text, at most [`MOST_FAULTS`]. The first is that of [`State::config`] or of
    /// [`State::scene`].
    pub fn faults_of(&self, text: usize) -> Vec<Fault> {
        let checked = if text == 0 { self.config().map(drop) } else { self.scene().map(drop) };
        let Err(first) = checked else { return Vec::new() };
        match self.texts.get(text) {
            Some(bytes) if first.place.line > 0 => all(bytes, text, MOST_FAULTS),
            _ => vec![first],
        }
    }

    /// Stores a fault, and its message as the result.
    pub fn store(&mut self, fault: Fault) {
        self.result.clone_from(&fault.message);
        self.fault = Some(fault);
    }
}

/// Parses `bytes`, the text number `text`.
fn parse<T>(bytes: &[u8], text: usize, parse: fn(&mut &[u8]) -> Result<T, Error>) -> Result<T, Fault> {
    parse(&mut &*bytes)
        .map_err(|error| all(bytes, text, 1).into_iter().next().unwrap_or_else(|| Fault::without_line(error, text)))
}

/// Returns the first `most` faults of the text number `text` that are about a line.
fn all(bytes: &[u8], text: usize, most: usize) -> Vec<Fault> {
    let kind = if text == 0 { Kind::Config } else { Kind::Scene };
    let mut input = Recorder::new(bytes);
    let mut found = Vec::new();
    let parsed = match kind {
        Kind::Config => Config::parse(&mut input).map(drop),
        Kind::Scene => Scene::parse(&mut input).map(drop),
    };
    if let Err(first) = parsed {
        faults::each(kind, &mut input, &first, |error, input| {
            found.extend(fault_in(error, kind, input, text));
            found.len() < most
        });
    }
    found
}

/// Returns the fault for an error in the last line of `input`, or `None` for an error that is not about a line.
fn fault_in(error: &Error, kind: Kind, input: &Recorder<&[u8]>, text: usize) -> Option<Fault> {
    let (number, line) = input.last_line();
    let hint = |language| Hint::new(error, kind, line, input.names(), language);
    let (hint, spanish) = (hint(Language::English)?, hint(Language::Spanish)?);
    let [column, length] = [&line[..hint.span.start], &line[hint.span.clone()]].map(units);
    let place = Place { text, line: number as usize, column: 1 + column, length };
    Some(Fault { message: error.message(), place, hints: [hint, spanish].map(|hint| hint.to_string()) })
}

/// Returns the number of UTF-16 units of a text. A byte that is not UTF-8 counts as one character.
fn units(text: &[u8]) -> usize {
    String::from_utf8_lossy(text).encode_utf16().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place_of(config: &str, scene: &str) -> (usize, [usize; 3]) {
        let state = State { texts: [config.into(), scene.into()], ..State::new() };
        let fault = state.config().err().or_else(|| state.scene().err()).expect("one of the texts is wrong");
        (fault.place.text, [fault.place.line, fault.place.column, fault.place.length])
    }

    #[test]
    fn the_place_of_a_fault_is_its_line_and_its_token() {
        assert_eq!(place_of("gamma: 1\r\n\r\n  gama: 2\r\ngamma: 3", ""), (0, [3, 3, 5]));
        assert_eq!(place_of("gamma: x", ""), (0, [1, 8, 1]));
        assert_eq!(place_of("gamma:\n", ""), (0, [1, 7, 0]));
        assert_eq!(place_of("", "matte: m 1 1 1\n\nsphere: 0 0 0 1 n\n"), (1, [3, 17, 1]));
    }

    #[test]
    fn columns_count_in_units_of_utf_16() {
        // Each of these two names has one character of two units.
        assert_eq!(place_of("", "matte: 😀 1 1 1\nmatte: 😀 1 1 1\n"), (1, [2, 8, 2]));
        assert_eq!(place_of("", "matte: 😀 1 1 x\n"), (1, [1, 15, 1]));
    }

    #[test]
    fn a_picture_that_cannot_be_made_is_a_fault_of_the_configuration_without_a_line() {
        assert_eq!(place_of("camera_target: 0 0 -10\n", ""), (0, [0; 3]));
        assert_eq!(Fault::without_line(Error::OutOfMemory { what: "the image" }, 1).place.text, 2);
    }
}
