//! Pictures from files, whoever wrote them: PPM (P3 and P6) and PNG.
//!
//! `tests::p3` accepts what the renderer writes and nothing else, which is right for a test; a comparison must take any
//! valid picture, so this reader follows the PPM format with its comments and free white space.

use std::fs;
use std::io::{self, Cursor, Write};
use std::path::Path;

use cpu::{Image, Rgb, Size};

use crate::Failure;

/// A picture of bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green and blue, row by row from the top left.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// The picture in a file; its first bytes say what it is.
    ///
    /// # Errors
    /// The file cannot be read, or is neither PPM nor an 8-bit PNG.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        Self::parse(&bytes).map_err(|reason| format!("{}: {reason}", path.display()).into())
    }

    /// The picture that `bytes` are the file of.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn parse(bytes: &[u8]) -> Result<Self, String> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => from_png(bytes),
            [b'P', b'3' | b'6', ..] => from_ppm(bytes),
            _ => Err("neither PPM (P3 or P6) nor PNG".to_owned()),
        }
    }

    /// What the renderer made.
    #[must_use]
    pub fn of(image: &impl Image) -> Self {
        let size = image.size();
        let pixel = |index| {
            let Rgb { red, green, blue } = image.pixel(index);
            [red, green, blue]
        };
        Self { width: size.width(), height: size.height(), pixels: (0..size.pixels()).map(pixel).collect() }
    }

    /// The part of it that starts at column `x`, row `y`.
    ///
    /// # Panics
    /// When it goes beyond the picture.
    #[must_use]
    pub fn crop(&self, [x, y, width, height]: [usize; 4]) -> Self {
        let rows = self.pixels.chunks(self.width).skip(y).take(height);
        let pixels: Vec<_> = rows.flat_map(|row| row[x..x + width].iter().copied()).collect();
        assert_eq!(pixels.len(), width * height, "the part lies within the picture");
        Self { width, height, pixels }
    }

    /// Writes it as PNG.
    ///
    /// # Errors
    /// What `out` returns.
    pub fn write_png(&self, out: impl Write) -> io::Result<()> {
        let side = |pixels: usize| u32::try_from(pixels).map_err(io::Error::other);
        let mut encoder = png::Encoder::new(out, side(self.width)?, side(self.height)?);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        Ok(writer.finish()?)
    }

    /// Writes it as the renderer writes PPM.
    ///
    /// # Errors
    /// What `out` returns.
    pub fn write_ppm(&self, out: impl Write) -> io::Result<()> {
        let explain = |error: cpu::error::Picture| io::Error::other(error.to_string());
        let size = Size::new(self.width as u64, self.height as u64).map_err(explain)?;
        let mut image = cpu::layout::AosImage::black(size).map_err(io::Error::other)?;
        for (index, &[red, green, blue]) in self.pixels.iter().enumerate() {
            image.set_pixel(index, Rgb { red, green, blue });
        }
        cpu::ppm::write_ppm(&image, out)
    }
}

fn from_png(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    let mut buffer = vec![0; reader.output_buffer_size().ok_or("too large a PNG")?];
    let frame = reader.next_frame(&mut buffer).map_err(|error| error.to_string())?;
    if frame.bit_depth != png::BitDepth::Eight {
        return Err("a PNG of more than 8 bits a channel".to_owned());
    }
    let samples = frame.color_type.samples();
    let pixels = buffer[..frame.buffer_size()].chunks_exact(samples);
    let pixel = |channels: &[u8]| match *channels {
        [red, green, blue, ..] => [red, green, blue],
        [grey, ..] => [grey; 3],
        [] => [0; 3],
    };
    Ok(Picture { width: frame.width as usize, height: frame.height as usize, pixels: pixels.map(pixel).collect() })
}

