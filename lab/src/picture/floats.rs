//! Pictures of floating-point numbers: linear light, depths, normals. Reads and writes PFM and NPY.

use std::io::{self, Write};

use cpu::internals::image::quantize::Quantizer;

use super::{Picture, check_pixels, with_room};

/// The gamma that converts between bytes and linear light if no other is given: the default of the configuration.
pub const GAMMA: f64 = 2.2;

/// A picture in memory with one or three channels of `f32`.
#[derive(Clone, Debug, PartialEq)]
pub struct Floats {
    /// Number of pixels in a row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// Number of channels: 1, or 3.
    pub channels: usize,
    /// The channels of each pixel, row by row from the top left.
    pub values: Vec<f32>,
}

impl Floats {
    /// Returns a picture of zeros.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn zeros(width: usize, height: usize, channels: usize) -> Result<Self, String> {
        let count = width * height * channels;
        let mut values = with_room(count)?;
        values.resize(count, 0.0);
        Ok(Self { width, height, channels, values })
    }

    /// Returns the linear light of a picture that was made with `gamma`.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn of(picture: &Picture, gamma: f64) -> Result<Self, String> {
        // The renderer truncates, so a byte stands for the values up to the next byte. The middle of them is taken, but
        // black and white stay as they are.
        let level = |byte| if byte == 0 || byte == 255 { byte as f64 } else { byte as f64 + 0.5 };
        let table: [f32; 256] = std::array::from_fn(|byte| (level(byte) / 255.0).powf(gamma) as f32);
        let mut floats = Self::zeros(picture.width, picture.height, 3)?;
        let bytes = picture.pixels.as_flattened();
        floats.values.iter_mut().zip(bytes).for_each(|(value, &byte)| *value = table[usize::from(byte)]);
        Ok(floats)
    }

    /// Returns the bytes of this linear light by the renderer's rule, for `gamma`.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn to_picture(&self, gamma: f64) -> Result<Picture, String> {
        let quantizer = Quantizer::new(gamma);
        let mut pixels = with_room(self.width * self.height)?;
        pixels.extend(self.values.chunks_exact(self.channels).map(|pixel| {
            let byte = |channel: usize| quantizer.quantize(f64::from(pixel[channel.min(self.channels - 1)]));
            [byte(0), byte(1), byte(2)]
        }));
        Ok(Picture { width: self.width, height: self.height, pixels })
    }

    pub(super) fn write_pfm(&self, mut out: impl Write) -> io::Result<()> {
        let letter = if self.channels == 3 { 'F' } else { 'f' };
        // The negative number stands for little-endian numbers. The last row comes first.
        write!(out, "P{letter}\n{} {}\n-1.0\n", self.width, self.height)?;
        self.values.chunks_exact(self.width * self.channels).rev().try_for_each(|row| write_row(row, &mut out))
    }

    pub(super) fn write_npy(&self, mut out: impl Write) -> io::Result<()> {
        let channels = if self.channels == 3 { ", 3" } else { "" };
        let shape = format!("({}, {}{channels})", self.height, self.width);
        let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}");
        // The header ends in LF, and the numbers start at a multiple of 64.
        let length = (NPY_START + header.len() + 1).next_multiple_of(64) - NPY_START;
        out.write_all(b"\x93NUMPY\x01\0")?;
        out.write_all(&(length as u16).to_le_bytes())?;
        writeln!(out, "{header:<0$}", length - 1)?;
        self.values.chunks_exact(self.width * self.channels).try_for_each(|row| write_row(row, &mut out))
    }
}

/// Length of an NPY file before its header: the magic bytes, the version and the length of the header.
const NPY_START: usize = 10;

fn write_row(row: &[f32], out: &mut impl Write) -> io::Result<()> {
    out.write_all(&row.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>())
}

