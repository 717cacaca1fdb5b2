//! Reads text: lines of bounded length, tokens between blanks, and numbers that fill their token.
//!
//! Both input files have these rules (specification, section 2). Blanks and tabs separate tokens. A line ends in LF or
//! CRLF. Bytes need not be valid UTF-8.

use std::io::{self, BufRead, Read};

/// Length of the longest line that is accepted, in bytes. A longer line is refused before it is read to its end.
pub const MAX_LINE_BYTES: usize = 1 << 20;

/// Size of the largest input file that is accepted, in bytes. Reading stops there, so an endless input ends in an
/// error.
pub const MAX_FILE_BYTES: u64 = 1 << 30;

/// Calls `visit` with every line of `input`, without its line end (LF or CRLF).
///
/// # Errors
/// The first error that `visit` returns, or an error made from [`io::Error`]. The second kind means that the input
/// cannot be read, that memory is short, that a line is longer than [`MAX_LINE_BYTES`], or that the input is longer
/// than [`MAX_FILE_BYTES`].
pub fn for_each_line<E: From<io::Error>>(
    input: impl BufRead,
    mut visit: impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    let mut input = input.take(MAX_FILE_BYTES + 1);
    let mut line = Vec::new();
    // Room for the longest line, so that too little memory is an error here. Unused pages take no memory.
    line.try_reserve_exact(MAX_LINE_BYTES + 2).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
    let mut total = 0_u64;
    for number in 1_u64.. {
        line.clear();
        let length = (&mut input).take(MAX_LINE_BYTES as u64 + 2).read_until(b'\n', &mut line)?;
        total += length as u64;
        if length == 0 {
            break;
        }
        let content = without_line_end(&line);
        if content.len() > MAX_LINE_BYTES {
            let text = format!("line {number} is longer than {MAX_LINE_BYTES} bytes");
            return Err(io::Error::new(io::ErrorKind::InvalidData, text).into());
        }
        if total > MAX_FILE_BYTES {
            return Err(too_large(MAX_FILE_BYTES).into());
        }
        visit(content)?;
    }
    Ok(())
}

/// The error for an input of more than `limit` bytes.
#[must_use]
pub(crate) fn too_large(limit: u64) -> io::Error {
    io::Error::new(io::ErrorKind::FileTooLarge, format!("it is larger than {limit} bytes"))
}

/// Returns the line without LF, CRLF or CR at its end.
fn without_line_end(line: &[u8]) -> &[u8] {
    let line = line.strip_suffix(b"\n").unwrap_or(line);
    line.strip_suffix(b"\r").unwrap_or(line)
}

/// Whether the byte is a space or a tab, which separate the words of a line.
const fn is_blank(byte: u8) -> bool {
    byte == b' ' || byte == b'\t'
}

