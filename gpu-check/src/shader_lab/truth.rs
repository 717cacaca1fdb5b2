//! The picture by the CPU. It is computed once and kept while the user's modules change.

use std::cell::OnceCell;
use std::time::{Duration, Instant};

use cpu::{Config, Scatter, Scene, Vec3, reference};

use crate::hierarchy::WORTHWHILE;
use crate::picture::depth;
use crate::sampled::streams::Streams;
use crate::sampled::twin::means;
use crate::sampled::{Convention, Recording};
use crate::terminal::bar;
use crate::{Error, Picture, ray_loop};

/// The start of each report on the progress of the CPU's rendering.
const WORDS: &str = "the CPU renders";

/// Largest number of pixels of a picture, slightly more than 4K (3840 x 2160). About a dozen copies of a picture are in
/// memory at once.
pub const MAX_PIXELS: usize = 1 << 23;

/// Refuses a configuration whose picture has more than [`MAX_PIXELS`] pixels.
///
/// # Errors
/// [`Error::Request`] if the picture is too large, or [`Error::Scene`] if the configuration makes no picture.
pub fn check_size(config: &Config) -> Result<(), Error> {
    let size = config.image_size().map_err(cpu::internals::input::error::Error::from)?;
    if size.pixels() <= MAX_PIXELS {
        return Ok(());
    }
    let [width, height] = [size.width(), size.height()];
    let message = format!("the picture has {width} x {height} pixels, more than {MAX_PIXELS}; lower image_width");
    Err(Error::Request { message })
}

/// Refuses a depth with which no run on a device can trace the paths of `scene`. The reference could take any time and
/// memory for such a depth, so this is checked before it renders. A scene of many objects may get a hierarchy.
///
/// # Errors
/// [`Error::TooLarge`] or [`Error::TooManyIterations`].
fn check_depth(config: &Config, scene: &Scene, samples: Option<Convention>) -> Result<(), Error> {
    let tries = samples.map_or(0, Convention::tries);
    let objects = scene.objects.len();
    ray_loop::check(objects, objects >= WORTHWHILE, depth(config)?, tries)
}

/// A configuration, a scene, and their picture by the CPU.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The configuration.
    pub config: Config,
    /// The scene.
    pub scene: Scene,
    /// The picture's linear colours in f64, rendered by the reference.
    pub wide: Vec<Vec3>,
    /// The recording of a picture with random numbers, without its means, which are in `wide`; `None` in deterministic
    /// mode.
    pub recording: Option<Recording>,
    /// The scene in f32, and its linear colours in f32 after the first call of [`Self::single`].
    single: (Picture<f32>, OnceCell<Vec<Vec3<f32>>>),
    /// The time to compute `wide` on one core.
    pub time: Duration,
}

impl Truth {
    /// Renders the picture in f64 by the reference: in deterministic mode, or with random numbers if `samples` is the
    /// convention of the scatter vectors.
    ///
    /// # Errors
    /// [`Error::Scene`] when the configuration makes no picture, [`Error::Request`] when it has too many pixels or
    /// samples, [`Error::TooLarge`] or [`Error::TooManyIterations`] when its depth is too large for a device.
    pub fn new(config: Config, scene: Scene, samples: Option<Convention>) -> Result<Self, Error> {
        check_size(&config)?;
        check_depth(&config, &scene, samples)?;
        let mut wide = Vec::new();
        let start = Instant::now();
        let size = config.image_size().map_err(cpu::internals::input::error::Error::from)?;
        let progress = bar(WORDS, size.pixels());
        let recording = match samples {
            Some(convention) => {
                let tell = |pixels, _| progress.set_position(pixels as u64);
                let mut recording = Recording::telling(&config, &scene, convention, tell)?;
                wide = std::mem::take(&mut recording.means);
                Some(recording)
            }
            None => {
                reference::render_linear::<reference::Plain>(&config, &scene, Scatter::Deterministic, |_, color| {
                    wide.push(color);
                    progress.inc(1);
                })?;
                None
            }
        };
        let time = start.elapsed();
        let single = (Picture::<f32>::new(&config, &scene)?, OnceCell::new());
        Ok(Self { config, scene, wide, recording, single, time })
    }

    /// Returns the linear colours with every formula in f32, which is the best that a device can give in f32. They are
    /// computed at the first call, because with many objects they take as long as the colours in f64.
    pub fn single(&self) -> &[Vec3<f32>] {
        let (picture, colors) = &self.single;
        colors.get_or_init(|| {
            let progress = bar(WORDS, picture.size.pixels());
            if let Some(recording) = &self.recording {
                let streams = Streams::new(recording);
                return means(picture, recording, streams, |pixels| progress.set_position(pixels as u64));
            }
            progress.wrap_iter(0..picture.size.pixels()).map(|index| picture.color(index)).collect()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_exactly_the_limit_is_taken_and_one_row_more_refused() {
        let config = |height| Config { image_width: 4096, aspect_ratio: [4096, height], ..Config::default() };
        assert!(check_size(&config(2048)).is_ok());
        let message = check_size(&config(2049)).expect_err("it is a row too many").to_string();
        assert_eq!(message, "the picture has 4096 x 2049 pixels, more than 8388608; lower image_width");
    }

    /// Inside a mirror no path ends before the maximum depth. Without the check this test would take hours.
    #[test]
    fn a_depth_that_no_device_takes_is_refused_before_the_reference_renders() {
        let text = "metal: mirror 1 1 1 0\nsphere: 0 0 0 1000000 mirror\n";
        let scene = || Scene::parse(text.as_bytes()).expect("it is valid");
        let config = |max_depth| Config { image_width: 1, samples_per_pixel: 1, max_depth, ..Config::default() };
        for (depth, message) in [
            (u64::MAX, "the materials that attenuate each path takes 18446744073709551615 bytes"),
            (u64::from(u32::MAX), "1 objects to a depth of 4294967295 are more than one run can loop over"),
            (65_534, "1 objects to a depth of 65534 are more than one run can loop over (65535 in all)"),
        ] {
            let error = Truth::new(config(depth), scene(), None).expect_err("it is too deep").to_string();
            assert!(error.starts_with(message), "{error}");
        }
        let deepest = Truth::new(config(65_533), scene(), None).expect("a run may loop over this");
        assert_eq!(deepest.wide, [Vec3::new(0.0, 0.0, 0.0)], "no path ends before the maximum depth");
    }
}