fn from_ppm(bytes: &[u8]) -> Result<Picture, String> {
    let mut rest = &bytes[2..];
    let [width, height] = [number(&mut rest)?, number(&mut rest)?];
    if number(&mut rest)? != 255 {
        return Err("a PPM whose largest value is not 255".to_owned());
    }
    let count = width.checked_mul(height).filter(|&count| count > 0).ok_or("a PPM of no possible size")?;
    let pixels = if bytes[1] == b'6' {
        // One white-space byte ends the header.
        let data = rest.get(1..).unwrap_or_default();
        let (pixels, tail) = data.as_chunks::<3>();
        if pixels.len() != count || !tail.is_empty() {
            return Err(format!("{} bytes of pixels where {width} x {height} are announced", data.len()));
        }
        pixels.to_vec()
    } else {
        // Each pixel takes at least six bytes: a size that lies is found before memory is taken for it.
        let mut pixels = Vec::with_capacity(count.min(rest.len() / 6 + 1));
        for _ in 0..count {
            let mut byte = || u8::try_from(number(&mut rest)?).map_err(|_| "a value over 255".to_owned());
            pixels.push([byte()?, byte()?, byte()?]);
        }
        if !rest.trim_ascii().is_empty() {
            return Err(format!("something follows the {count} pixels"));
        }
        pixels
    };
    Ok(Picture { width, height, pixels })
}

/// The next number of a PPM header or of P3 pixels, after white space and comments.
fn number(rest: &mut &[u8]) -> Result<usize, String> {
    *rest = rest.trim_ascii_start();
    while rest.first() == Some(&b'#') {
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        *rest = rest[end..].trim_ascii_start();
    }
    let length = rest.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(rest.len());
    let (digits, after) = rest.split_at(length);
    *rest = after;
    let text = std::str::from_utf8(digits).unwrap_or_default();
    text.parse().map_err(|_| "a PPM that ends early or has something else where a number belongs".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &[u8] = b"P3\n2 2\n255\n0 0 0\n1 2 3\n255 255 255\n10 20 30\n";

    fn sample() -> Picture {
        Picture { width: 2, height: 2, pixels: vec![[0; 3], [1, 2, 3], [255; 3], [10, 20, 30]] }
    }

    #[test]
    fn all_formats_hold_the_same_picture() {
        let mut png = Vec::new();
        sample().write_png(&mut png).expect("memory takes all bytes");
        let raw = b"P6 2 2 255\n\0\0\0\x01\x02\x03\xff\xff\xff\x0a\x14\x1e";
        let free = b"P3 # made by hand\n2\t2 # size\n255 0 0 0 1 2 3\n\n255 255 255 10 20 30";
        for bytes in [TEXT, &png, raw, free] {
            assert_eq!(Picture::parse(bytes), Ok(sample()));
        }
    }

    #[test]
    fn ppm_is_written_as_the_renderer_writes_it() {
        let mut text = Vec::new();
        sample().write_ppm(&mut text).expect("memory takes all bytes");
        assert_eq!(text, TEXT);
        let strict = ::tests::p3::read(&text).expect("it is well formed");
        assert_eq!(strict.pixels, sample().pixels);
    }

    #[test]
    fn damaged_pictures_are_refused() {
        let texts: [&[u8]; 8] = [
            b"",
            b"P3\n",
            b"P3 2 2 255 0 0 0",
            b"P3 1 1 255 0 0 256",
            b"P3 1 1 255 0 0 0 0",
            b"P3 0 0 255",
            b"P3 1 1 65535 0 0 0",
            b"P6 1 1 255\n\0\0",
        ];
        for bytes in texts {
            assert!(Picture::parse(bytes).is_err(), "{}", bytes.escape_ascii());
        }
        assert!(Picture::parse(b"P3 99999999999 9999999 255 0").is_err(), "a size that lies takes no memory");
        assert!(Picture::parse(b"\x89PNG\r\n\x1a\nrest").is_err());
    }

    #[test]
    fn a_part_is_cut_out_row_by_row() {
        let right = Picture { width: 1, height: 2, pixels: vec![[1, 2, 3], [10, 20, 30]] };
        assert_eq!(sample().crop([1, 0, 1, 2]), right);
        assert_eq!(sample().crop([0, 0, 2, 2]), sample());
    }
}
