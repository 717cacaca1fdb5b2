//! Formats an error in a line of an input file. The message has the file, the line number and the column, then the line
//! with carets below the wrong part, and then a hint what to write instead. `render-aos` and `render-soa` do not use
//! this module: they print the messages that the statement prescribes.

use std::path::Path;

use cpu::Error;
use cpu::internals::input::text::Tokens;

use crate::format::{CONFIG, Line, SCENE, place};
use crate::terminal;

/// The kind of an input file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A configuration.
    Config,
    /// A scene.
    Scene,
}

/// Largest number of characters that a message shows of each of three parts of a line: before the wrong token, the
/// token itself, and after it.
const AROUND: usize = 60;

/// Returns the message for `error`, which occurred in line number `line` of the file `path`, with the bytes `text`.
/// Returns `None` for an error that does not belong to a line. `names` are the materials defined above the line.
#[must_use]
pub fn message(
    error: &Error,
    kind: Kind,
    path: &Path,
    (line, text): (u64, &[u8]),
    names: &[Vec<u8>],
) -> Option<String> {
    let (summary, hint) = describe(error, kind, text, names)?;
    let (start, end) = place::span(text, place::wrong_token(error, text)?);
    let place =
        format!("{}:{line}:{}", terminal::name(path), String::from_utf8_lossy(&text[..start]).chars().count() + 1);
    Some(format!("{place}: {summary}\n{}{hint}", excerpt(line, text, start, end)))
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

/// Returns what is wrong and what to do. Returns `None` for an error that does not belong to a line.
fn describe(error: &Error, kind: Kind, text: &[u8], names: &[Vec<u8>]) -> Option<(String, String)> {
    Some(match error {
        Error::UnknownKey { key } => {
            let hint = unknown(key, kind, "key");
            (format!("there is no configuration key [{}]", shown(key)), hint)
        }
        Error::UnknownEntity { name } => {
            let hint = unknown(name, kind, "entity");
            (format!("there is no scene entity [{}]", shown(name)), hint)
        }
        Error::InvalidValue { .. } | Error::InvalidParameters { .. } => wrong_field(place::line_of(error)?, text),
        Error::ExtraValue { .. } | Error::ExtraParameters { .. } => extra(place::line_of(error)?),
        Error::MaterialExists { name, .. } => {
            let name = shown(name);
            (format!("a material [{name}] is already defined above"), "choose another name".to_owned())
        }
        Error::MaterialNotFound { name, .. } => {
            let hint = nearest(name, names.iter().map(Vec::as_slice)).map_or_else(
                || "define it on a line above, as in: matte: NAME 0.5 0.5 0.5".to_owned(),
                |known| format!("did you mean [{}]?", shown(known)),
            );
            (format!("no material [{}] is defined above this line", shown(name)), hint)
        }
        _ => return None,
    })
}

/// Returns a hint for a line whose first word is unknown.
fn unknown(word: &[u8], kind: Kind, what: &str) -> String {
    let bare = word.strip_suffix(b":").unwrap_or(word);
    let has = |lines: &[Line]| lines.iter().any(|line| line.tag.as_bytes().strip_suffix(b":") == Some(bare));
    let (own, other, order) = match kind {
        Kind::Config => (&CONFIG[..], &SCENE[..], "this looks like a scene file; the configuration comes first"),
        Kind::Scene => (&SCENE[..], &CONFIG[..], "this looks like a configuration file; it comes before the scene"),
    };
    if has(other) {
        return format!("{order}: CONFIG SCENE");
    }
    if has(own) {
        return format!("a colon follows the word: [{}:]", shown(bare));
    }
    let words = own.iter().filter_map(|line| line.tag.as_bytes().strip_suffix(b":"));
    match nearest(bare, words) {
        Some(known) => format!("did you mean [{}:]?", shown(known)),
        None => {
            let topic = if kind == Kind::Config { "config" } else { "scene" };
            format!("render-lab help {topic} lists every {what}")
        }
    }
}

/// Returns the element of `known` that is most similar to `word`, or `None` if none is similar enough.
fn nearest<'a>(word: &[u8], known: impl Iterator<Item = &'a [u8]>) -> Option<&'a [u8]> {
    /// The smallest Jaro-Winkler similarity of a suggestion, from 0 to 1. clap uses 0.7 for its suggestions.
    const LEAST_SIMILARITY: f64 = 0.8;
    let word = String::from_utf8_lossy(word);
    known
        .map(|known| (strsim::jaro_winkler(&word, &String::from_utf8_lossy(known)), known))
        .filter(|(similarity, _)| *similarity > LEAST_SIMILARITY)
        .max_by(|one, other| one.0.total_cmp(&other.0))
        .map(|(_, known)| known)
}

fn wrong_field(line: &Line, text: &[u8]) -> (String, String) {
    let usage = format!("the line is: {} {}", line.tag, line.values);
    let word = line.tag.trim_end_matches(':');
    let problem = match place::wrong_field(line, text) {
        None => "the axis must have a length above 0".to_owned(),
        Some(field) => {
            let wanted = line.fields[field].wanted();
            match Tokens::new(text).nth(field + 1) {
                Some(token) => format!("[{}] is not {wanted}", shown(token)),
                None => format!("{wanted} is missing"),
            }
        }
    };
    (format!("{word}: {problem}"), usage)
}

fn extra(line: &Line) -> (String, String) {
    let summary = format!("{} there is more than its {} values", line.tag, line.fields.len());
    let summary = if line.fields.len() == 1 { format!("{} there is more than its value", line.tag) } else { summary };
    (summary, format!("the line is: {} {}", line.tag, line.values))
}

/// Returns a part of a line as text that is safe to print. A space replaces each tab, and a question mark replaces
/// every other control character. The number of characters stays the same, so that carets in the next line stand below
/// the right characters.
fn shown(bytes: &[u8]) -> String {
    let tame = |character: char| match character {
        '\t' => ' ',
        control if control.is_control() => '?',
        other => other,
    };
    String::from_utf8_lossy(bytes).chars().map(tame).collect()
}
