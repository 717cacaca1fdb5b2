//! Reads PPM files as netpbm's `ppm(5)` describes them: tokens between white space and comments, then the pixels.

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
        // Exactly one byte of white space ends the header, and no comment may follow.
        is_white(*bytes.get(at)?).then_some(())?;
        bytes[at + 1..].to_vec()
    } else {
        let mut channels = Vec::new();
        while channels.len() < values {
            channels.push(u8::try_from(number(bytes, &mut at)?).ok()?);
        }
        if !bytes[at..].iter().all(|&byte| is_white(byte)) {
            return None;
        }
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

/// Returns the number at the offset `at`, and moves `at` behind it. White space or a comment must stand before the
/// number; otherwise the result is `None`.
fn number(bytes: &[u8], at: &mut usize) -> Option<usize> {
    let start = *at;
    loop {
        match bytes.get(*at)? {
            b'#' => {
                while *at < bytes.len() && !matches!(bytes[*at], b'\r' | b'\n') {
                    *at += 1;
                }
            }
            &byte if is_white(byte) => *at += 1,
            _ => break,
        }
    }
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
