//! The picture by the CPU. It is computed once and kept while the user's modules change.

use std::cell::OnceCell;
use std::time::{Duration, Instant};

use cpu::{Config, Scatter, Scene, Vec3, reference};

use crate::{Error, Picture};

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

/// A configuration, a scene, and their picture by the CPU in deterministic mode.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The configuration.
    pub config: Config,
    /// The scene.
    pub scene: Scene,
    /// The picture's linear colours in f64, rendered by the reference.
    pub wide: Vec<Vec3>,
    /// The scene in f32, and its linear colours in f32 after the first call of [`Self::single`].
    single: (Picture<f32>, OnceCell<Vec<Vec3<f32>>>),
    /// The time to compute `wide` on one core.
    pub time: Duration,
}

impl Truth {
    /// Renders the picture in f64 with the reference.
    ///
    /// # Errors
    /// [`Error::Scene`] if the configuration makes no picture, [`Error::Request`] if the picture has more than
    /// [`MAX_PIXELS`] pixels.
    pub fn new(config: Config, scene: Scene) -> Result<Self, Error> {
        check_size(&config)?;
        let mut wide = Vec::new();
        let start = Instant::now();
        reference::render_linear(&config, &scene, Scatter::Deterministic, |_, color| wide.push(color))?;
        let time = start.elapsed();
        let single = (Picture::<f32>::new(&config, &scene)?, OnceCell::new());
        Ok(Self { config, scene, wide, single, time })
    }

    /// Returns the linear colours with every formula in f32, which is the best that a device can give in f32. They are
    /// computed at the first call, because with many objects they take as long as the colours in f64.
    #[must_use]
    pub fn single(&self) -> &[Vec3<f32>] {
        let (picture, colors) = &self.single;
        colors.get_or_init(|| (0..picture.size.pixels()).map(|index| picture.color(index)).collect())
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
