//! Splits a text in memory into lines and tokens, and reads numbers (specification, section 2).
//!
//! This module checks the grammar of numbers character by character. The standard library only computes the value of a
//! number that passed this check.

/// Returns the lines of a text, each without its LF or CRLF. If the text ends with a line end, no empty line follows.
#[must_use]
pub fn lines(text: &[u8]) -> Vec<&[u8]> {
    let mut lines: Vec<_> = text.split(|&byte| byte == b'\n').collect();
    if lines.last().is_some_and(|last| last.is_empty()) {
        lines.pop();
    }
    lines.into_iter().map(|line| if line.last() == Some(&b'\r') { &line[..line.len() - 1] } else { line }).collect()
}

/// Returns the start and the end of each token of a line, as byte offsets.
#[must_use]
pub fn tokens(line: &[u8]) -> Vec<(usize, usize)> {
    let mut places = Vec::new();
    let mut start = 0;
    for part in line.split(|byte| b" \t".contains(byte)) {
        if !part.is_empty() {
            places.push((start, start + part.len()));
        }
        start += part.len() + 1;
    }
    places
}

/// Returns the value of a real number: an optional sign, digits with at most one point, and an optional exponent.
/// Returns `None` for any other text, and for a value that is not finite.
#[must_use]
pub fn real(token: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(token).ok()?;
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (unsigned, None),
    };
    let digits = |text: &str| text.chars().all(|digit| digit.is_ascii_digit());
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.is_empty() && fraction.is_empty() || !digits(whole) || !digits(fraction) {
        return None;
    }
    if let Some(exponent) = exponent {
        let exponent = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        if exponent.is_empty() || !digits(exponent) {
            return None;
        }
    }
    let value: f64 = text.parse().unwrap_or_else(|_| panic!("the standard library does not read {text:?}"));
    value.is_finite().then_some(value)
}

/// Returns the value of a positive integer of 64 bits: an optional plus sign, and digits. Returns `None` for any other
/// text, for 0, and for a larger value.
#[must_use]
pub fn positive_integer(token: &[u8]) -> Option<u64> {
    let digits = token.strip_prefix(b"+").unwrap_or(token);
    if digits.is_empty() {
        return None;
    }
    let mut value = 0_u64;
    for digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = value.checked_mul(10)?.checked_add(u64::from(digit - b'0'))?;
    }
    (value > 0).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_tokens_are_as_described() {
        assert_eq!(lines(b"a\r\n\nb\r"), [&b"a"[..], b"", b"b"]);
        assert_eq!(lines(b""), Vec::<&[u8]>::new());
        assert_eq!(tokens(b" a:\tbc "), [(1, 3), (4, 6)]);
    }

    #[test]
    fn numbers_are_as_described() {
        for (text, value) in [(".25", 0.25), ("1e-3", 1e-3), ("-2.", -2.0), ("+1", 1.0), ("1E+2", 100.0)] {
            assert_eq!(real(text.as_bytes()), Some(value));
        }
        for text in ["", ".", "+", "e1", "1e", "1e+", "1.2.3", "0x1", "nan", "inf", "1e999", "- 1", "1e1.0"] {
            assert_eq!(real(text.as_bytes()), None, "{text}");
        }
        assert_eq!(positive_integer(b"+18446744073709551615"), Some(u64::MAX));
        for text in ["", "+", "0", "-1", "18446744073709551616", "1.", "++1"] {
            assert_eq!(positive_integer(text.as_bytes()), None, "{text}");
        }
    }
}
