//! Limits on a WGSL text, checked before naga reads it.
//!
//! naga reads nested text by recursion, so a deep nesting overflows its stack, and some of its steps take time that
//! grows with the square of the number of tokens. One linear scan bounds both. It overestimates the nesting, because it
//! only counts brackets and operators, and knows nothing else of the grammar.

/// Most tokens of a composition. naga needs less than two seconds for the slowest texts of this length that were found.
pub const MAX_TOKENS: usize = 1 << 16;

/// Most brackets, operators and `else` branches that one statement may nest in each other.
pub const MAX_NESTING: usize = 500;

/// Stack of the thread that naga runs on, in bytes. At both limits naga needed less than 8 MiB in a debug build.
pub const STACK_BYTES: usize = 64 << 20;

/// The place where a text exceeds a limit, and the message about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excess {
    /// Offset of the first token beyond the limit, in bytes.
    pub offset: usize,
    /// The message: what there is too much of, and what to do about it.
    pub message: String,
}

/// Nesting of the statement or expression that a bracket holds.
#[derive(Clone, Copy, Debug, Default)]
struct Level {
    /// Nesting of the part that has been read since the last separator.
    current: usize,
    /// The largest nesting of the parts before that separator.
    largest: usize,
}

impl Level {
    /// Ends the part that is being read. The next part starts with a nesting of zero.
    fn separate(&mut self) {
        self.largest = self.largest.max(self.current);
        self.current = 0;
    }
}

/// Checks that `source` keeps to [`MAX_TOKENS`] and [`MAX_NESTING`].
///
/// # Errors
/// The first place beyond a limit.
pub fn check(source: &str) -> Result<(), Excess> {
    let mut levels = vec![Level::default()];
    // Nesting outside the innermost open bracket.
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
                // A closing bracket too many is no excess: naga reports it.
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

/// The tokens of `source` with their offsets: words, and single bytes of anything else. Blanks and comments are
/// skipped.
fn tokens(source: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
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

/// Block comments nest in WGSL.
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
