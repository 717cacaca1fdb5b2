//! The picture by the CPU, computed once and kept while the user's modules change.

use std::cell::OnceCell;
use std::time::{Duration, Instant};

use cpu::{Config, Scatter, Scene, Vec3, reference};

use super::progress::Progress;
use crate::{Error, Picture};

/// What the reports of progress call the rendering by the CPU.
const WORDS: &str = "the CPU renders";

/// Most pixels of a picture, a little more than 4K has. About a dozen copies of a picture are in memory at once.
pub const MAX_PIXELS: usize = 1 << 23;

/// Refuses a configuration whose picture has more than [`MAX_PIXELS`].
///
/// # Errors
/// [`Error::Request`], or [`Error::Scene`] when the configuration makes no picture.
pub fn check_size(config: &Config) -> Result<(), Error> {
    let size = config.image_size().map_err(cpu::internals::input::error::Error::from)?;
    if size.pixels() <= MAX_PIXELS {
        return Ok(());
    }
    let [width, height] = [size.width(), size.height()];
    let message = format!("the picture has {width} x {height} pixels, more than {MAX_PIXELS}; lower image_width");
    Err(Error::Request { message })
}

/// A configuration, a scene, and its picture in deterministic mode.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The configuration.
    pub config: Config,
    /// The scene.
    pub scene: Scene,
    /// Linear colours in f64, by the reference.
    pub wide: Vec<Vec3>,
    /// The scene for f32, and its picture once [`Self::single`] has computed it.
    single: (Picture<f32>, OnceCell<Vec<Vec3<f32>>>),
    /// The time that `wide` took on one core.
    pub time: Duration,
}

impl Truth {
    /// Renders the picture in f64 by the reference.
    ///
    /// # Errors
    /// [`Error::Scene`] when the configuration makes no picture, [`Error::Request`] when it has more than
    /// [`MAX_PIXELS`].
    pub fn new(config: Config, scene: Scene) -> Result<Self, Error> {
        check_size(&config)?;
        let mut wide = Vec::new();
        let start = Instant::now();
        let size = config.image_size().map_err(cpu::internals::input::error::Error::from)?;
        let mut progress = Progress::start(WORDS);
        reference::render_linear(&config, &scene, Scatter::Deterministic, |_, color| {
            wide.push(color);
            progress.note_row(wide.len(), size);
        })?;
        let time = start.elapsed();
        let single = (Picture::<f32>::new(&config, &scene)?, OnceCell::new());
        Ok(Self { config, scene, wide, single, time })
    }

    /// The picture with every formula in f32, which is the best that a device can give in f32. It is computed at the
    /// first call, since with many objects it takes as long as the picture in f64.
    #[must_use]
    pub fn single(&self) -> &[Vec3<f32>] {
        let (picture, colors) = &self.single;
        colors.get_or_init(|| {
            let mut progress = Progress::start(WORDS);
            let mut colors = Vec::with_capacity(picture.size.pixels());
            for index in 0..picture.size.pixels() {
                colors.push(picture.color(index));
                progress.note_row(colors.len(), picture.size);
            }
            colors
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
}
