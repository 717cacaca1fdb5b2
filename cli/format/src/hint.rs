//! Says in plain words what is wrong in a line of an input file, and what to write instead. `render-lab` and the page
//! print these words. `render-aos` and `render-soa` do not use them: the statement prescribes their messages.

use std::fmt;
use std::ops::Range;

use cpu::Error;
use cpu::internals::input::error::{MAX_PIXELS, Picture};
use cpu::internals::input::text::{Tokens, parse_real};

use crate::unseen::{self, find};
use crate::{CONFIG, Field, Line, SCENE, Words, place, rewrite};

/// Largest number of names of materials that a caller stores for [`Hint::new`].
pub const MOST_NAMES: usize = 10_000;

/// The kind of an input file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A configuration.
    Config,
    /// A scene.
    Scene,
}

/// The language of a hint, with its index in [`Words`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Spanish.
    Spanish,
}

/// What is wrong in a line, where, and what to write instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The wrong bytes of the line. The range is empty where something is missing.
    pub span: Range<usize>,
    /// What is wrong.
    pub problem: String,
    /// What to do about it.
    pub remedy: String,
}

impl Language {
    /// Returns the text in this language.
    #[must_use]
    pub const fn pick(self, words: Words) -> &'static str {
        words[self as usize]
    }

    /// Returns the text in this language, with `values` in the places of its `{}`.
    #[must_use]
    pub fn say(self, words: Words, values: &[&str]) -> String {
        let mut values = values.iter();
        let mut pieces = words[self as usize].split("{}");
        let first = pieces.next().unwrap_or_default().to_owned();
        pieces.fold(first, |text, piece| text + values.next().unwrap_or(&"") + piece)
    }
}

impl Hint {
    /// Returns the hint for `error`, which occurred in the line `text` of a file of the kind `kind`. `names` are the
    /// materials defined above the line. Returns `None` for an error that does not belong to a line.
    #[must_use]
    pub fn new(error: &Error, kind: Kind, text: &[u8], names: &[Vec<u8>], language: Language) -> Option<Self> {
        let (start, end) = place::span(text, place::wrong_token(error, text)?);
        // An unseen character may have moved what is missing or too much, so then it is sought in the whole line.
        let is_extra = matches!(error, Error::ExtraValue { .. } | Error::ExtraParameters { .. });
        let has_lines = text.contains(&b'\r');
        let part = if start == end || is_extra || has_lines { 0..text.len() } else { start..end };
        if let Some(unseen) = find(&text[part.clone()]) {
            let code = format!("U+{:04X}", u32::from(unseen.character));
            let what = unseen.what[language as usize];
            let problem = language
                .say(["{} ({}) stands here, and it is not seen", "aquí hay {} ({}), que no se ve"], &[what, &code]);
            let span = part.start + unseen.span.start..part.start + unseen.span.end;
            return Some(Self { span, problem, remedy: unseen.remedy[language as usize].to_owned() });
        }
        let (problem, remedy) = Writer { kind, text, names, language }.describe(error)?;
        Some(Self { span: start..end, problem, remedy })
    }
}

impl fmt::Display for Hint {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}; {}", self.problem, self.remedy)
    }
}

/// Returns the message of an error that is about no line in Spanish, or nothing for other errors.
#[must_use]
pub fn spanish_without_line(error: &Error) -> String {
    let (Error::Picture(cause) | Error::PictureIn { cause, .. }) = error else {
        let is_memory = matches!(error, Error::OutOfMemory { .. });
        return if is_memory { "no hay memoria suficiente".to_owned() } else { String::new() };
    };
    match cause {
        Picture::TooLarge { width, height } => format!(
            "la imagen es demasiado grande: {width} x {height} píxeles, como máximo {MAX_PIXELS} en total; elija un \
             image_width menor u otro aspect_ratio"
        ),
        Picture::CameraAtTarget => {
            "camera_position es el mismo punto que camera_target; mueva uno de los dos".to_owned()
        }
        Picture::NorthParallel => "camera_north es nulo o paralelo a la vista de camera_position a camera_target; \
                                   elija otro norte"
            .to_owned(),
        Picture::CameraOutOfRange => {
            "la posición, el objetivo o field_of_view de la cámara se sale de los límites: su \
                                      ventana no es finita"
                .to_owned()
        }
        _ => String::new(),
    }
}

