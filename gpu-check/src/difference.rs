//! Compares the linear colours of two pictures: the size of the differences, and the number of pixels that differ. It
//! can also draw the differences.

use std::fmt;
use std::path::{Path, PathBuf};

use cpu::Size;
use cpu::Vec3;
use output::{Options, Output};

use crate::shader_lab::png::encoded;
use crate::{Error, Float};

/// The differences between two pictures, in linear channels (1 is white).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Number of compared pixels.
    pub pixels: usize,
    /// Number of pixels in which a channel has different bits. If the precisions differ, values are compared instead of
    /// bits.
    pub differing: usize,
    /// Root of the mean square of the differences of all channels.
    pub rmse: f64,
    /// The largest difference of any channel.
    pub largest: f64,
}

/// Returns the difference of two channels: 0 if both are NaN, infinity if only one is NaN.
fn distance(one: f64, other: f64) -> f64 {
    match (one.is_nan(), other.is_nan()) {
        (true, true) => 0.0,
        (false, false) => (one - other).abs(),
        _ => f64::INFINITY,
    }
}

/// Returns the index of the first pixel in which a channel has different bits.
#[must_use]
pub fn first_differing<T: Float>(pixels: &[Vec3<T>], others: &[Vec3<T>]) -> Option<usize> {
    let channels = |pixel: &Vec3<T>| pixel.to_array();
    let differ = |(one, other): (&Vec3<T>, &Vec3<T>)| {
        channels(one).into_iter().zip(channels(other)).any(|(one, other)| !one.same(other))
    };
    pixels.iter().zip(others).position(differ)
}

/// Returns the differences between two pictures of equal size.
///
/// # Panics
/// If the pictures have different numbers of pixels.
#[must_use]
pub fn difference<A: Float, B: Float>(one: &[Vec3<A>], other: &[Vec3<B>]) -> Difference {
    assert_eq!(one.len(), other.len(), "pictures of one size are compared");
    let mut result = Difference { pixels: one.len(), ..Difference::default() };
    let mut squares = 0.0;
    for (a, b) in one.iter().zip(other) {
        let mut differs = false;
        for (a, b) in a.to_array().into_iter().zip(b.to_array()) {
            let apart = distance(a.wide(), b.wide());
            differs |= apart != 0.0 || (A::PRECISION == B::PRECISION && a.bits() != b.bits() && !a.wide().is_nan());
            squares += apart * apart;
            result.largest = result.largest.max(apart);
        }
        result.differing += usize::from(differs);
    }
    result.rmse = (squares / (3 * one.len()).max(1) as f64).sqrt();
    result
}

/// Returns three pictures in one, below each other: the picture `one`, the picture `other`, and the magnitude of their
/// difference, multiplied by 20.
#[must_use]
pub fn three_parts<A: Float, B: Float>(one: &[Vec3<A>], other: &[Vec3<B>]) -> Vec<[u8; 3]> {
    const ENLARGED: f64 = 20.0;
    let byte = |channel: f64| (255.0 * channel.max(0.0).sqrt()) as u8;
    let apart = one.iter().zip(other).map(|(a, b)| {
        let (a, b) = (a.to_array(), b.to_array());
        std::array::from_fn(|channel| byte(distance(a[channel].wide(), b[channel].wide()) * ENLARGED))
    });
    let mut pixels: Vec<[u8; 3]> = Vec::with_capacity(3 * one.len());
    pixels.extend(one.iter().map(|color| color.to_array().map(|channel| byte(channel.wide()))));
    pixels.extend(other.iter().map(|color| color.to_array().map(|channel| byte(channel.wide()))));
    pixels.extend(apart);
    pixels
}

/// Writes the picture of [`three_parts`] into the folder `folder`, and returns its path. If the folder does not exist,
/// it is created.
///
/// # Errors
/// [`Error::File`] if the folder cannot be created, or if the picture is too large for a PNG; [`Error::Output`] if the
/// picture cannot be written.
pub fn write_png<A: Float, B: Float>(
    folder: &Path,
    name: &str,
    size: Size,
    one: &[Vec3<A>],
    other: &[Vec3<B>],
) -> Result<PathBuf, Error> {
    let tame: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    let path = folder.join(format!("{}.png", tame.trim_matches('-')));
    let failed = |cause| Error::File { path: path.clone(), cause };
    std::fs::create_dir_all(folder).map_err(failed)?;
    let bytes = encoded(&path, size.width(), &three_parts(one, other)).map_err(failed)?;
    Output::open(&path, Options::default())?.fill(|file| file.write_all(&bytes))?;
    Ok(path)
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, differing, rmse, largest } = self;
        write!(f, "{differing} of {pixels} pixels differ, RMSE {rmse:.1e}, at most {largest:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_measured() {
        let one = [Vec3::new(0.5, 0.5, 0.5), Vec3::new(f64::NAN, 0.0, 0.0)];
        assert_eq!(difference(&one, &one), Difference { pixels: 2, ..Difference::default() });
        let other = [Vec3::new(0.5, 0.5, 0.8), Vec3::new(f64::NAN, -0.0, 0.0)];
        let found = difference(&one, &other);
        assert_eq!((found.pixels, found.differing), (2, 2), "a zero's sign counts");
        assert!((found.largest - 0.3).abs() < 1e-15 && (found.rmse - (0.09_f64 / 6.0).sqrt()).abs() < 1e-15);
        let not_a_number = [one[0], Vec3::ONE];
        assert_eq!(difference(&one, &not_a_number).largest, f64::INFINITY);
    }

    #[test]
    fn a_picture_of_the_difference_is_written() {
        let folder = std::env::temp_dir().join(format!("gpu-check-difference-{}", std::process::id()));
        let size = Size::new(2, 1).expect("two pixels are few");
        let one = [Vec3::ONE, Vec3::ZERO];
        let path = write_png(&folder, "a/b", size, &one, &[Vec3::ONE, Vec3::ONE]).expect("the folder is writable");
        assert_eq!(path, folder.join("a-b.png"));
        let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&path).expect("it was written")));
        let mut reader = decoder.read_info().expect("it is a PNG");
        let mut bytes = vec![0; reader.output_buffer_size().expect("it is small")];
        reader.next_frame(&mut bytes).expect("it has a picture");
        assert_eq!(bytes, [[255; 3], [0; 3], [255; 3], [255; 3], [0; 3], [255; 3]].concat());
        std::fs::remove_dir_all(folder).expect("it is ours");
    }
}