/// Returns the picture in the bytes of a PFM file.
pub(super) fn from_pfm(bytes: &[u8]) -> Result<Floats, String> {
    const WRONG: &str = "a PFM whose header is damaged";

    let mut rest = &bytes[2..];
    let mut word = || {
        let start = rest.trim_ascii_start();
        let length = start.iter().position(u8::is_ascii_whitespace)?;
        // One white-space byte ends each word, and the numbers follow that of the last one.
        rest = &start[length + 1..];
        str::from_utf8(&start[..length]).ok()
    };
    let (width, height, scale) = (word().ok_or(WRONG)?, word().ok_or(WRONG)?, word().ok_or(WRONG)?);
    let (width, height): (usize, usize) = (width.parse().map_err(|_| WRONG)?, height.parse().map_err(|_| WRONG)?);
    // The sign of the scale tells the order of the bytes, so 0 and NaN have no meaning.
    let scale = scale.parse().ok().filter(|&scale: &f32| scale.abs() > 0.0).ok_or(WRONG)?;
    let channels = if bytes[1] == b'F' { 3 } else { 1 };
    let floats = from_numbers(rest, [width, height, channels], (4, scale < 0.0))?;
    let rows = floats.values.chunks_exact(width * channels).rev();
    Ok(Floats { values: rows.flatten().copied().collect(), ..floats })
}

/// Returns the picture in the bytes of an NPY file: an array of `f4` or `f8` with the shape (height, width) or (height,
/// width, 3).
pub(super) fn from_npy(bytes: &[u8]) -> Result<Floats, String> {
    const WRONG: &str = "an NPY that is no array of f4 or f8 with the shape (height, width) or (height, width, 3)";

    let (start, length) = match *bytes {
        [_, _, _, _, _, _, 1, _, a, b, ..] => (NPY_START, u32::from(u16::from_le_bytes([a, b]))),
        [_, _, _, _, _, _, 2 | 3, _, a, b, c, d, ..] => (NPY_START + 2, u32::from_le_bytes([a, b, c, d])),
        _ => return Err(WRONG.to_owned()),
    };
    let (header, numbers) = bytes[start..].split_at_checked(length as usize).ok_or(WRONG)?;
    let header = str::from_utf8(header).map_err(|_| WRONG)?;
    let field = |name: &str| header.split_once(name).and_then(|(_, rest)| rest.trim_start().strip_prefix(':'));
    let type_of = field("'descr'").and_then(|rest| rest.trim_start().get(1..4)).ok_or(WRONG)?;
    let shape = field("'shape'").and_then(|rest| rest.trim_start().strip_prefix('(')?.split_once(')')).ok_or(WRONG)?.0;
    let shape = shape.split(',').map(str::trim).filter(|side| !side.is_empty()).map(str::parse);
    let shape: Vec<usize> = shape.collect::<Result<_, _>>().map_err(|_| WRONG)?;
    let is_in_rows = field("'fortran_order'").is_some_and(|rest| rest.trim_start().starts_with("False"));
    let size = match type_of {
        "<f4" | ">f4" => 4,
        "<f8" | ">f8" => 8,
        _ => return Err(WRONG.to_owned()),
    };
    let (width, height, channels) = match shape[..] {
        [height, width] => (width, height, 1),
        [height, width, channels @ (1 | 3)] => (width, height, channels),
        _ => return Err(WRONG.to_owned()),
    };
    if !is_in_rows {
        return Err("an NPY in Fortran's order; save numpy.ascontiguousarray(...) instead".to_owned());
    }
    from_numbers(numbers, [width, height, channels], (size, type_of.starts_with('<')))
}

