//! Parses the configuration file into a checked [`Config`]. Each line of the file has the form `key: values`
//! (specification, section 3).

use std::io::BufRead;
use std::path::Path;

use crate::input::{error::Error, error::Picture, reader, size::Size, text, text::Tokens};
use crate::math::vec3::Vec3;

/// The configuration of a picture. [`Config::parse`] returns only configurations whose values are in their ranges.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// The ratio of width to height of the picture, as two positive integers.
    pub aspect_ratio: [u64; 2],
    /// Width of the picture in pixels, positive.
    pub image_width: u64,
    /// Exponent of the gamma correction, positive: a channel is its mean to the power `1 / gamma`.
    pub gamma: f64,
    /// The point where the camera rays start, in scene units.
    pub camera_position: Vec3,
    /// The point that is in the middle of the picture, in scene units.
    pub camera_target: Vec3,
    /// The direction that is up in the picture. It may have any length, but not zero.
    pub camera_north: Vec3,
    /// The vertical field of view in degrees, greater than 0 and less than 180.
    pub field_of_view: f64,
    /// Number of samples of each pixel, positive.
    pub samples_per_pixel: u64,
    /// Maximum number of rays of a sample, positive. If the last of these rays hits an object, the sample is black.
    pub max_depth: u64,
    /// Seed of the random generator that all materials share, positive.
    pub material_rng_seed: u64,
    /// Seed of the random generator of the samples' positions in their pixels, positive.
    pub ray_rng_seed: u64,
    /// Colour of the background for a ray that points straight along +y, each channel in `[0, 1]`.
    pub background_dark_color: Vec3,
    /// Colour of the background for a ray that points straight along -y, each channel in `[0, 1]`.
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

/// A function that reads the values of one key into the configuration. It returns `None` if they are missing,
/// unreadable or out of range.
type ReadKey = fn(&mut Config, &mut Tokens<'_>) -> Option<()>;

/// Every key with the function that reads its values, in the order of the table (specification, section 3.1).
const KEYS: [(&str, ReadKey); 13] = [
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

/// Replaces `field` by the value, if there is one.
fn set<T>(field: &mut T, value: Option<T>) -> Option<()> {
    *field = value?;
    Some(())
}

/// Reads three numbers.
fn vector(tokens: &mut Tokens<'_>) -> Option<Vec3> {
    tokens.reals().map(Vec3::from)
}

/// Reads a background colour or a reflectance: three channels, each in `[0, 1]`. The result is `None` if one of them is
/// missing, unreadable or out of range.
pub(crate) fn color(tokens: &mut Tokens<'_>) -> Option<Vec3> {
    tokens.reals().filter(|channels| channels.iter().all(|channel| (0.0..=1.0).contains(channel))).map(Vec3::from)
}

impl Config {
    /// Reads a configuration. Absent keys keep their defaults. If a key is repeated, its last line counts.
    ///
    /// ```
    /// let config = cpu::Config::parse(&b"image_width: 640\ngamma: 2\n"[..])?;
    /// assert_eq!((config.image_width, config.gamma, config.max_depth), (640, 2.0, 5));
    /// # Ok::<(), cpu::Error>(())
    /// ```
    ///
    /// # Errors
    /// The fault of the first invalid line: [`Error::UnknownKey`], [`Error::InvalidValue`] or [`Error::ExtraValue`].
    /// [`Error::Input`] if `input` cannot be read.
    pub fn parse(input: impl BufRead) -> Result<Self, Error> {
        let mut config = Self::default();
        text::for_each_line(input, |line| config.set(line))?;
        Ok(config)
    }

    /// Reads the configuration file at `path`, as [`Config::parse`] does.
    ///
    /// # Errors
    /// Those of [`Config::parse`], but [`Error::Read`] with the file's name if the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, Error> {
        reader::parse(path, Self::parse)
    }

    /// Sets the values that `line`, a line of a configuration file, gives. A blank line changes nothing.
    ///
    /// ```
    /// let mut config = cpu::Config::default();
    /// config.set(b"gamma: 1")?;
    /// assert_eq!(config.gamma, 1.0);
    /// # Ok::<(), cpu::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::UnknownKey`], [`Error::InvalidValue`] or [`Error::ExtraValue`] if the line is invalid.
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

    /// Returns the picture's size. It has `floor(width / (aspect width / aspect height))` rows, but at least one.
    ///
    /// # Errors
    /// [`Picture::TooLarge`] if the picture has more pixels than [`crate::input::error::MAX_PIXELS`].
    pub fn image_size(&self) -> Result<Size, Picture> {
        let [aspect_width, aspect_height] = self.aspect_ratio.map(|side| side as f64);
        let height = (self.image_width as f64 / (aspect_width / aspect_height)).floor().max(1.0);
        // A float-to-integer cast saturates: a height beyond u64 becomes u64::MAX, which no image may have.
        Size::new(self.image_width, height as u64)
    }
}

#[cfg(test)]
mod tests;
