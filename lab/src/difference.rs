//! Measures the difference between two pictures: by the course's measure (specification, section 12), and by other
//! common measures.

use serde::{Deserialize, Serialize};

use crate::picture::Picture;
use crate::picture::floats::Floats;

/// Upper limit of the largest pixel difference, in levels. The course accepts only values below it.
pub const MAXIMUM_BOUND: f64 = 150.0;

/// Upper limit of the RMSE, in levels. The course accepts only values below it.
pub const RMSE_BOUND: f64 = 10.0;

/// The differences between two pictures of equal size. The difference of a pixel is the mean of the absolute
/// differences of its channels, in levels from 0 to 255.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Difference {
    /// Root of the mean square of the pixels' differences, in levels.
    pub rmse: f64,
    /// The largest difference of a pixel, in levels.
    pub maximum: f64,
    /// The mean of the pixels' differences, in levels.
    pub mae: f64,
    /// Peak signal-to-noise ratio over all channels in decibels; `None` (infinite) for identical pictures.
    pub psnr: Option<f64>,
    /// Mean FLIP error, from 0 to 1; `None` if the program was built without the feature `flip`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flip: Option<f64>,
    /// Number of pixels with a difference above 0.
    pub differing: usize,
    /// Number of pixels compared.
    pub pixels: usize,
    /// The smallest rectangle that holds all pixels with a difference: column, row, width, height. `None` if the
    /// pictures are equal.
    pub bounding_box: Option<[usize; 4]>,
    /// Whether `maximum` and `rmse` are below the limits within which the course accepts a picture.
    pub accepted: bool,
}

/// The distances of numbers from those that they are compared with.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Errors {
    /// Root of the mean square.
    pub rmse: f64,
    /// The largest distance.
    pub maximum: f64,
    /// The mean.
    pub mae: f64,
    /// Number of distances above 0.
    pub differing: usize,
}

impl Errors {
    /// Returns the figures of these distances.
    pub fn of(distances: impl ExactSizeIterator<Item = f64>) -> Self {
        Self::of_some(distances.len(), distances)
    }

    /// Returns the figures of `count` distances.
    fn of_some(count: usize, distances: impl Iterator<Item = f64>) -> Self {
        let (count, mut errors) = (count.max(1) as f64, Self::default());
        let (mut sum, mut squares) = (0.0, 0.0);
        for distance in distances.filter(|distance| *distance > 0.0) {
            sum += distance;
            squares += distance * distance;
            errors.maximum = errors.maximum.max(distance);
            errors.differing += 1;
        }
        Self { rmse: (squares / count).sqrt(), mae: sum / count, ..errors }
    }
}

/// The differences between two pictures of numbers of equal size, such as depths. Numbers that are not finite, such as
/// the depth where nothing is hit, are counted apart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Numbers {
    /// Root of the mean square of the differences.
    pub rmse: f64,
    /// The largest difference.
    pub maximum: f64,
    /// The mean of the differences.
    pub mae: f64,
    /// How many numbers differ.
    pub differing: usize,
    /// How many numbers both pictures have.
    pub numbers: usize,
    /// How many numbers only the first picture has.
    pub only_first: usize,
    /// How many numbers only the second picture has.
    pub only_second: usize,
    /// The smallest rectangle that holds all pixels with a difference, or with a number in only one picture: column,
    /// row, width, height.
    pub bounding_box: Option<[usize; 4]>,
    /// Whether the differences are below the bounds that the user gave, or there is none.
    pub accepted: bool,
}

/// Whether a number counts. Others say that there is none.
fn is_there(number: f32) -> bool {
    number.is_finite()
}

