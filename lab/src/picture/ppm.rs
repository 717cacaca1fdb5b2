//! Reads PPM files, P3 and P6, with comments and any white space.

use super::{Picture, check_pixels, with_room};
use crate::format::hint::shown;

const CR_LF: &str = "the header of this P6 ends in CR LF, as the text mode of Windows writes it, and one byte belongs \
                     there; write the file again in binary mode, with LF in the header, or as P3";

/// Returns the picture in the bytes of a PPM file.
pub(super) fn parse(bytes: &[u8]) -> Result<Picture, String> {
    let mut rest = &bytes[2..];
    let [width, height, most] = [number(bytes, &mut rest)?, number(bytes, &mut rest)?, number(bytes, &mut rest)?];
    if most != 255 {
        return Err(format!("a PPM whose largest value is {most}, not 255; pamdepth 255 of netpbm converts it"));
    }
    let count = check_pixels(width.checked_mul(height))?;
    if count == 0 {
        return Err("a PPM without pixels".to_owned());
    }
    let mut pixels;
    if bytes[1] == b'6' {
        // Exactly one white-space byte separates the header from the pixels. After a comment, it is the line end of the
        // comment or the byte behind, so the number of bytes decides.
        let mut comment = rest.trim_ascii_start();
        let has_comment = comment.starts_with(b"#");
        skip_comment(&mut comment);
        let ends_in_blank = |at| comment.get(at - 1).is_some_and(u8::is_ascii_whitespace);
        let after_comment = [1, 2].map(|at| comment.get(at..).filter(|_| has_comment && ends_in_blank(at)));
        let after_number = rest.split_first().filter(|(end, _)| end.is_ascii_whitespace()).map(|(_, data)| data);
        let starts: Vec<&[u8]> = [after_number].into_iter().chain(after_comment).flatten().collect();
        // Some programs end the file in a line end.
        let fits = |data: &&&[u8]| {
            let tail = data.split_at_checked(3 * count).map(|(_, tail)| tail);
            tail.is_some_and(|tail| [&b""[..], b"\n", b"\r\n"].contains(&tail))
        };
        let fitting = starts.iter().find(fits);
        let Some(&data) = fitting.or(starts.first()) else {
            return Err("a PPM whose header does not end in white space".to_owned());
        };
        if rest.starts_with(b"\r\n") && data.len() > 3 * count {
            return Err(CR_LF.to_owned());
        }
        if fitting.is_none() {
            return Err(format!("{} bytes of pixels where {width} x {height} are announced", data.len()));
        }
        pixels = with_room(count)?;
        pixels.extend_from_slice(data[..3 * count].as_chunks().0);
    } else {
        // Each pixel needs at least six bytes, so no more memory is allocated than the file can fill.
        pixels = with_room(count.min(rest.len() / 6 + 1))?;
        for _ in 0..count {
            let mut byte = || {
                let value = number(bytes, &mut rest)?;
                u8::try_from(value).map_err(|_| wrong_word(bytes, rest, "a number up to 255"))
            };
            let pixel = [byte()?, byte()?, byte()?];
            pixels.push(pixel);
        }
        skip(&mut rest);
        if !rest.is_empty() {
            return Err(format!("something follows the {count} pixels"));
        }
    }
    Ok(Picture { width, height, pixels })
}

/// Removes the comment at the start of `rest` up to its line end.
fn skip_comment(rest: &mut &[u8]) {
    let end = rest.iter().position(|byte| b"\r\n".contains(byte)).unwrap_or(rest.len());
    *rest = &rest[end..];
}

/// Removes the white space and the comments at the start of `rest`.
fn skip(rest: &mut &[u8]) {
    *rest = rest.trim_ascii_start();
    while rest.first() == Some(&b'#') {
        skip_comment(rest);
        *rest = rest.trim_ascii_start();
    }
}

/// Reads the next number of a PPM header or of P3 pixels, and removes it from `rest`, the end of `bytes`. White space
/// or a comment must stand before the number.
fn number(bytes: &[u8], rest: &mut &[u8]) -> Result<usize, String> {
    let before = rest.len();
    skip(rest);
    if rest.is_empty() {
        return Err("a PPM that ends before its last number".to_owned());
    }
    let length = rest.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(rest.len());
    let (digits, after) = rest.split_at(length);
    let separated = rest.len() < before;
    *rest = after;
    let number = std::str::from_utf8(digits).ok().and_then(|text| text.parse().ok()).filter(|_| separated);
    let wanted = if digits.is_empty() || !separated { "a whole number" } else { "a smaller number" };
    number.ok_or_else(|| wrong_word(bytes, rest, wanted))
}

/// Returns the message for the word of `bytes` in which or after which `rest`, the end of `bytes`, begins.
fn wrong_word(bytes: &[u8], rest: &[u8], wanted: &str) -> String {
    const SHOWN: usize = 20;
    let before = &bytes[..bytes.len() - rest.len()];
    let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let start = before.iter().rposition(u8::is_ascii_whitespace).map_or(0, |at| at + 1);
    let word = bytes[start..].split(u8::is_ascii_whitespace).next().unwrap_or_default();
    let word = shown(&word[..word.len().min(SHOWN)]);
    format!("line {line} of this PPM has [{word}] where {wanted} belongs")
}
