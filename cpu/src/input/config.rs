//! The configuration file: `key: values` lines to a checked [`Config`] (specification, section 3).

use std::io::BufRead;
use std::path::Path;

use crate::input::{error::Error, error::Picture, reader, size::Size, text, text::Tokens};
use crate::math::vec3::Vec3;

/// The configuration of a picture. Every value is in its range once it comes out of [`Config::parse`].
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Width to height of the picture, two positive integers.
    pub aspect_ratio: [u64; 2],
    /// Width of the picture in pixels, positive.
    pub image_width: u64,
    /// Exponent of the gamma correction, positive: a channel is its mean to the power `1 / gamma`.
    pub gamma: f64,
    /// The origin of the camera rays.
    pub camera_position: Vec3,
    /// The point in the middle of the picture.
    pub camera_target: Vec3,
    /// The direction that is up in the picture; any length.
    pub camera_north: Vec3,
    /// Vertical opening of the view in degrees, between 0 and 180, both excluded.
    pub field_of_view: f64,
    /// Samples of a pixel, positive.
    pub samples_per_pixel: u64,
    /// Most rays of a sample, positive. The sample is black if the last of them hits an object.
    pub max_depth: u64,
    /// Seed of the generator that all materials share, positive.
    pub material_rng_seed: u64,
    /// Seed of the generator of the samples' offsets in their pixels, positive.
    pub ray_rng_seed: u64,
    /// Colour of the background where a ray points straight along +y, channels in `[0, 1]`.
    pub background_dark_color: Vec3,
    /// Colour of the background where a ray points straight along -y, channels in `[0, 1]`.
    pub background_light_color: Vec3,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            aspect_ratio: [16, 9],
            image_width: 1920,
            gamma: 2.2,
            camera_position: Vec3::new(0.0, 0.0, -10.0),
            camera_target: Vec3::ZERO,
            camera_north: Vec3::new(0.0, 1.0, 0.0),
            field_of_view: 90.0,
            samples_per_pixel: 20,
            max_depth: 5,
            material_rng_seed: 13,
            ray_rng_seed: 19,
            background_dark_color: Vec3::new(0.25, 0.5, 1.0),
            background_light_color: Vec3::ONE,
        }
    }
}

/// Reads one key's values into the configuration; `None` when they are missing, unreadable or out of range.
type Read = fn(&mut Config, &mut Tokens<'_>) -> Option<()>;

/// Every key with its reader, in the order of the table (specification, section 3.1).
const KEYS: [(&str, Read); 13] = [
    ("aspect_ratio:", |config, tokens| {
        config.aspect_ratio = [tokens.positive_integer()?, tokens.positive_integer()?];
        Some(())
    }),
    ("image_width:", |config, tokens| set(&mut config.image_width, tokens.positive_integer())),
    ("gamma:", |config, tokens| set(&mut config.gamma, tokens.real().filter(|&value| value > 0.0))),
    ("camera_position:", |config, tokens| set(&mut config.camera_position, vector(tokens))),
    ("camera_target:", |config, tokens| set(&mut config.camera_target, vector(tokens))),
    ("camera_north:", |config, tokens| set(&mut config.camera_north, vector(tokens))),
    ("field_of_view:", |config, tokens| {
        set(&mut config.field_of_view, tokens.real().filter(|&value| value > 0.0 && value < 180.0))
    }),
    ("samples_per_pixel:", |config, tokens| set(&mut config.samples_per_pixel, tokens.positive_integer())),
    ("max_depth:", |config, tokens| set(&mut config.max_depth, tokens.positive_integer())),
    ("material_rng_seed:", |config, tokens| set(&mut config.material_rng_seed, tokens.positive_integer())),
    ("ray_rng_seed:", |config, tokens| set(&mut config.ray_rng_seed, tokens.positive_integer())),
    ("background_dark_color:", |config, tokens| set(&mut config.background_dark_color, color(tokens))),
    ("background_light_color:", |config, tokens| set(&mut config.background_light_color, color(tokens))),
];

fn set<T>(field: &mut T, value: Option<T>) -> Option<()> {
    *field = value?;
    Some(())
}

fn vector(tokens: &mut Tokens<'_>) -> Option<Vec3> {
    tokens.reals().map(Vec3::from)
}

/// Three channels, each in `[0, 1]`: a background colour or a reflectance.
pub(crate) fn color(tokens: &mut Tokens<'_>) -> Option<Vec3> {
    tokens.reals().filter(|channels| channels.iter().all(|channel| (0.0..=1.0).contains(channel))).map(Vec3::from)
}

impl Config {
    /// Reads a configuration: absent keys keep their defaults, and of a repeated key the last counts.
    ///
    /// ```
    /// let config = cpu::Config::parse(&b"image_width: 640\ngamma: 2\n"[..])?;
    /// assert_eq!((config.image_width, config.gamma, config.max_depth), (640, 2.0, 5));
    /// # Ok::<(), cpu::Error>(())
    /// ```
    ///
    /// # Errors
    /// The first line that is wrong: [`Error::UnknownKey`], [`Error::InvalidValue`] or [`Error::ExtraValue`]; or
    /// [`Error::Input`] when `input` cannot be read.
    pub fn parse(input: impl BufRead) -> Result<Self, Error> {
        let mut config = Self::default();
        text::for_each_line(input, |line| config.set(line))?;
        Ok(config)
    }

    /// [`Config::parse`] of a file.
    ///
    /// # Errors
    /// As [`Config::parse`], and [`Error::Read`] with the file's name.
    pub fn read(path: &Path) -> Result<Self, Error> {
        reader::parse(path, Self::parse)
    }

    /// Sets the value that one line of a configuration file gives. A blank line changes nothing.
    ///
    /// ```
    /// let mut config = cpu::Config::default();
    /// config.set(b"gamma: 1")?;
    /// assert_eq!(config.gamma, 1.0);
    /// # Ok::<(), cpu::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Config::parse`], except [`Error::Input`].
    pub fn set(&mut self, line: &[u8]) -> Result<(), Error> {
        let mut tokens = Tokens::new(line);
        let Some(key) = tokens.next() else { return Ok(()) };
        let Some((key, read)) = KEYS.iter().find(|(known, _)| known.as_bytes() == key) else {
            return Err(Error::UnknownKey { key: key.to_vec() });
        };
        read(self, &mut tokens).ok_or_else(|| Error::InvalidValue { key, line: line.to_vec() })?;
        match tokens.rest() {
            [] => Ok(()),
            extra => Err(Error::ExtraValue { key, extra: extra.to_vec() }),
        }
    }

    /// The picture's size: `floor(width / (aspect width / aspect height))` rows, at least one.
    ///
    /// # Errors
    /// [`Picture::TooLarge`] when it has more pixels than [`crate::input::error::MAX_PIXELS`].
    pub fn image_size(&self) -> Result<Size, Picture> {
        let [aspect_width, aspect_height] = self.aspect_ratio.map(|side| side as f64);
        let height = (self.image_width as f64 / (aspect_width / aspect_height)).floor().max(1.0);
        // A float-to-integer cast saturates: a height beyond u64 becomes u64::MAX, which no image may have.
        Size::new(self.image_width, height as u64)
    }
}

#[cfg(test)]
mod tests;
