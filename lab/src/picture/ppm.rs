//! Reads PPM files, P3 and P6, with comments and any white space.

use super::{Picture, check_pixels, with_room};

const CR_LF: &str = "the header of this P6 ends in CR LF, as the text mode of Windows writes it, and one byte belongs \
                     there; write the file again in binary mode, with LF in the header, or as P3";

/// Returns the picture in the bytes of a PPM file.
pub(super) fn parse(bytes: &[u8]) -> Result<Picture, String> {
    let mut rest = &bytes[2..];
    let [width, height] = [number(&mut rest)?, number(&mut rest)?];
    if number(&mut rest)? != 255 {
        return Err("a PPM whose largest value is not 255".to_owned());
    }
    let count = check_pixels(width.checked_mul(height))?;
    if count == 0 {
        return Err("a PPM without pixels".to_owned());
    }
    let mut pixels;
    if bytes[1] == b'6' {
        // Exactly one white-space byte separates the header from the pixels.
        let Some((true, data)) = rest.split_first().map(|(end, data)| (end.is_ascii_whitespace(), data)) else {
            return Err("a PPM whose header does not end in white space".to_owned());
        };
        let (colors, tail) = data.as_chunks::<3>();
        if colors.len() != count || !tail.is_empty() {
            if rest.starts_with(b"\r\n") && data.len() > 3 * count {
                return Err(CR_LF.to_owned());
            }
            return Err(format!("{} bytes of pixels where {width} x {height} are announced", data.len()));
        }
        pixels = with_room(count)?;
        pixels.extend_from_slice(colors);
    } else {
        // Each pixel needs at least six bytes, so no more memory is allocated than the file can fill.
        pixels = with_room(count.min(rest.len() / 6 + 1))?;
        for _ in 0..count {
            let mut byte = || u8::try_from(number(&mut rest)?).map_err(|_| "a value over 255".to_owned());
            let pixel = [byte()?, byte()?, byte()?];
            pixels.push(pixel);
        }
        if !rest.trim_ascii().is_empty() {
            return Err(format!("something follows the {count} pixels"));
        }
    }
    Ok(Picture { width, height, pixels })
}

/// Reads the next number of a PPM header or of P3 pixels, and removes it from `rest`. White space or a comment must
/// stand before the number.
fn number(rest: &mut &[u8]) -> Result<usize, String> {
    let before = rest.len();
    *rest = rest.trim_ascii_start();
    while rest.first() == Some(&b'#') {
        let end = rest.iter().position(|byte| b"\r\n".contains(byte)).unwrap_or(rest.len());
        *rest = rest[end..].trim_ascii_start();
    }
    let length = rest.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(rest.len());
    let (digits, after) = rest.split_at(length);
    let separated = rest.len() < before;
    *rest = after;
    let number = std::str::from_utf8(digits).ok().and_then(|text| text.parse().ok()).filter(|_| separated);
    number.ok_or_else(|| "a PPM that ends early or has something else where a number belongs".to_owned())
}