impl Numbers {
    /// Returns the differences between two pictures of numbers. `bounds` are those of the maximum and of the RMSE.
    ///
    /// # Errors
    /// An error if the pictures have different sizes or channels.
    pub fn between(first: &Floats, second: &Floats, bounds: [Option<f64>; 2]) -> Result<Self, String> {
        let shapes = [first, second].map(|floats| (floats.width, floats.height, floats.channels));
        if shapes[0] != shapes[1] {
            let [a, b] = shapes.map(|(width, height, channels)| format!("{width} x {height} x {channels}"));
            return Err(format!("the pictures have different sizes or channels: {a} and {b}"));
        }
        let pairs = || first.values.iter().copied().zip(second.values.iter().copied());
        let count = |of: [bool; 2]| pairs().filter(|&(a, b)| [is_there(a), is_there(b)] == of).count();
        let (numbers, only_first, only_second) = (count([true; 2]), count([true, false]), count([false, true]));
        let distances = pairs().filter(|&(a, b)| is_there(a) && is_there(b));
        let Errors { rmse, maximum, mae, differing } = Errors::of_some(numbers, distances.map(|(a, b)| distance(a, b)));
        let differs = |&(a, b): &(f32, f32)| is_there(a) != is_there(b) || is_there(a) && a != b;
        let wrong = pairs().enumerate().filter(|(_, pair)| differs(pair));
        let bounding_box = bounding_box(wrong.map(|(at, _)| at / first.channels), first.width);
        let is_below = |value: f64, bound: Option<f64>| bound.is_none_or(|bound| value < bound);
        let accepted = if bounds == [None; 2] {
            bounding_box.is_none()
        } else {
            only_first + only_second == 0 && is_below(maximum, bounds[0]) && is_below(rmse, bounds[1])
        };
        Ok(Self { rmse, maximum, mae, differing, numbers, only_first, only_second, bounding_box, accepted })
    }
}

/// Returns the distance of two numbers.
pub fn distance(first: f32, second: f32) -> f64 {
    (f64::from(first) - f64::from(second)).abs()
}

/// Returns the smallest rectangle that holds these pixels: column, row, width, height.
fn bounding_box(pixels: impl Iterator<Item = usize>, width: usize) -> Option<[usize; 4]> {
    let mut corners: Option<[usize; 4]> = None;
    for index in pixels {
        let (x, y) = (index % width, index / width);
        let [left, top, right, bottom] = corners.unwrap_or([x, y, x, y]);
        corners = Some([left.min(x), top.min(y), right.max(x), bottom.max(y)]);
    }
    corners.map(|[left, top, right, bottom]| [left, top, right - left + 1, bottom - top + 1])
}

/// Returns the difference of two pixels: the mean of the absolute differences of their channels, in levels from 0 to
/// 255.
pub fn of_pixels(first: [u8; 3], second: [u8; 3]) -> f64 {
    f64::from(channels(first, second).iter().sum::<u32>()) / 3.0
}

fn channels(first: [u8; 3], second: [u8; 3]) -> [u32; 3] {
    std::array::from_fn(|channel| u32::from(first[channel].abs_diff(second[channel])))
}

impl Difference {
    /// Returns the differences between two pictures.
    ///
    /// # Errors
    /// An error if the pictures have different sizes.
    pub fn between(first: &Picture, second: &Picture) -> Result<Self, String> {
        Self::within(first, second, [MAXIMUM_BOUND, RMSE_BOUND])
    }

    /// Returns the differences between two pictures, accepted below these bounds of the maximum and of the RMSE.
    ///
    /// # Errors
    /// An error if the pictures have different sizes.
    pub fn within(first: &Picture, second: &Picture, bounds: [f64; 2]) -> Result<Self, String> {
        if (first.width, first.height) != (second.width, second.height) {
            let [a, b] = [first, second].map(|picture| format!("{} x {}", picture.width, picture.height));
            return Err(format!("the pictures have different sizes: {a} and {b}"));
        }
        let pairs = || first.pixels.iter().zip(&second.pixels);
        let Errors { rmse, maximum, mae, differing } = Errors::of(pairs().map(|(&a, &b)| of_pixels(a, b)));
        // The exact sum of the squares over all channels. It cannot overflow: 2^30 pixels times 3 times 255^2 is below
        // 2^48.
        let channel_squares: u64 = pairs().flat_map(|(&a, &b)| channels(a, b)).map(|d| u64::from(d * d)).sum();
        let pixels = first.pixels.len();
        let channel_mse = channel_squares as f64 / (3 * pixels) as f64;
        Ok(Self {
            rmse,
            maximum,
            mae,
            psnr: (differing > 0).then(|| 10.0 * (255.0 * 255.0 / channel_mse).log10()),
            flip: flip(first, second),
            differing,
            pixels,
            bounding_box: bounding_box(pairs().enumerate().filter(|(_, (a, b))| a != b).map(|(at, _)| at), first.width),
            accepted: maximum < bounds[0] && rmse < bounds[1],
        })
    }
}

