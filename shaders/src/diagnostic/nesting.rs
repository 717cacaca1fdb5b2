//! Finds the place where a text is nested too deeply for naga's parser, whose error has no place.

use naga::front::wgsl::{ParseError, parse_str};

use crate::limits::tokens;

/// naga's note about a text that is nested too deeply.
const TOO_DEEP: &str = "Parser recursion limit exceeded";

/// The message for such a text, with what to do.
pub const MESSAGE: &str = "this is nested too deeply for naga; use several statements";

/// Whether naga found the text nested too deeply.
pub fn is_too_deep(error: &ParseError) -> bool {
    error.notes().any(|note| note == TOO_DEEP)
}

/// Returns the offset in bytes of the token at which naga finds `source` nested too deeply. Returns `None` if naga does
/// not.
///
/// The parser reads from left to right, so it fails in the same way for every start of the text that has this token,
/// and in another way for every shorter start. A binary search needs 16 attempts for the longest text.
pub fn place(source: &str) -> Option<usize> {
    let tokens: Vec<_> = tokens(source.as_bytes()).map(|(offset, token)| (offset, offset + token.len())).collect();
    let is_read = |&(_, end): &(usize, usize)| !matches!(parse_str(&source[..end]), Err(error) if is_too_deep(&error));
    tokens.get(tokens.partition_point(is_read)).map(|(offset, _)| *offset)
}
