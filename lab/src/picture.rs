//! Reads and writes pictures of bytes, PPM (P3 and P6) and PNG, and pictures of numbers ([`floats`]): PFM, NPY and EXR.
//!
//! `test_support::p3` is for tests, and accepts only the format that the renderer writes. This module reads any valid
//! PPM file, with comments and any white space, because `compare` gets pictures from other programs.

pub mod any;
mod exr;
pub mod floats;
mod npy;
mod pfm;
pub mod png;
mod ppm;

use std::io;
use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD as STANDARD;
use cpu::{Error, Image, Rgb};

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
const DEFLATE_GROWTH: u64 = 1032;

/// What some programs write behind the last byte of a picture.
const LINE_ENDS: [&[u8]; 3] = [b"", b"\n", b"\r\n"];

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
        let (width, height) = (image.size().width(), image.size().height());
        let pixels = with_room(width * height).map_err(|_| Error::OutOfMemory { what: "the picture" })?;
        Ok(Self::part([0, 0, width, height], width, pixels, Self::pixels_of(image)))
    }

    /// Returns the part of a picture of `width` pixels that starts at column `x` and row `y`. `pixel` returns the pixel
    /// at an index, and `pixels` is empty. Call `with_room` for it before long work.
    pub fn part(
        [x, y, part_width, height]: [usize; 4],
        width: usize,
        mut pixels: Vec<[u8; 3]>,
        pixel: impl Fn(usize) -> [u8; 3],
    ) -> Self {
        let row = |row: usize| (row * width + x)..(row * width + x + part_width);
        pixels.extend((y..y + height).flat_map(row).map(pixel));
        Self { width: part_width, height, pixels }
    }

    /// Returns a function that gives the pixels of an image that the renderer made.
    pub fn pixels_of(image: &impl Image) -> impl Fn(usize) -> [u8; 3] {
        |index| {
            let Rgb { red, green, blue } = image.pixel(index);
            [red, green, blue]
        }
    }

    /// Returns a copy of the part of the picture that starts at column `x` and row `y`.
    ///
    /// # Errors
    /// A message if memory is short, or if the part does not lie within the picture.
    pub fn crop(&self, part: [usize; 4]) -> Result<Self, String> {
        within(part, self.width, self.height)?;
        Ok(Self::part(part, self.width, with_room(part[2] * part[3])?, |index| self.pixels[index]))
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
}

/// Returns the data URI of the bytes of a PNG: an address with the picture itself, in base 64, for an HTML page.
pub fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// Memory in bytes that large allocations leave free, for the small ones that follow and cannot fail with a message.
const SPARE: usize = 1 << 24;

/// Returns an empty list with room for `count` items.
///
/// # Errors
/// A message if memory is short, or if less than [`SPARE`] bytes would be left.
pub(crate) fn with_room<T>(count: usize) -> Result<Vec<T>, String> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| NO_MEMORY.to_owned())?;
    // Short lists are taken from the spare memory of a long one.
    if count.saturating_mul(size_of::<T>()) >= SPARE {
        spare(0)?
    }
    Ok(list)
}

/// Refuses to go on if `bytes` and [`SPARE`] bytes more cannot be allocated. Call it before libraries that do not
/// report too little memory.
///
/// # Errors
/// A message.
pub(crate) fn spare(bytes: usize) -> Result<(), String> {
    let mut list = Vec::<u8>::new();
    let reserved = list.try_reserve_exact(bytes.saturating_add(SPARE));
    // Otherwise the compiler may leave out the allocation.
    std::hint::black_box(&list);
    reserved.map_err(|_| NO_MEMORY.to_owned())
}

const NO_MEMORY: &str = "not enough memory for the picture; choose a smaller one, or allow more by ulimit -v";

/// Checks that the part (column, row, width, height) lies within a picture of `width` x `height` pixels.
///
/// # Errors
/// A message that names the option.
pub(crate) fn within([x, y, part_width, part_height]: [usize; 4], width: usize, height: usize) -> Result<(), String> {
    let is_within = |start: usize, length: usize, all| start.checked_add(length).is_some_and(|end| end <= all);
    if is_within(x, part_width, width) && is_within(y, part_height, height) {
        return Ok(());
    }
    Err(format!("--crop goes beyond the picture of {width} x {height} pixels"))
}

/// Reads the part of a picture in a text: its column, row, width and height.
///
/// # Errors
/// A message that says what is needed.
pub(crate) fn parse_crop(text: &str) -> Result<[usize; 4], String> {
    let numbers: Option<Vec<usize>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let part = numbers.and_then(|numbers| <[usize; 4]>::try_from(numbers).ok());
    part.filter(|[.., width, height]| *width > 0 && *height > 0)
        .ok_or_else(|| "four numbers are needed, COLUMN,ROW,WIDTH,HEIGHT, the last two positive".to_owned())
}

/// Returns the number of pixels that a picture's header announces, or an error if it is more than [`MAX_PIXELS`].
/// `None` stands for a number that does not fit in a `usize`.
fn check_pixels(announced: Option<usize>) -> Result<usize, String> {
    let is_allowed = |count: &usize| *count <= MAX_PIXELS;
    announced.filter(is_allowed).ok_or_else(|| format!("it has more than {MAX_PIXELS} pixels"))
}

#[cfg(test)]
mod tests;