/// What a hint is made of.
struct Writer<'a> {
    kind: Kind,
    text: &'a [u8],
    names: &'a [Vec<u8>],
    language: Language,
}

impl Writer<'_> {
    /// Returns the text in the language of the hint; see [`Language::say`].
    fn say(&self, words: Words, values: &[&str]) -> String {
        self.language.say(words, values)
    }

    /// Returns what is wrong and what to do. Returns `None` for an error that does not belong to a line.
    fn describe(&self, error: &Error) -> Option<(String, String)> {
        Some(match error {
            Error::UnknownKey { key } => (
                self.say(["there is no configuration key [{}]", "no hay ninguna clave [{}]"], &[&shown(key)]),
                self.unknown(key),
            ),
            Error::UnknownEntity { name } => (
                self.say(["there is no scene entity [{}]", "no hay ninguna entidad [{}]"], &[&shown(name)]),
                self.unknown(name),
            ),
            Error::InvalidValue { .. } | Error::InvalidParameters { .. } => {
                let line = place::line_of(error)?;
                self.about_line(line, self.wrong_field(line))
            }
            Error::ExtraValue { .. } | Error::ExtraParameters { .. } => {
                let line = place::line_of(error)?;
                let problem = match line.fields.len() {
                    1 => self.say(["there is more than its value", "hay más que su valor"], &[]),
                    count => self
                        .say(["there is more than its {} values", "hay más que sus {} valores"], &[&count.to_string()]),
                };
                self.about_line(line, problem)
            }
            Error::MaterialExists { name, .. } => {
                let problem = ["a material [{}] is already defined above", "más arriba ya se define un material [{}]"];
                (self.say(problem, &[&shown(name)]), self.say(["choose another name", "elija otro nombre"], &[]))
            }
            Error::MaterialNotFound { name, .. } => {
                let problem =
                    ["no material [{}] is defined above this line", "ningún material [{}] se define más arriba"];
                (self.say(problem, &[&shown(name)]), self.other_material(name))
            }
            _ => return None,
        })
    }

    /// Returns the remedy for the name of a material that no line defines.
    fn other_material(&self, name: &[u8]) -> String {
        let text = String::from_utf8_lossy(name);
        let is_known = |bare: &str| self.names.iter().any(|known| known == bare.as_bytes());
        if rewrite::MARKS[0].iter().any(|mark| text.split_once(mark).is_some_and(|(bare, _)| is_known(bare))) {
            return self.say(rewrite::COMMENT, &[]);
        }
        // A name of few letters is not similar to itself with a character that is not seen.
        let is_seen = |letter: &char| unseen::name(*letter).is_none();
        let seen = |name: &[u8]| String::from_utf8_lossy(name).chars().filter(is_seen).collect::<String>();
        let names = || self.names.iter().map(Vec::as_slice);
        let Some(known) = names().find(|known| seen(known) == seen(name)).or_else(|| nearest(name, names())) else {
            let define = ["define it on a line above, as in: {}", "defínalo en una línea anterior, como en: {}"];
            return self.say(define, &["matte: NAME 0.5 0.5 0.5"]);
        };
        let mean = self.mean(name, known, "");
        let there = ["{} It has {}, which is not seen; correct it there", "{} Tiene {}, que no se ve; corríjalo allí"];
        find(known).map_or(mean.clone(), |unseen| self.say(there, &[&mean, unseen.what[self.language as usize]]))
    }

    /// Returns the question "did you mean", with the word `known` and `end`, for the word of the file. If the two words
    /// differ in letters beyond ASCII, such as a Cyrillic one that looks like a Latin one, the codes follow.
    fn mean(&self, word: &[u8], known: &[u8], end: &str) -> String {
        let [word, known] = [word, known].map(shown);
        let mean = self.say(["did you mean [{}{}]?", "¿quería decir [{}{}]?"], &[&known, end]);
        let is_foreign = |letter: &char| !letter.is_ascii();
        if word.chars().filter(is_foreign).eq(known.chars().filter(is_foreign)) {
            return mean;
        }
        // `escape_default` would double the backslashes of `shown`.
        let codes = [known, word].map(|text| text.escape_default().to_string().replace("\\\\", "\\"));
        self.say(["{} That is [{}], and not [{}]", "{} Eso es [{}], y no [{}]"], &[&mean, &codes[0], &codes[1]])
    }

    /// Returns a hint for a line whose first word is unknown.
    fn unknown(&self, word: &[u8]) -> String {
        if rewrite::MARKS.iter().copied().flatten().any(|mark| word.starts_with(mark.as_bytes())) {
            return self.say(rewrite::COMMENT, &[]);
        }
        let bare = word.strip_suffix(b":").unwrap_or(word);
        let words = |lines: &'static [Line]| lines.iter().filter_map(|line| line.tag.as_bytes().strip_suffix(b":"));
        let (own, other, topic) = match self.kind {
            Kind::Config => (&CONFIG[..], &SCENE[..], "config"),
            Kind::Scene => (&SCENE[..], &CONFIG[..], "scene"),
        };
        if words(other).any(|known| known == bare) {
            let order =
                ["this is a line of the other file; the order is: CONFIG SCENE", "esta línea es del otro archivo"];
            return self.say(order, &[]);
        }
        if let Some(line) = self.rewritten(|tag| own.iter().find(|line| line.tag == tag)) {
            return line;
        }
        if words(own).any(|known| known == bare) {
            return self.say(["a colon follows the word: [{}:]", "tras la palabra va «:»: [{}:]"], &[&shown(bare)]);
        }
        match nearest(bare, words(own)) {
            Some(known) => self.mean(bare, known, ":"),
            None => self.say(["render-lab help {} lists all lines", "render-lab help {} muestra las líneas"], &[topic]),
        }
    }

    /// Returns what to do and the line as it would be valid; see [`rewrite::line`].
    fn rewritten(&self, find_line: impl Fn(&str) -> Option<&'static Line>) -> Option<String> {
        let (words, valid) = rewrite::line(self.text, find_line)?;
        Some(format!("{}: {valid}", self.say(words, &[])))
    }

    /// Returns the problem with the tag of its line, and as the remedy a valid line or the line's format.
    fn about_line(&self, line: &'static Line, problem: String) -> (String, String) {
        let tokens: Vec<_> = Tokens::new(self.text).skip(1).collect();
        let numbers = tokens.iter().take_while(|token| parse_real(token).is_some()).count();
        let needed = line.fields.len() - 1;
        let (first, last) = (line.fields.first(), line.fields.last());
        let problem = match tokens.get(numbers) {
            Some(name) if last == Some(&Field::Name) && numbers + 1 == tokens.len() && numbers != needed => self.say(
                [
                    "there are {} numbers before the name [{}], and {} are needed",
                    "hay {} números antes del nombre [{}], y hacen falta {}",
                ],
                &[&numbers.to_string(), &shown(name), &needed.to_string()],
            ),
            None if first == Some(&Field::Name) && numbers == needed => {
                self.say(["the name before the numbers is missing", "falta el nombre antes de los números"], &[])
            }
            _ => problem,
        };
        let values = line.values_in(self.language);
        let remedy = self
            .rewritten(|_| Some(line))
            .unwrap_or_else(|| self.say(["the line is: {} {}", "la línea es: {} {}"], &[line.tag, &values]));
        (format!("{} {problem}", line.tag), remedy)
    }

    /// Says what is wrong with the first wrong value of the line.
    fn wrong_field(&self, line: &Line) -> String {
        let Some(index) = place::wrong_field(line, self.text) else {
            // The squares of a length beyond these limits are 0 or infinite.
            return self
                .say(["the axis must have a length from 1e-161 to 1e154", "el eje debe medir de 1e-161 a 1e154"], &[]);
        };
        let field = line.fields[index];
        let wanted = field.wanted()[self.language as usize];
        let Some(token) = Tokens::new(self.text).nth(index + 1) else {
            return self.say(["{} is missing", "falta {}"], &[wanted]);
        };
        let (words, value) = out_of_range(field, token).unwrap_or((["[{}] is not {}", "[{}] no es {}"], wanted));
        self.say(words, &[&shown(token), value])
    }
}