/// Returns the picture of the numbers in `bytes`, each of `size` bytes. Checks that there are as many as the header
/// announces, before memory is taken for them.
fn from_numbers(
    bytes: &[u8],
    [width, height, channels]: [usize; 3],
    (size, is_little): (usize, bool),
) -> Result<Floats, String> {
    let pixels = check_pixels(width.checked_mul(height))?;
    let announced = pixels.checked_mul(channels * size).filter(|&announced| announced > 0 && announced == bytes.len());
    if announced.is_none() {
        return Err(format!("{} bytes of numbers where {width} x {height} pixels are announced", bytes.len()));
    }
    let mut values = with_room(pixels * channels)?;
    values.extend(bytes.chunks_exact(size).map(|number| {
        let mut number: [u8; 8] = std::array::from_fn(|at| number.get(at).copied().unwrap_or(0));
        if !is_little {
            number[..size].reverse();
        }
        let [a, b, c, d, ..] = number;
        if size == 4 { f32::from_le_bytes([a, b, c, d]) } else { f64::from_le_bytes(number) as f32 }
    }));
    Ok(Floats { width, height, channels, values })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::any::{Any, Kind};

    #[test]
    fn every_format_gives_back_what_was_written() {
        for channels in [1, 3] {
            let mut floats = Floats::zeros(3, 2, channels).expect("it is small");
            let values = (0..).map(|at| at as f32 * 0.37 - 1.0).chain([f32::INFINITY]);
            floats.values.iter_mut().zip(values).for_each(|(value, number)| *value = number);
            for kind in [Kind::Pfm, Kind::Npy, Kind::Exr] {
                let mut bytes = Vec::new();
                Any::Floats(floats.clone()).write(kind, GAMMA, &mut bytes).expect("memory takes all bytes");
                assert_eq!(Any::parse(&bytes), Ok(Any::Floats(floats.clone())), "{kind:?}");
                // Whatever is cut off or changed, the result is an error or a picture, and no panic.
                for at in 0..bytes.len() {
                    assert!(Any::parse(&bytes[..at]).is_err(), "{kind:?} {at}");
                    for change in [1, 0x80, 0xff] {
                        let mut damaged = bytes.clone();
                        damaged[at] ^= change;
                        let _ = Any::parse(&damaged);
                    }
                }
            }
        }
    }

    #[test]
    fn arrays_and_maps_of_other_programs_are_read() {
        let big = b"Pf 2 1 1.0\n\x3f\x80\0\0\xbf\x80\0\0";
        let npy = |header: &str, numbers: &[u8]| {
            let length = (header.len() as u32).to_le_bytes();
            [b"\x93NUMPY\x02\0", &length[..], header.as_bytes(), numbers].concat()
        };
        let doubles = [1.0_f64, -1.0].map(f64::to_be_bytes);
        let array = npy("{'descr': '>f8', 'fortran_order': False, 'shape': (1, 2), }", doubles.as_flattened());
        for bytes in [&big[..], &array] {
            let Ok(Any::Floats(floats)) = Any::parse(bytes) else { panic!("{}", bytes.escape_ascii()) };
            assert_eq!((floats.width, &floats.values[..]), (2, &[1.0, -1.0][..]));
        }
        let huge = npy("{'descr':'<f4','fortran_order':False,'shape':(4294967296,4294967296)}", b"");
        let [zero, nan] = ["0", "nan"].map(|scale| [b"Pf 2 1 ", scale.as_bytes(), &big[10..]].concat());
        for bytes in [&huge[..], &huge[..9], &zero, &nan, b"PF 9999999999 9999999999 -1\n", b"PF 0 1 -1\n"] {
            assert!(Any::parse(bytes).is_err(), "{}", bytes.escape_ascii());
        }
    }

    #[test]
    fn bytes_stay_as_they_are_over_linear_light() {
        let pixels = (0..=255).map(|byte| [byte; 3]).collect();
        let picture = Picture { width: 256, height: 1, pixels };
        let linear = Floats::of(&picture, 1.0).expect("it is small");
        assert_eq!([0, 51, 255].map(|byte| linear.values[3 * byte]), [0.0, 51.5 / 255.0, 1.0]);
        let back = Floats::of(&picture, GAMMA).expect("it is small").to_picture(GAMMA).expect("it is small");
        assert_eq!(back, picture);
    }
}
