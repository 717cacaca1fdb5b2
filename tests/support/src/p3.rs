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
/// A message about the first difference from the format, with the line number if it is in a line.
pub fn read(bytes: &[u8]) -> Result<Picture, String> {
    let text = std::str::from_utf8(bytes).map_err(|error| error.to_string())?;
    let body = text.strip_suffix('\n').ok_or("the last line does not end")?;
    let mut lines = body.split('\n').enumerate();
    let mut next = |what: &str| lines.next().ok_or(format!("the file ends before {what}"));
    expect_line(next("its magic number")?, "P3")?;
    let [width, height] = numbers::<2>(next("its size")?)?;
    expect_line(next("its largest value")?, "255")?;
    let pixels = lines
        .map(|line| {
            let channels = numbers::<3>(line)?;
            let byte = |value| u8::try_from(value).map_err(|_| format!("line {}: {value} is over 255", line.0 + 1));
            Ok([byte(channels[0])?, byte(channels[1])?, byte(channels[2])?])
        })
        .collect::<Result<Vec<_>, String>>()?;
    if width == 0 || width.checked_mul(height) != Some(pixels.len()) {
        return Err(format!("{} pixels where {width} x {height} are announced", pixels.len()));
    }
    Ok(Picture { width, height, pixels })
}

fn expect_line((index, line): (usize, &str), expected: &str) -> Result<(), String> {
    if line == expected { Ok(()) } else { Err(format!("line {}: {line:?} instead of {expected:?}", index + 1)) }
}

/// Returns the `N` numbers of a line. They must be separated by single blanks, without leading zeros or signs.
fn numbers<const N: usize>((index, line): (usize, &str)) -> Result<[usize; N], String> {
    let values: Vec<usize> = line.split(' ').filter_map(|token| token.parse().ok()).collect();
    let spelled: Vec<String> = values.iter().map(usize::to_string).collect();
    match <[usize; N]>::try_from(values) {
        Ok(values) if spelled.join(" ") == line => Ok(values),
        _ => Err(format!("line {}: {line:?} instead of {N} numbers", index + 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "P3\n2 2\n255\n0 0 0\n1 2 3\n255 255 255\n10 20 30\n";

    #[test]
    fn a_picture_is_read_row_by_row() {
        let picture = read(GOOD.as_bytes()).expect("it is well formed");
        assert_eq!((picture.width, picture.height), (2, 2));
        assert_eq!(picture.pixels, [[0, 0, 0], [1, 2, 3], [255, 255, 255], [10, 20, 30]]);
    }

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
        assert!(read(b"").is_err() && read(b"P3\n").is_err() && read(b"\xff\n").is_err());
    }
}