/// Returns the words for a token that is a number with the sign that `field` needs and still not valid, and a value in
/// these words.
fn out_of_range(field: Field, token: &[u8]) -> Option<(Words, &'static str)> {
    const LARGE: Words = ["[{}] is too large: at most {}", "[{}] es demasiado grande: como máximo {}"];
    const NEAR: Words =
        ["[{}] is so near to {} that it is rounded to it", "[{}] está tan cerca de {} que se redondea a él"];
    let value: f64 = std::str::from_utf8(token).ok()?.parse().ok().filter(|_| token.iter().any(u8::is_ascii_digit))?;
    let mut mantissa = token.iter().take_while(|byte| !b"eE".contains(byte));
    match field {
        Field::Count if value >= 2_f64.powi(64) => Some((LARGE, "18446744073709551615")),
        Field::Count if value > 0.0 && value.fract() == 0.0 => {
            Some((["[{}] is not written with digits alone", "[{}] no está escrito solo con cifras"], ""))
        }
        Field::Real | Field::Positive | Field::NotNegative if value == f64::INFINITY => Some((LARGE, "1.797e308")),
        Field::Real if value == f64::NEG_INFINITY => {
            Some((["[{}] is too small: at least {}", "[{}] es demasiado pequeño: como mínimo {}"], "-1.797e308"))
        }
        Field::Positive | Field::Degrees if value == 0.0 && mantissa.any(|byte| (b'1'..=b'9').contains(byte)) => {
            Some((NEAR, "0"))
        }
        Field::Degrees if value == 180.0 && mantissa.any(|byte| *byte == b'9') => Some((NEAR, "180")),
        _ => None,
    }
}