/// Returns `text` in a form that a terminal can show safely. A terminal would obey control characters and characters
/// that change the direction of writing. They are shown as escapes such as `\u{1b}`, and bytes that are not UTF-8 as
/// `\x9b`. Tabs stay as they are.
#[must_use]
pub fn escape(text: &[u8]) -> String {
    let mut shown = String::with_capacity(text.len());
    for chunk in text.utf8_chunks() {
        for letter in chunk.valid().chars() {
            if letter != '\t' && (letter.is_control() || turns(letter)) {
                shown.extend(letter.escape_default());
            } else {
                shown.push(letter);
            }
        }
        shown.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    shown
}

/// Whether a terminal may change the direction of writing at this character (Unicode's property `Bidi_Control`).
const fn turns(letter: char) -> bool {
    matches!(letter, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Returns `text` without the blanks and tabs at both ends.
#[must_use]
pub fn trim(text: &[u8]) -> &[u8] {
    let start = text.iter().position(|&byte| !is_blank(byte)).unwrap_or(text.len());
    let end = text.iter().rposition(|&byte| !is_blank(byte)).map_or(start, |last| last + 1);
    &text[start..end]
}

/// Iterates over the tokens of a line, and knows the rest of the line that has not been read.
#[derive(Clone, Debug)]
pub struct Tokens<'a> {
    rest: &'a [u8],
}

impl<'a> Tokens<'a> {
    /// Returns an iterator over the tokens of `line`.
    #[must_use]
    pub const fn new(line: &'a [u8]) -> Self {
        Self { rest: line }
    }

    /// Returns the part of the line that has not been read, without blanks at both ends. The result is empty if no
    /// token is left.
    #[must_use]
    pub(crate) fn rest(&self) -> &'a [u8] {
        trim(self.rest)
    }

    /// Returns the next token as a real number, or `None` if there is no token or [`parse_real`] refuses it.
    pub(crate) fn real(&mut self) -> Option<f64> {
        parse_real(self.next()?)
    }

    /// Returns the next three tokens as real numbers, or `None` if [`Tokens::real`] fails for one of them.
    pub(crate) fn reals(&mut self) -> Option<[f64; 3]> {
        Some([self.real()?, self.real()?, self.real()?])
    }

    /// Returns the next token as a positive integer of at most 64 bits, or `None` if there is no such token.
    pub(crate) fn positive_integer(&mut self) -> Option<u64> {
        parse_positive_integer(self.next()?)
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|&byte| !is_blank(byte))?;
        let rest = &self.rest[start..];
        let length = rest.iter().position(|&byte| is_blank(byte)).unwrap_or(rest.len());
        let (token, rest) = rest.split_at(length);
        self.rest = rest;
        Some(token)
    }
}

