//! Finds the part of a line that an error is about, so that a message or an editor can mark it.

use cpu::Error;
use cpu::internals::input::text::{Tokens, trim};

use crate::{CONFIG, Field, Line, SCENE};

/// Returns the number of the wrong token in the line `text`, which `error` is about. The first token has number 0. If
/// the wrong token is missing, the number is that of the place where it belongs. Returns `None` for an error that is
/// not about a line.
#[must_use]
pub fn wrong_token(error: &Error, text: &[u8]) -> Option<usize> {
    Some(match error {
        Error::UnknownKey { .. } | Error::UnknownEntity { .. } => 0,
        Error::InvalidValue { .. } | Error::InvalidParameters { .. } => match wrong_field(line_of(error)?, text) {
            Some(field) => field + 1,
            None => axis(line_of(error)?),
        },
        Error::ExtraValue { .. } | Error::ExtraParameters { .. } => line_of(error)?.fields.len() + 1,
        Error::MaterialExists { .. } => 1,
        Error::MaterialNotFound { .. } => Tokens::new(text).count().saturating_sub(1),
        _ => return None,
    })
}

/// Returns the row of the tables that describes the line of `error`. Returns `None` if no such row exists.
#[must_use]
pub fn line_of(error: &Error) -> Option<&'static Line> {
    match error {
        Error::InvalidValue { key, .. } | Error::ExtraValue { key, .. } => CONFIG.iter().find(|line| line.tag == *key),
        Error::InvalidParameters { entity, .. } => {
            let word = entity.split(' ').next()?;
            SCENE.iter().find(|line| line.tag.strip_suffix(':') == Some(word))
        }
        Error::ExtraParameters { tag, .. } => SCENE.iter().find(|line| line.tag == *tag),
        _ => None,
    }
}

/// Returns the index of the first field whose token in `text` is missing or invalid. Returns `None` if every field is
/// valid on its own: then the error is a cylinder whose axis has no length.
#[must_use]
pub fn wrong_field(line: &Line, text: &[u8]) -> Option<usize> {
    let tokens: Vec<_> = Tokens::new(text).skip(1).collect();
    let is_wrong = |(place, field): (usize, &Field)| tokens.get(place).is_none_or(|token| !field.accepts(token));
    line.fields.iter().enumerate().position(is_wrong)
}

/// Returns the number of the first token of a cylinder's axis, which follows the radius.
fn axis(line: &Line) -> usize {
    1 + line.fields.iter().position(|field| *field == Field::Positive).map_or(0, |place| place + 1)
}

/// Returns the start and the end of token number `token` in `text`, as byte offsets from 0. If the line has fewer
/// tokens, both are the end of the last token.
#[must_use]
pub fn span(text: &[u8], token: usize) -> (usize, usize) {
    match Tokens::new(text).nth(token) {
        Some(found) => offsets(text, found),
        // The token is missing. The place is the end of the last token.
        None => {
            let (_, end) = offsets(text, trim(text));
            (end, end)
        }
    }
}

/// Returns the start and the end of `part` in `text`. `part` must be a part of `text`.
fn offsets(text: &[u8], part: &[u8]) -> (usize, usize) {
    let start = part.as_ptr() as usize - text.as_ptr() as usize;
    (start, start + part.len())
}
