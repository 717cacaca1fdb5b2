//! Pictures of floating-point numbers: linear light, depths, normals.

use std::io::{self, Read, Write};

use cpu::internals::image::quantize::Quantizer;

use super::{Picture, with_room};

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
    /// The channels of each pixel, row by row from the top left. NaN is no number, such as the depth where nothing is
    /// hit.
    pub values: Vec<f32>,
    /// Whether the numbers are depths, which EXR keeps in the channel Z.
    pub is_depth: bool,
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
        Ok(Self { width, height, channels, values, is_depth: false })
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

    /// Returns what is lost when these numbers become bytes: how many are below 0, above 1, or not a number.
    pub fn clipped(&self) -> Option<String> {
        let count = |is_lost: fn(f32) -> bool| self.values.iter().filter(|&&value| is_lost(value)).count();
        let counts = [
            (count(|value| value < 0.0), "below 0 become black"),
            (count(|value| value > 1.0), "above 1 become white"),
            (count(f32::is_nan), "that are NaN become black"),
        ];
        let lost: Vec<_> =
            counts.iter().filter(|(count, _)| *count > 0).map(|(n, what)| format!("{n} {what}")).collect();
        let all = self.values.len();
        let (least, most) = self.range();
        (!lost.is_empty()).then(|| {
            format!("of its {all} numbers, {}; --range LOW,HIGH scales them ({least} to {most})", lost.join(", "))
        })
    }

    /// Whether these numbers are probably no linear light: they have one channel, NaN, clearly negative numbers, or
    /// whole numbers above 1.
    pub fn is_no_light(&self) -> bool {
        let has = |is: fn(f32) -> bool| self.values.iter().any(|&value| is(value));
        let is_whole = || self.values.iter().all(|&value| value.fract() == 0.0) && has(|value| value > 1.0);
        self.channels == 1 || has(f32::is_nan) || has(|value| value < -0.1) || is_whole()
    }

    /// Returns the smallest and the largest finite number, or 0 and 0 without one.
    pub fn range(&self) -> (f32, f32) {
        let finite = || self.values.iter().copied().filter(|value| value.is_finite());
        let least = finite().fold(f32::INFINITY, f32::min);
        if least.is_finite() { (least, finite().fold(least, f32::max)) } else { (0.0, 0.0) }
    }

    /// Returns bytes that are proportional to the numbers: `low` becomes 0, and `high` becomes 255. NaN becomes 0.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn scaled(&self, (low, high): (f64, f64)) -> Result<Picture, String> {
        let byte = |value: f32| (255.0 * (f64::from(value) - low) / (high - low)) as u8;
        self.bytes(byte)
    }

    /// Returns a copy of a part: column, row, width and height.
    ///
    /// # Errors
    /// A message if memory is short, or if the part does not lie within the picture.
    pub fn crop(&self, part: [usize; 4]) -> Result<Self, String> {
        super::within(part, self.width, self.height)?;
        let ([x, y, width, height], channels) = (part, self.channels);
        let mut values = with_room(width * height * channels)?;
        for row in y..y + height {
            values.extend_from_slice(&self.values[(row * self.width + x) * channels..][..width * channels]);
        }
        Ok(Self { width, height, values, channels, is_depth: self.is_depth })
    }

    /// Returns the bytes of this linear light by the renderer's rule, for `gamma`.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn to_picture(&self, gamma: f64) -> Result<Picture, String> {
        let quantizer = Quantizer::new(gamma);
        self.bytes(|value| quantizer.quantize(f64::from(value)))
    }

    /// Returns the picture of a byte for each number.
    fn bytes(&self, byte: impl Fn(f32) -> u8) -> Result<Picture, String> {
        let mut pixels = with_room(self.width * self.height)?;
        let channel = |pixel: &[f32], channel: usize| byte(pixel[channel.min(self.channels - 1)]);
        let color = |pixel: &[f32]| [0, 1, 2].map(|at| channel(pixel, at));
        pixels.extend(self.values.chunks_exact(self.channels).map(color));
        Ok(Picture { width: self.width, height: self.height, pixels })
    }
}

/// Writes the numbers of a row, little-endian, in pieces.
pub(super) fn write_row(row: &[f32], out: &mut impl Write) -> io::Result<()> {
    let mut piece = [[0; 4]; PIECE];
    row.chunks(PIECE).try_for_each(|values| {
        piece.iter_mut().zip(values).for_each(|(bytes, value)| *bytes = value.to_le_bytes());
        out.write_all(piece[..values.len()].as_flattened())
    })
}

/// Reads a number of `size` bytes, at most eight, for each of `values`.
///
/// # Errors
/// The error of `source`, as text.
pub(super) fn fill(
    source: &mut impl Read,
    values: &mut [f32],
    size: usize,
    number: impl Fn(&[u8]) -> f32,
) -> Result<(), String> {
    let mut piece = [0; 8 * PIECE];
    values.chunks_mut(PIECE).try_for_each(|values| {
        let bytes = &mut piece[..values.len() * size];
        source.read_exact(bytes).map_err(|error| error.to_string())?;
        values.iter_mut().zip(bytes.chunks_exact(size)).for_each(|(value, bytes)| *value = number(bytes));
        Ok(())
    })
}

/// How many numbers are read or written at once.
const PIECE: usize = 1 << 10;

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
