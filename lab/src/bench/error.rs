//! Measures the error of pictures with few samples against the converged picture.
//!
//! There are two measures of the error. In linear light, before gamma and truncation, the error of a mean of n
//! independent samples falls as n^(-1/2). The course's measure uses the levels (0 to 255) of the finished picture. All
//! implementations make the same picture, so the error does not depend on the implementation; only the time does.

use cpu::internals::image::quantize::quantize;
use cpu::{Config, Scene, Vec3};
use serde::{Deserialize, Serialize};

use crate::difference::{Errors, of_pixels};
use crate::engine::means;
use crate::{Failure, interrupt};
use measure::statistics::Median;

/// The errors of pictures of one scene that all have the same number of samples per pixel, but different seeds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorPoint {
    /// Number of samples of a pixel.
    pub samples: u64,
    /// RMSE over all channels in linear light, in which 1 is white: the median of pictures of several seeds.
    pub linear: Median,
    /// RMSE as the course defines it, in levels from 0 to 255: the median of the same pictures.
    pub course: Median,
}

/// The error for each number of samples, for one scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorCurve {
    /// The scene's name.
    pub scene: String,
    /// Number of samples of a pixel of the converged picture.
    pub reference_samples: u64,
    /// Error (RMSE) of the converged picture in linear light, estimated from its two halves.
    pub reference_error: f64,
    /// The errors, ordered by rising number of samples.
    pub points: Vec<ErrorPoint>,
}

/// Seeds of the two halves of the converged picture. They are far from the seeds of the measured pictures, which begin
/// at 1.
const REFERENCE_SEEDS: [u64; 2] = [0x5eed_0001, 0x5eed_0002];

fn with_seed(config: &Config, samples: u64, seed: u64) -> Config {
    // The renderer has two random generators, so `seed` becomes two different seeds.
    let (ray_rng_seed, material_rng_seed) = (2 * seed, 2 * seed + 1);
    Config { samples_per_pixel: samples, ray_rng_seed, material_rng_seed, ..config.clone() }
}

/// Returns the RMSE of two pictures: the root of the mean square of the differences of all channels.
fn rmse(first: &[Vec3], second: &[Vec3]) -> f64 {
    let squares = first.iter().zip(second).map(|(&a, &b)| (a - b).dot(a - b));
    (squares.sum::<f64>() / (3 * first.len()) as f64).sqrt()
}

fn bytes(means: &[Vec3], gamma: f64) -> Vec<[u8; 3]> {
    means.iter().map(|mean| mean.to_array().map(|channel| quantize(channel, gamma))).collect()
}

/// Number of pictures for each number of samples. Their seeds are 1, 2 and so on.
const SEEDS: u64 = 5;

/// Measures the error for each number in `samples`, the largest of which comes last.
///
/// # Errors
/// An error of the renderer, or [`Failure::Interrupted`].
pub fn curve(name: &str, config: &Config, scene: &Scene, samples: &[u64]) -> Result<ErrorCurve, Failure> {
    // The converged picture has 64 times the samples of the finest picture, so its error is an eighth of that
    // picture's.
    let reference_samples = 64 * samples.last().copied().unwrap_or(1);
    let picture = |samples, seed| -> Result<Vec<Vec3>, Failure> {
        interrupt::check()?;
        Ok(means(&with_seed(config, samples, seed), scene)?)
    };
    let [first, second] = REFERENCE_SEEDS.map(|seed| picture(reference_samples / 2, seed));
    let (first, second) = (first?, second?);
    let converged: Vec<Vec3> = first.iter().zip(&second).map(|(&a, &b)| (a + b) / 2.0).collect();
    let converged_bytes = bytes(&converged, config.gamma);
    let mut points = Vec::new();
    for &samples in samples {
        let (mut linear, mut course) = (Vec::new(), Vec::new());
        for seed in 1..=SEEDS {
            let means = picture(samples, seed)?;
            linear.push(rmse(&means, &converged));
            let levels = bytes(&means, config.gamma);
            let distances = levels.iter().zip(&converged_bytes).map(|(&a, &b)| of_pixels(a, b));
            course.push(Errors::of(distances).rmse);
        }
        points.push(ErrorPoint { samples, linear: Median::of(&linear), course: Median::of(&course) });
    }
    // The two halves are independent, and each has the variance v. Their difference has the variance 2v and their mean
    // v/2, so the error of the mean is half of the RMSE between the halves.
    let reference_error = rmse(&first, &second) / 2.0;
    Ok(ErrorCurve { scene: name.to_owned(), reference_samples, reference_error, points })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::fit::PowerLaw;

    #[test]
    fn the_error_falls_with_the_root_of_the_samples() {
        let config = Config::parse(&b"image_width: 32\naspect_ratio: 1 1\n"[..]).expect("it is valid");
        let scene = Scene::parse(&b"matte: m .5 .5 .5\nsphere: 0 0 0 6 m\n"[..]).expect("it is valid");
        let samples = [1, 4, 16, 64];
        let curve = curve("ball", &config, &scene, &samples).expect("it is small");
        let points: Vec<_> = curve.points.iter().map(|point| (point.samples as f64, point.linear.median)).collect();
        let law = PowerLaw::through(&points).expect("four points");
        assert!((law.exponent + 0.5).abs() < 0.05, "{law:?}");
        // The error of the converged picture must be the one that the law predicts for its 4,096 samples.
        let ratio = curve.reference_error / (law.factor * 4096.0_f64.powf(law.exponent));
        assert!((0.7..1.4).contains(&ratio), "{ratio}");
        assert!(curve.points.is_sorted_by(|a, b| a.course.median > b.course.median), "{:?}", curve.points);
    }
}