/// Returns the value of a token that is a decimal or scientific number, such as `1`, `-2.`, `.25` or `+1e-3`.
///
/// The value is correctly rounded. For any other token the result is `None`: `nan`, `inf`, a hexadecimal number,
/// trailing text, or a value that overflows.
#[must_use]
pub fn parse_real(token: &[u8]) -> Option<f64> {
    // The standard library also reads `inf`, `infinity` and `nan`. All other texts that it reads have no letter but
    // `e`.
    if !token.iter().all(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E')) {
        return None;
    }
    let text = std::str::from_utf8(token).ok()?;
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

/// Returns the value of a token that is a decimal integer in `1..=u64::MAX`. A leading `+` is allowed. For any other
/// token the result is `None`.
#[must_use]
pub fn parse_positive_integer(token: &[u8]) -> Option<u64> {
    let text = std::str::from_utf8(token).ok()?;
    text.parse().ok().filter(|&value| value > 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::BufReader;

    fn lines(input: &[u8]) -> Vec<Vec<u8>> {
        let mut all = Vec::new();
        for_each_line::<io::Error>(input, |line| {
            all.push(line.to_vec());
            Ok(())
        })
        .expect("the input is short and in memory");
        all
    }

    #[test]
    fn lines_end_in_lf_crlf_or_the_end_of_the_file() {
        assert_eq!(lines(b""), Vec::<Vec<u8>>::new());
        assert_eq!(lines(b"a\nb\r\n\nc"), [b"a".to_vec(), b"b".to_vec(), b"".to_vec(), b"c".to_vec()]);
        assert_eq!(lines(b"a\r\r\nb\r"), [b"a\r".to_vec(), b"b".to_vec()]);
    }

    #[test]
    fn an_endless_line_is_refused_within_bounded_memory() {
        let mut input = BufReader::new(io::repeat(0).take(u64::MAX));
        let error = for_each_line::<io::Error>(&mut input, |_| Ok(())).unwrap_err();
        assert_eq!(error.to_string(), "line 1 is longer than 1048576 bytes");
        let read = u64::MAX - input.get_ref().limit();
        assert!(read <= (MAX_LINE_BYTES + 2 + input.capacity()) as u64, "{read} bytes were read");
    }

    #[test]
    fn the_longest_line_is_accepted() {
        let mut text = vec![b'x'; MAX_LINE_BYTES];
        text.extend_from_slice(b"\r\ny");
        let lengths: Vec<usize> = lines(&text).iter().map(Vec::len).collect();
        assert_eq!(lengths, [MAX_LINE_BYTES, 1]);
        text.insert(0, b'x');
        assert!(for_each_line::<io::Error>(&text[..], |_| Ok(())).is_err());
    }

    #[test]
    fn a_file_is_read_up_to_its_limit_and_an_endless_one_refused() {
        struct Endless;
        impl Read for Endless {
            fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
                buffer.fill(b' ');
                buffer.iter_mut().step_by(MAX_LINE_BYTES / 2).for_each(|byte| *byte = b'\n');
                Ok(buffer.len())
            }
        }
        let read = |bytes| {
            let input = BufReader::with_capacity(MAX_LINE_BYTES, Endless.take(bytes));
            for_each_line::<io::Error>(input, |_| Ok(()))
        };
        assert!(read(MAX_FILE_BYTES).is_ok());
        for bytes in [MAX_FILE_BYTES + 1, u64::MAX] {
            let error = read(bytes).unwrap_err();
            assert_eq!(error.to_string(), "it is larger than 1073741824 bytes");
        }
    }

    #[test]
    fn control_characters_and_bytes_that_are_no_text_are_escaped() {
        assert_eq!(escape("a\tb ñ \\ \"x\"".as_bytes()), "a\tb ñ \\ \"x\"");
        assert_eq!(escape(b"\x1b[2Jx\r\n\0\x7f"), r"\u{1b}[2Jx\r\n\u{0}\u{7f}");
        assert_eq!(escape("\u{9b}1m \u{202e} \u{61c}".as_bytes()), r"\u{9b}1m \u{202e} \u{61c}");
        assert_eq!(escape(b"\x9b1m \xff\xc3"), r"\x9b1m \xff\xc3");
    }

    #[test]
    fn tokens_are_separated_by_blanks_and_tabs() {
        let mut tokens = Tokens::new(b" \ta:  1\t2 x y ");
        assert_eq!(tokens.next(), Some(&b"a:"[..]));
        assert_eq!(tokens.real(), Some(1.0));
        assert_eq!(tokens.rest(), b"2 x y");
        assert_eq!(tokens.positive_integer(), Some(2));
        assert_eq!(tokens.reals(), None);
        assert_eq!(Tokens::new(b" \t").next(), None);
        assert_eq!(Tokens::new(b"1 2 3").reals(), Some([1.0, 2.0, 3.0]));
        assert_eq!(Tokens::new(b" ").rest(), b"");
        assert_eq!([trim(b"\t a  b \t"), trim(b"a"), trim(b" \t")], [&b"a  b"[..], b"a", b""]);
    }

    #[test]
    fn reals_are_plain_decimal_or_scientific() {
        for (text, value) in [(".25", 0.25), ("1e-3", 1e-3), ("-2.", -2.0), ("+1", 1.0), ("1E2", 100.0)] {
            assert_eq!(parse_real(text.as_bytes()), Some(value), "{text}");
        }
        let smallest = parse_real(b"1e-400").expect("a number too small to hold rounds to zero");
        assert_eq!(smallest, 0.0);
    }

    #[test]
    fn reals_that_are_not_whole_plain_or_finite_are_refused() {
        for text in ["", "nan", "inf", "-infinity", "0x10", "1.5x", "1e400", ".", "e3", "1e", "--1", "1,5", "1_0"] {
            assert_eq!(parse_real(text.as_bytes()), None, "{text}");
        }
        assert_eq!(parse_real(b"1\0"), None);
        assert_eq!(parse_real(b"\xff"), None);
    }

    #[test]
    fn integers_are_positive_and_whole() {
        assert_eq!(parse_positive_integer(b"+7"), Some(7));
        assert_eq!(parse_positive_integer(b"18446744073709551615"), Some(u64::MAX));
        for text in ["0", "-1", "1.0", "1e3", "18446744073709551616", "", "x", "0x1"] {
            assert_eq!(parse_positive_integer(text.as_bytes()), None, "{text}");
        }
    }
}
