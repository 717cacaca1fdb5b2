//! The structure `Picture` of `picture.wgsl`: the numbers of a picture, and the part of it that one run renders.

use std::ops::Range;

use crate::packed::Packed;
use crate::{Float, Picture};

/// The part of a picture that one run renders.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    /// Pixels in deterministic mode.
    Pixels {
        /// Index of the first pixel.
        first: u32,
        /// Number of pixels.
        count: u32,
    },
    /// Samples of a picture with random numbers. They may begin and end within a pixel.
    Samples {
        /// Index of the pixel of the first sample.
        first_pixel: u32,
        /// The number of the first sample in its pixel.
        first_sample: u32,
        /// Number of samples.
        count: u32,
        /// Number of samples of each pixel.
        samples_per_pixel: u32,
        /// The number of the convention of the scatter vectors in `scatter_vectors.wgsl`.
        convention: u32,
    },
}

/// Returns the bytes of the structure for a run that renders `part` at the depths `depths`.
#[must_use]
pub fn head<T: Float>(picture: &Picture<T>, part: &Part, depths: &Range<u32>) -> Vec<u8> {
    let (first_pixel, pixels, samples) = match *part {
        Part::Pixels { first, count } => (first, count, [0; 4]),
        Part::Samples { first_pixel, first_sample, count, samples_per_pixel, convention } => {
            (first_pixel, 0, [count, first_sample, samples_per_pixel, convention])
        }
    };
    let mut bytes = Vec::new();
    picture.camera.pack(&mut bytes);
    picture.background.pack(&mut bytes);
    // In deterministic mode the two offsets and the three components of the scatter vector are zero.
    [T::of(0.0); 5][..].pack(&mut bytes);
    let objects = [picture.spheres.len() as u32, picture.cylinders.len() as u32];
    let numbers = [picture.size.width() as u32, first_pixel, pixels, objects[0], objects[1], depths.start, depths.end];
    numbers.into_iter().chain(samples).chain([0]).for_each(|number| number.pack(&mut bytes));
    bytes
}
