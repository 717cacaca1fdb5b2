//! A strict reader of PPM files in the variant P3 (specification, section 5.3). The file must have three header lines
//! and then one pixel a line, with single blanks and LF line ends. It must have no leading zeros, no comments, and
//! nothing after the last pixel.

/// The content of a P3 file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Number of pixels in a row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// Red, green and blue of each pixel, row by row from the top left.
    pub pixels: Vec<[u8; 3]>,
}

/// Returns the picture in the bytes of a P3 file.
///
/// ```
/// let picture = test_support::p3::read(b"P3\n2 1\n255\n0 0 0\n255 128 0\n")?;
/// assert_eq!((picture.width, picture.height, picture.pixels[1]), (2, 1, [255, 128, 0]));
/// # Ok::<(), String>(())
/// ```
///
/// # Errors
/// A message that names the first line that differs from the format.
pub fn read(bytes: &[u8]) -> Result<Picture, String> {
    let text = std::str::from_utf8(bytes).map_err(|error| error.to_string())?;
    // Every other spelling of the same numbers differs from the text that is written below.
    let numbers: Vec<usize> = text.split_ascii_whitespace().skip(1).map_while(|word| word.parse().ok()).collect();
    let [width, height, _, channels @ ..] = &numbers[..] else { return Err("the header is incomplete".to_owned()) };
    let byte = |&channel: &usize| u8::try_from(channel).map_err(|_| format!("{channel} is over 255"));
    let channels = channels.iter().map(byte).collect::<Result<Vec<_>, String>>()?;
    let (pixels, rest) = channels.as_chunks::<3>();
    let lines: String = pixels.iter().map(|[red, green, blue]| format!("{red} {green} {blue}\n")).collect();
    let expected = format!("P3\n{width} {height}\n255\n{lines}");
    if text != expected {
        let same = expected.split('\n').zip(text.split('\n')).take_while(|(one, other)| one == other).count();
        return Err(format!("line {} is not as it should be", same + 1));
    }
    if *width == 0 || width.checked_mul(*height) != Some(pixels.len()) || !rest.is_empty() {
        return Err(format!("{} pixels where {width} x {height} are announced", pixels.len()));
    }
    Ok(Picture { width: *width, height: *height, pixels: pixels.to_vec() })
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "P3\n2 2\n255\n0 0 0\n1 2 3\n255 255 255\n10 20 30\n";

    #[test]
    fn every_departure_from_the_format_is_noticed() {
        let departures = [
            ("P3", "P6"),
            ("255\n0", "65535\n0"),
            ("2 2", "2  2"),
            ("2 2", "2 3"),
            ("2 2", "0 4"),
            ("2 2", "4"),
            ("1 2 3", "1 2"),
            ("1 2 3", "1 2 3 "),
            ("1 2 3", "1 2 03"),
            ("1 2 3", "+1 2 3"),
            ("1 2 3", "1 2 256"),
            ("1 2 3", "1 2 3\r"),
            ("1 2 3", "# 1 2 3"),
            ("20 30\n", "20 30"),
            ("20 30\n", "20 30\n\n"),
        ];
        for (good, bad) in departures {
            let text = GOOD.replacen(good, bad, 1);
            assert_ne!(text, GOOD);
            assert!(read(text.as_bytes()).is_err(), "{text:?}");
        }
        assert!(read(GOOD.as_bytes()).is_ok_and(|picture| picture.pixels[2] == [255; 3]));
        assert!(read(b"").is_err() && read(b"P3\n").is_err() && read(b"\xff\n").is_err());
    }
}
