//! Reads PPM files as netpbm's `ppm(5)` describes them: tokens between white space and comments, then the pixels. Other
//! programs write a comment behind the header of a P6, or a line end behind its pixels; these files are read too.

/// Returns the width, the height and the pixels of a PPM file (P3 or P6) whose largest value is 255. Returns `None` for
/// any other file.
#[must_use]
pub fn ppm(bytes: &[u8]) -> Option<(usize, usize, Vec<[u8; 3]>)> {
    let raw = match bytes.get(..2)? {
        b"P3" => false,
        b"P6" => true,
        _ => return None,
    };
    let mut at = 2;
    let width = number(bytes, &mut at)?;
    let height = number(bytes, &mut at)?;
    if number(bytes, &mut at)? != 255 || width == 0 || height == 0 {
        return None;
    }
    let values = width.checked_mul(height)?.checked_mul(3)?;
    let channels: Vec<u8> = if raw {
        raw_pixels(&bytes[at..], values)?.to_vec()
    } else {
        let mut channels = Vec::new();
        while channels.len() < values {
            channels.push(u8::try_from(number(bytes, &mut at)?).ok()?);
        }
        (skip(bytes, at) == bytes.len()).then_some(())?;
        channels
    };
    if channels.len() != values {
        return None;
    }
    Some((width, height, channels.chunks(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect()))
}

const fn is_white(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0c)
}

/// Returns the pixels of a P6, which has `wanted` bytes of them, from what follows the last number of its header. One
/// byte of white space is between them; with a comment it is the comment's line end, or the byte behind that. The first
/// of these places counts behind which the file has the right length.
fn raw_pixels(rest: &[u8], wanted: usize) -> Option<&[u8]> {
    // A header that ends in CR LF has a byte too many.
    if rest.starts_with(b"\r\n") && rest.len() - 1 > wanted {
        return None;
    }
    let is_white_at = |at: usize| rest.get(at).is_some_and(|&byte| is_white(byte));
    let comment = (0..rest.len()).find(|&at| !is_white_at(at)).filter(|&at| rest[at] == b'#');
    let end = comment.map(|start| end_of_comment(rest, start)).filter(|&end| end < rest.len());
    let first = is_white_at(0).then_some(1);
    let starts = [first, end.map(|end| end + 1), end.filter(|end| is_white_at(end + 1)).map(|end| end + 2)];
    starts.into_iter().flatten().find_map(|start| {
        let (pixels, tail) = rest[start..].split_at_checked(wanted)?;
        matches!(tail, b"" | b"\n" | b"\r\n").then_some(pixels)
    })
}

/// Returns the offset of the line end after the offset `at`, or the length of the text.
fn end_of_comment(bytes: &[u8], at: usize) -> usize {
    (at..bytes.len()).find(|&at| matches!(bytes[at], b'\r' | b'\n')).unwrap_or(bytes.len())
}

/// Returns the offset behind the white space and comments at the offset `at`.
fn skip(bytes: &[u8], mut at: usize) -> usize {
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'#' => at = end_of_comment(bytes, at),
            _ if is_white(byte) => at += 1,
            _ => break,
        }
    }
    at
}

/// Returns the number at the offset `at`, and moves `at` behind it. White space or a comment must stand before the
/// number; otherwise the result is `None`.
fn number(bytes: &[u8], at: &mut usize) -> Option<usize> {
    let start = *at;
    *at = skip(bytes, start);
    if *at == start {
        return None;
    }
    let mut value: Option<usize> = None;
    while let Some(digit) = bytes.get(*at).filter(|byte| byte.is_ascii_digit()) {
        value = Some(value.unwrap_or(0).checked_mul(10)?.checked_add(usize::from(digit - b'0'))?);
        *at += 1;
    }
    value
}
