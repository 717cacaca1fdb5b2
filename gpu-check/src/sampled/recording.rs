//! A picture by the reference, and the number of words that each of its paths took from the stream of scatter vectors.

use std::fmt;
use std::time::{Duration, Instant};

use cpu::{Config, Error as CpuError, Scatter, Scene, Size, Vec3, reference};

use super::twin::MAX_TRIES;
use crate::Error;

/// Largest number of samples of a picture. A recording takes 4 bytes for each of them.
pub const MAX_SAMPLES: u64 = 1 << 28;

/// The conventions of the scatter vectors that use random numbers, with the numbers that `scatter_vectors.wgsl` gives
/// them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
#[repr(u32)]
pub enum Convention {
    /// As render-aos and render-soa do
    Statement = 1,
    /// As the course's published pictures were made
    Published = 2,
}

impl fmt::Display for Convention {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Statement => "statement",
            Self::Published => "published",
        })
    }
}

impl Convention {
    /// Both conventions.
    pub const ALL: [Self; 2] = [Self::Statement, Self::Published];

    /// Returns the convention as the reference takes it.
    #[must_use]
    pub const fn scatter(self) -> Scatter {
        match self {
            Self::Statement => Scatter::Statement,
            Self::Published => Scatter::Published,
        }
    }

    /// Returns the largest number of vectors from which the shader chooses a scatter vector in a loop; 0 if it has no
    /// such loop.
    pub(crate) const fn tries(self) -> u64 {
        match self {
            Self::Statement => 0,
            Self::Published => MAX_TRIES,
        }
    }
}

/// A picture by the reference with plain intersections, and what a device needs to trace its paths in any order.
#[derive(Clone, Debug)]
pub struct Recording {
    /// The convention of the scatter vectors.
    pub convention: Convention,
    /// Number of samples of each pixel.
    pub samples_per_pixel: u32,
    /// The seed of the generator of positions in pixels.
    pub ray_rng_seed: u64,
    /// The seed of the generator of scatter vectors.
    pub material_rng_seed: u64,
    /// The mean colour of each pixel before quantisation, row by row from the top left.
    pub means: Vec<Vec3>,
    /// The number of words that each sample's path took from the generator of scatter vectors, pixel by pixel.
    pub words: Vec<u32>,
    /// The time that the reference needed on one core.
    pub time: Duration,
}

impl Recording {
    /// Renders the picture by the reference.
    ///
    /// # Errors
    /// The errors of [`check_samples`], and [`Error::OutOfMemory`] if the recording does not fit in memory.
    pub fn new(config: &Config, scene: &Scene, convention: Convention) -> Result<Self, Error> {
        Self::telling(config, scene, convention, |_, _| ())
    }

    /// Records as [`Self::new`] does. After each pixel it calls `tell` with the number of finished pixels and the size
    /// of the picture.
    ///
    /// # Errors
    /// The errors of [`Self::new`].
    pub fn telling(
        config: &Config,
        scene: &Scene,
        convention: Convention,
        mut tell: impl FnMut(usize, Size),
    ) -> Result<Self, Error> {
        let (size, samples_per_pixel) = check_samples(config)?;
        let start = Instant::now();
        let mut means = with_room(size.pixels())?;
        let mut words = with_room(size.pixels() * samples_per_pixel as usize)?;
        // A path of 2^32 words would have a billion bounces, which `Picture` refuses.
        let sample = |count| words.push(u32::try_from(count).unwrap_or(u32::MAX));
        let pixel = |_, mean| {
            means.push(mean);
            tell(means.len(), size);
        };
        reference::render_recorded::<reference::Plain>(config, scene, convention.scatter(), sample, pixel)?;
        let Config { ray_rng_seed, material_rng_seed, .. } = *config;
        let time = start.elapsed();
        Ok(Self { convention, samples_per_pixel, ray_rng_seed, material_rng_seed, means, words, time })
    }
}

/// Returns the size of the picture and the number of samples of each pixel.
///
/// # Errors
/// [`Error::Request`] if the picture has more than [`MAX_SAMPLES`] samples, or [`Error::Scene`] if the configuration
/// makes no picture.
pub fn check_samples(config: &Config) -> Result<(Size, u32), Error> {
    let size = config.image_size().map_err(CpuError::from)?;
    let samples = config.samples_per_pixel.saturating_mul(size.pixels() as u64);
    match u32::try_from(config.samples_per_pixel) {
        Ok(samples_per_pixel) if samples <= MAX_SAMPLES => Ok((size, samples_per_pixel)),
        _ => {
            let lower = "lower image_width or samples_per_pixel";
            Err(Error::Request {
                message: format!("the picture has {samples} samples, more than {MAX_SAMPLES}; {lower}"),
            })
        }
    }
}

/// Returns an empty list with room for `count` values.
fn with_room<V>(count: usize) -> Result<Vec<V>, Error> {
    let mut values = Vec::new();
    values.try_reserve_exact(count).map_err(|cause| Error::OutOfMemory { cause: cause.to_string() })?;
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_samples_as_the_limit_are_taken_and_one_pixel_more_is_refused() {
        let config =
            |image_width| Config { image_width, aspect_ratio: [1, 1], samples_per_pixel: 4, ..Config::default() };
        assert!(check_samples(&config(8192)).is_ok_and(|(_, samples)| samples == 4));
        let error = check_samples(&config(8193)).expect_err("it is more").to_string();
        assert!(error.starts_with("the picture has 268500996 samples, more than 268435456; lower "), "{error}");
        assert!(check_samples(&Config { samples_per_pixel: u64::MAX, ..config(1) }).is_err());
    }

    #[test]
    fn a_path_takes_three_words_for_each_rough_surface_and_none_in_glass() {
        let config = Config { image_width: 4, samples_per_pixel: 2, max_depth: 1, ..Config::default() };
        for (material, words) in [("matte: a .5 .5 .5", 3), ("metal: a .5 .5 .5 0", 3), ("refractive: a 1.5", 0)] {
            let scene = format!("{material}\nsphere: 0 0 -10 9 a\n");
            let scene = Scene::parse(scene.as_bytes()).expect("it is valid");
            let recording = Recording::new(&config, &scene, Convention::Statement).expect("it is small");
            assert_eq!((recording.means.len(), recording.words), (8, vec![words; 16]), "{material}");
        }
    }
}
