//! The texts that the caller wrote, and the result of the last call.

use cpu::internals::input::error::Error;
use cpu::{Config, Scene};
use format::hint::{Hint, Kind, Language, MOST_NAMES, material};

use crate::fault::{Fault, Place};
use crate::live::Live;

/// The configuration and the scene as the caller wrote them, and the result of the last call.
#[derive(Debug)]
pub struct State {
    /// The bytes of the configuration and of the scene.
    pub texts: [Vec<u8>; 2],
    /// A file, a message or a list: the result of the last call that has one.
    pub result: Vec<u8>,
    /// The place of the last fault.
    pub fault: Place,
    /// The hints on the last fault.
    pub hints: [String; 2],
    /// The scene for the shaders, after it has been asked for.
    pub live: Option<Live>,
}

impl State {
    /// Returns a state without texts.
    pub const fn new() -> Self {
        Self {
            texts: [Vec::new(), Vec::new()],
            result: Vec::new(),
            fault: Place { text: 0, line: 0, column: 0, length: 0 },
            hints: [String::new(), String::new()],
            live: None,
        }
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

    /// Stores the message and the place of a fault as the result.
    pub fn store(&mut self, fault: &Fault) {
        self.result.clone_from(&fault.message);
        self.fault = fault.place;
        self.hints.clone_from(&fault.hints);
    }
}

/// Parses `bytes`, the text number `text`. The parsers stop in the first wrong line, so the bytes that they have read
/// end with this line.
fn parse<T>(bytes: &[u8], text: usize, parse: fn(&mut &[u8]) -> Result<T, Error>) -> Result<T, Fault> {
    let mut rest = bytes;
    parse(&mut rest).map_err(|error| {
        let read = &bytes[..bytes.len() - rest.len()];
        let read = read.strip_suffix(b"\n").unwrap_or(read);
        let start = read.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
        let line = read[start..].strip_suffix(b"\r").unwrap_or(&read[start..]);
        let kind = if text == 0 { Kind::Config } else { Kind::Scene };
        let names = read.split(|&byte| byte == b'\n').filter_map(material);
        let names: Vec<_> = names.take(MOST_NAMES).map(<[u8]>::to_vec).collect();
        let hint = |language| Hint::new(&error, kind, line, &names, language);
        let (Some(hint), Some(spanish)) = (hint(Language::English), hint(Language::Spanish)) else {
            return Fault::without_line(error, text);
        };
        let number = 1 + read.iter().filter(|&&byte| byte == b'\n').count();
        let [column, length] = [&line[..hint.span.start], &line[hint.span.clone()]].map(units);
        let place = Place { text, line: number, column: 1 + column, length };
        Fault { message: error.message(), place, hints: [hint, spanish].map(|hint| hint.to_string()) }
    })
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