/// Returns the element of `known` that is most similar to `word`, or `None` if none is similar enough.
#[must_use]
pub fn nearest<'a>(word: &[u8], known: impl Iterator<Item = &'a [u8]>) -> Option<&'a [u8]> {
    /// The smallest Jaro-Winkler similarity of a suggestion, from 0 to 1. clap uses 0.7 for its suggestions.
    const LEAST_SIMILARITY: f64 = 0.8;
    let text = |word: &[u8]| String::from_utf8_lossy(word).to_lowercase();
    let word = text(word);
    known
        .map(|known| (strsim::jaro_winkler(&word, &text(known)), known))
        .filter(|(similarity, _)| *similarity > LEAST_SIMILARITY)
        .max_by(|one, other| one.0.total_cmp(&other.0))
        .map(|(_, known)| known)
}

/// Returns the name of the material that `line` defines, or `None` if the line defines none.
#[must_use]
pub fn material(line: &[u8]) -> Option<&[u8]> {
    let mut tokens = Tokens::new(line);
    matches!(tokens.next()?, b"matte:" | b"metal:" | b"refractive:").then(|| tokens.next())?
}

/// Returns a part of a line as text that is safe to print, in which every character is seen. A space replaces each tab.
/// Characters that are not seen, and bytes that are not UTF-8, are escaped.
#[must_use]
pub fn shown(bytes: &[u8]) -> String {
    let mut text = String::new();
    for chunk in bytes.utf8_chunks() {
        for character in chunk.valid().chars() {
            match character {
                '\t' => text.push(' '),
                unseen if unseen::name(unseen).is_some() => text.extend(unseen.escape_default()),
                other => text.push(other),
            }
        }
        text.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    text
}
