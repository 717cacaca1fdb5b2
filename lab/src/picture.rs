//! Reads and writes pictures of bytes, PPM (P3 and P6) and PNG, and pictures of numbers ([`floats`]): PFM, NPY and EXR.
//!
//! `test_support::p3` is for tests, and accepts only the format that the renderer writes. This module reads any valid
//! PPM file, with comments and any white space, because `compare` gets pictures from other programs.

pub mod any;
mod exr;
pub mod floats;
mod ppm;

use std::io::{self, Cursor, Write};
use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD as STANDARD;
use cpu::{Error, Image, Rgb, Size};

use crate::Failure;
use any::Any;

/// Largest size of a file that is read, in bytes. A P3 file of [`MAX_PIXELS`] pixels without comments is smaller: it
/// needs 12 bytes a pixel.
pub const MAX_FILE_BYTES: u64 = 1 << 30;

/// Largest number of pixels of a picture that is read: 8192 x 8192. The limit is needed because a PNG of a few thousand
/// bytes can announce any number of pixels.
pub const MAX_PIXELS: usize = 1 << 26;

/// The largest factor by which deflate can compress. A PNG whose pixels need more bytes than the file's size times this
/// factor is damaged.
const DEFLATE_GROWTH: usize = 1032;

/// A picture in memory with three channels of 8 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Number of pixels in a row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// Red, green and blue of each pixel, row by row from the top left.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// Reads a picture as [`Any::read`] does. Numbers are taken as linear light.
    ///
    /// # Errors
    /// The errors of [`Any::read`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Ok(Any::read(path)?.into_picture(floats::GAMMA)?)
    }

    /// Returns the picture in the bytes of a file, as [`Picture::read`] does.
    ///
    /// # Errors
    /// The error of the bytes, as text.
    pub fn parse(bytes: &[u8]) -> Result<Self, String> {
        Any::parse(bytes)?.into_picture(floats::GAMMA)
    }

    /// Returns a copy of an image that the renderer made.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn of(image: &impl Image) -> Result<Self, Error> {
        let size = image.size();
        let pixel = |index| {
            let Rgb { red, green, blue } = image.pixel(index);
            [red, green, blue]
        };
        let mut pixels = with_room(size.pixels()).map_err(|_| Error::OutOfMemory { what: "the picture" })?;
        pixels.extend((0..size.pixels()).map(pixel));
        Ok(Self { width: size.width(), height: size.height(), pixels })
    }

    /// Returns a copy of the part of the picture that starts at column `x` and row `y`.
    ///
    /// # Panics
    /// If the part does not lie within the picture.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn crop(&self, [x, y, width, height]: [usize; 4]) -> Result<Self, Error> {
        let mut pixels =
            with_room(width * height).map_err(|_| Error::OutOfMemory { what: "the part of the picture" })?;
        for row in self.pixels.chunks(self.width).skip(y).take(height) {
            pixels.extend_from_slice(&row[x..x + width]);
        }
        assert_eq!(pixels.len(), width * height, "the part lies within the picture");
        Ok(Self { width, height, pixels })
    }

    /// Returns the picture as the [`data_uri`] of a PNG.
    ///
    /// # Errors
    /// An error if the picture is too large for a PNG.
    pub fn address(&self) -> io::Result<String> {
        let mut png = Vec::new();
        self.write_png(&mut png)?;
        Ok(data_uri(&png))
    }

    /// Writes the picture to `out` in the format PNG.
    ///
    /// # Errors
    /// An error of `out`.
    pub fn write_png(&self, out: impl Write) -> io::Result<()> {
        let mut writer = png_encoder(out, [self.width, self.height])?.write_header()?;
        // Writes pieces of [`PIECE`] bytes, so that the whole compressed picture is never in memory.
        let mut stream = writer.stream_writer_with_size(PIECE)?;
        stream.write_all(self.pixels.as_flattened())?;
        stream.finish()?;
        Ok(writer.finish()?)
    }

    /// Writes the picture to `out` in the format PPM (P3), as the renderer does.
    ///
    /// # Errors
    /// An error of `out`.
    pub fn write_ppm(&self, out: impl Write) -> io::Result<()> {
        let explain = |error: cpu::internals::input::error::Picture| io::Error::other(error.to_string());
        let size = Size::new(self.width as u64, self.height as u64).map_err(explain)?;
        let mut image = cpu::internals::layout::aos::AosImage::black(size).map_err(io::Error::other)?;
        for (index, &[red, green, blue]) in self.pixels.iter().enumerate() {
            image.set_pixel(index, Rgb { red, green, blue });
        }
        cpu::internals::image::ppm::write_ppm(&image, out)
    }
}

/// Returns an encoder for a PNG of this width and height, with three channels of 8 bits.
///
/// # Errors
/// An error if the picture is too large for a PNG.
pub fn png_encoder<'a, W: Write + 'a>(out: W, size: [usize; 2]) -> io::Result<png::Encoder<'a, W>> {
    let [width, height] = size.map(|pixels| u32::try_from(pixels).map_err(io::Error::other));
    let mut encoder = png::Encoder::new(out, width?, height?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    Ok(encoder)
}

/// Returns the data URI of the bytes of a PNG: an address with the picture itself, in base 64, for an HTML page.
pub fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// Number of bytes of the compressed picture that are written at once.
const PIECE: usize = 1 << 16;

/// Returns an empty list with room for `count` items, or an error message if memory is short.
pub(crate) fn with_room<T>(count: usize) -> Result<Vec<T>, String> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| "not enough memory for the picture".to_owned())?;
    Ok(list)
}

/// Returns the number of pixels that a picture's header announces, or an error if it is more than [`MAX_PIXELS`].
/// `None` stands for a number that does not fit in a `usize`.
fn check_pixels(announced: Option<usize>) -> Result<usize, String> {
    let is_allowed = |count: &usize| *count <= MAX_PIXELS;
    announced.filter(is_allowed).ok_or_else(|| format!("it has more than {MAX_PIXELS} pixels"))
}

fn from_png(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    // The size is checked before memory is allocated for the pixels, because a few bytes can announce a picture of any
    // size.
    let info = reader.info();
    check_pixels((info.width as usize).checked_mul(info.height as usize))?;
    if reader.output_color_type().1 != png::BitDepth::Eight {
        return Err("a PNG of more than 8 bits a channel".to_owned());
    }
    let announced = reader.info().raw_bytes();
    if announced > bytes.len().saturating_mul(DEFLATE_GROWTH) {
        return Err(format!("a PNG that announces {announced} bytes of pixels and cannot hold them"));
    }
    // png 0.18.1 panics on a palette whose length is no multiple of 3.
    if reader.info().palette.as_ref().is_some_and(|palette| palette.len() % 3 != 0) {
        return Err("a PNG whose palette ends within a colour".to_owned());
    }
    let length = reader.output_buffer_size().ok_or("too large a PNG")?;
    let mut buffer = with_room(length)?;
    buffer.resize(length, 0);
    let frame = reader.next_frame(&mut buffer).map_err(|error| error.to_string())?;
    let samples = frame.color_type.samples();
    let colors = buffer[..frame.buffer_size()].chunks_exact(samples);
    let mut pixels = with_room(colors.len())?;
    pixels.extend(colors.map(|channels| match *channels {
        [red, green, blue, ..] => [red, green, blue],
        [grey, ..] => [grey; 3],
        [] => [0; 3],
    }));
    Ok(Picture { width: frame.width as usize, height: frame.height as usize, pixels })
}

#[cfg(test)]
mod tests;
