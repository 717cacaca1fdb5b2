//! Limits on a WGSL text, checked before naga reads it.
//!
//! naga reads nested text by recursion, so deep nesting overflows its stack. Some of its steps take time that grows
//! with the square of the number of tokens. One linear scan here limits both. It overestimates the nesting, because it
//! only counts brackets and operators and does not know the grammar.

/// Largest number of tokens of a composition. naga needs less than two seconds for the slowest texts of this length
/// that were found.
pub const MAX_TOKENS: usize = 1 << 16;

/// Largest number of brackets, operators and `else` branches that may be nested in each other in one statement.
pub const MAX_NESTING: usize = 500;

/// Size in bytes of the stack of the thread on which naga runs. At both limits naga needed less than 8 MiB in a debug
/// build.
pub const STACK_BYTES: usize = 64 << 20;

/// A place where a text exceeds a limit, and the error message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excess {
    /// Offset of the first token beyond the limit, in bytes from the start of the text.
    pub offset: usize,
    /// The message: which limit is exceeded, and what to do.
    pub message: String,
}

/// The nesting of the text inside one open bracket.
#[derive(Clone, Copy, Debug, Default)]
struct Level {
    /// Nesting of the part read since the last separator (`;`, `,` or the end of a block).
    current: usize,
    /// Largest nesting of all parts before that separator.
    largest: usize,
}

impl Level {
    /// Ends the current part. The next part starts with a nesting of 0.
    fn separate(&mut self) {
        self.largest = self.largest.max(self.current);
        self.current = 0;
    }
}

/// Checks that `source` has at most [`MAX_TOKENS`] tokens, and is nested at most [`MAX_NESTING`] deep.
///
/// # Errors
/// The first place that exceeds a limit.
pub fn check(source: &str) -> Result<(), Excess> {
    let mut levels = vec![Level::default()];
    // Sum of the nesting of all levels except the innermost.
    let mut outside = 0;
    let mut after_block = false;
    for (count, (offset, token)) in tokens(source.as_bytes()).enumerate() {
        if count == MAX_TOKENS {
            let message = format!("the module and all that it needs have more than {MAX_TOKENS} tokens; shorten it");
            return Err(Excess { offset, message });
        }
        // `levels` always holds the level of the text outside all brackets.
        let Some(level) = levels.last_mut() else { break };
        // A block ends its statement, unless `else` continues it.
        if std::mem::take(&mut after_block) && token != b"else" {
            level.separate();
        }
        match token {
            [b'(' | b'[' | b'{'] => {
                level.current += 1;
                outside += level.current;
                levels.push(Level::default());
            }
            [end @ (b')' | b']' | b'}')] => {
                level.separate();
                let inner = level.largest;
                // A closing bracket without an opening one is ignored here, because naga reports it.
                if levels.len() > 1 {
                    levels.pop();
                    if let Some(level) = levels.last_mut() {
                        outside -= level.current;
                        level.current += inner;
                    }
                }
                after_block = *end == b'}';
            }
            [b';' | b','] => level.separate(),
            [byte] if byte.is_ascii_punctuation() && !matches!(byte, b'_' | b'@' | b':') => level.current += 1,
            b"else" => level.current += 1,
            _ => {}
        }
        let nesting = outside + levels.last().map_or(0, |level| level.current);
        if nesting > MAX_NESTING {
            let message = format!(
                "more than {MAX_NESTING} brackets, operators or branches are nested in one statement; use several"
            );
            return Err(Excess { offset, message });
        }
    }
    Ok(())
}

/// Returns the tokens of `source` with their offsets. A token is a word, or a single byte that belongs to no word.
/// Blanks and comments are skipped.
pub(crate) fn tokens(source: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            match source.get(at..)? {
                [] => return None,
                [b'/', b'/', ..] => at = end_of_line(source, at),
                [b'/', b'*', ..] => at = end_of_comment(source, at),
                [byte, ..] if byte.is_ascii_whitespace() => at += 1,
                rest => {
                    let is_word = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'_' || !byte.is_ascii();
                    let length = rest.iter().position(|byte| !is_word(byte)).unwrap_or(rest.len()).max(1);
                    at += length;
                    return Some((at - length, &rest[..length]));
                }
            }
        }
    })
}

fn end_of_line(source: &[u8], start: usize) -> usize {
    source[start..].iter().position(|&byte| byte == b'\n').map_or(source.len(), |length| start + length)
}

/// Returns the offset after the block comment that begins at `start`. Block comments can be nested in WGSL.
fn end_of_comment(source: &[u8], start: usize) -> usize {
    let (mut depth, mut at) = (0_usize, start);
    while at < source.len() {
        match source[at..] {
            [b'/', b'*', ..] => (depth, at) = (depth + 1, at + 2),
            [b'*', b'/', ..] => {
                (depth, at) = (depth - 1, at + 2);
                if depth == 0 {
                    return at;
                }
            }
            _ => at += 1,
        }
    }
    source.len()
}

#[cfg(test)]
mod tests;