/// Returns the mean FLIP error at 67 pixels a degree, the default of FLIP's authors. Returns `None` if a side of the
/// picture does not fit in 32 bits.
#[cfg(feature = "flip")]
fn flip(reference: &Picture, test: &Picture) -> Option<f64> {
    let size = [u32::try_from(reference.width).ok()?, u32::try_from(reference.height).ok()?];
    let image = |picture: &Picture| nv_flip::FlipImageRgb8::with_data(size[0], size[1], picture.pixels.as_flattened());
    let map = nv_flip::flip(image(reference), image(test), nv_flip::DEFAULT_PIXELS_PER_DEGREE);
    Some(f64::from(nv_flip::FlipPool::from_image(&map).mean()))
}

#[cfg(not(feature = "flip"))]
const fn flip(_: &Picture, _: &Picture) -> Option<f64> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(pixels: &[[u8; 3]]) -> Picture {
        Picture { width: 2, height: pixels.len() / 2, pixels: pixels.to_vec() }
    }

    #[test]
    fn a_pixels_difference_is_the_mean_over_its_channels() {
        assert_eq!(of_pixels([0, 10, 255], [3, 4, 255]), 3.0);
        let first = picture(&[[0; 3], [0; 3], [0; 3], [0; 3]]);
        let second = picture(&[[0; 3], [0; 3], [0; 3], [9, 0, 3]]);
        let difference = Difference::between(&first, &second).expect("one size");
        // One pixel of four differs by 4. The mean is 1, and the root of 16/4 is 2.
        assert_eq!((difference.rmse, difference.maximum, difference.mae), (2.0, 4.0, 1.0));
        assert_eq!((difference.differing, difference.bounding_box), (1, Some([1, 1, 1, 1])));
        // The mean square over all channels is (81 + 9) / 12 = 7.5.
        let expected = 10.0 * (65025.0_f64 / 7.5).log10();
        assert!((difference.psnr.expect("they differ") - expected).abs() < 1e-12);
    }

    #[test]
    fn numbers_that_are_not_there_are_counted_apart() {
        let floats = |values: &[f32]| Floats {
            width: 3,
            height: values.len() / 3,
            channels: 1,
            values: values.to_vec(),
            is_depth: true,
        };
        let (nan, far) = (f32::NAN, f32::INFINITY);
        let (first, second) = (floats(&[1.0, nan, 2.0, nan, 5.0, far]), floats(&[1.0, nan, 5.0, 7.0, nan, nan]));
        let found = Numbers::between(&first, &second, [None; 2]).expect("one size");
        // Two numbers are in both pictures, with the differences 0 and 3.
        assert_eq!((found.numbers, found.only_first, found.only_second, found.differing), (2, 1, 1, 1));
        assert_eq!((found.maximum, found.mae, found.rmse), (3.0, 1.5, 4.5_f64.sqrt()));
        assert_eq!((found.bounding_box, found.accepted), (Some([0, 0, 3, 2]), false));
        let near =
            |bounds| Numbers::between(&floats(&[1.0; 3]), &floats(&[1.5; 3]), bounds).expect("one size").accepted;
        assert!(near([Some(0.6), None]) && !near([Some(0.5), None]) && !near([None, Some(0.5)]) && !near([None; 2]));
    }

    #[test]
    fn the_bounds_themselves_are_not_accepted() {
        let black = picture(&[[0; 3], [0; 3]]);
        let at = |value| Difference::between(&black, &picture(&[[value; 3], [value; 3]])).expect("one size").accepted;
        assert!(at(9) && !at(10), "RMSE under 10");
        let many = |value: u8| {
            let mut pixels = vec![[0; 3]; 1000];
            let black = picture(&pixels);
            pixels[7] = [value; 3];
            Difference::between(&black, &picture(&pixels)).expect("one size").accepted
        };
        assert!(many(149) && !many(150), "largest difference under 150");
    }
}
