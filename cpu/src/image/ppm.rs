//! Writes pictures as PPM text, variant P3 (specification, section 5.3).

use std::io::{self, Write};

use crate::image::Image;

/// Returns the decimal digits of a byte and a blank, and their number. The characters after these are not used.
fn digits_of(byte: usize) -> ([u8; 4], usize) {
    let (digits, mut text) = (byte.to_string(), [b' '; 4]);
    text[..digits.len()].copy_from_slice(digits.as_bytes());
    (text, digits.len() + 1)
}

/// Length of a pixel's longest line in bytes: three times three digits and a blank or line end.
const MAX_LINE: usize = 12;

/// Size in bytes of the buffer whose content is handed to the writer in one call.
const CHUNK: usize = 64 << 10;

/// Writes the picture to `out`: three header lines, then one line for each pixel, row by row.
///
/// # Errors
/// The error that `out` returns.
pub fn write_ppm(image: &impl Image, mut out: impl Write) -> io::Result<()> {
    let size = image.size();
    // The header is written in one piece, so that it is one system call.
    out.write_all(format!("P3\n{} {}\n255\n", size.width(), size.height()).as_bytes())?;
    let texts: [_; 256] = std::array::from_fn(digits_of);
    let mut chunk = [0; CHUNK];
    let mut length = 0;
    for index in 0..size.pixels() {
        if length > CHUNK - MAX_LINE {
            out.write_all(&chunk[..length])?;
            length = 0;
        }
        let color = image.pixel(index);
        for channel in [color.red, color.green, color.blue] {
            let (text, count) = texts[usize::from(channel)];
            chunk[length..length + 4].copy_from_slice(&text);
            length += count;
        }
        chunk[length - 1] = b'\n';
    }
    out.write_all(&chunk[..length])?;
    out.flush()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::Rgb;
    use crate::input::size::Size;
    use crate::layout::aos::AosImage;
    use crate::layout::soa::SoaImage;

    fn write<I: Image>(width: u64, height: u64, colors: impl IntoIterator<Item = [u8; 3]>) -> String {
        let mut image = I::black(Size::new(width, height).expect("small")).expect("small");
        for (index, [red, green, blue]) in colors.into_iter().enumerate() {
            image.set_pixel(index, Rgb { red, green, blue });
        }
        let mut text = Vec::new();
        write_ppm(&image, &mut text).expect("memory takes all bytes");
        String::from_utf8(text).expect("digits and blanks")
    }

    #[test]
    fn the_statements_third_listing_is_written() {
        let colors = [[0, 0, 0], [128; 3], [255; 3], [255, 0, 0], [0, 255, 0], [0, 0, 255]];
        let expected = "P3\n2 3\n255\n0 0 0\n128 128 128\n255 255 255\n255 0 0\n0 255 0\n0 0 255\n";
        assert_eq!(write::<AosImage>(2, 3, colors), expected);
        assert_eq!(write::<SoaImage>(2, 3, colors), expected);
    }

    #[test]
    fn every_value_is_written_in_decimal_over_many_chunks() {
        let colors = (0..256 * 64).map(|index: u32| [index as u8, (index / 7) as u8, (index / 64) as u8]);
        let expected: String = std::iter::once("P3\n256 64\n255\n".to_owned())
            .chain(colors.clone().map(|[red, green, blue]| format!("{red} {green} {blue}\n")))
            .collect();
        assert!(expected.len() > 2 * CHUNK);
        assert_eq!(write::<AosImage>(256, 64, colors.clone()), expected);
        assert_eq!(write::<SoaImage>(256, 64, colors), expected);
    }

    #[test]
    fn bytes_are_handed_over_in_large_pieces() {
        struct Pieces(Vec<usize>);
        impl Write for Pieces {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                self.0.push(bytes.len());
                Ok(bytes.len())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let mut pieces = Pieces(Vec::new());
        let image = AosImage::black(Size::new(300, 300).expect("small")).expect("small");
        write_ppm(&image, &mut pieces).expect("it takes all bytes");
        let large = pieces.0.iter().filter(|&&length| length > CHUNK - 2 * MAX_LINE).count();
        assert_eq!(large, 6 * 300 * 300 / CHUNK, "{:?}", pieces.0);
    }

    #[test]
    fn a_writer_that_fails_is_reported() {
        struct Full;
        impl Write for Full {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                Err(io::ErrorKind::StorageFull.into())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let image = AosImage::black(Size::new(1, 1).expect("small")).expect("small");
        assert_eq!(write_ppm(&image, Full).unwrap_err().kind(), io::ErrorKind::StorageFull);
    }
}
