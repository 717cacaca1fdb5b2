//! From the samples of a pixel to its bytes, and from the pixels to the file (statement, sections 2.3 and 3.2).

use cpu::internals::image::quantize::Power;
use cpu::{Config, Vec3};

use crate::rules::Rules;

/// A picture: width, height, and red, green and blue of each pixel, row by row from the top left.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Picture {
    /// Number of columns.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// The pixels.
    pub pixels: Vec<[u8; 3]>,
}

/// Returns what a sample adds to the sum of its pixel.
pub fn share(color: Vec3, config: &Config, rules: &Rules) -> Vec3 {
    match (rules.or("gamma", 0.0), rules.has("bytes-first")) {
        (_, true) => color.map(|channel| f64::from(byte(channel, config, rules))),
        (5.0, false) => color.map(|channel| channel.power(1.0 / config.gamma)),
        _ => color,
    }
}

/// Returns the bytes of a pixel from the mean of its samples' shares, in the order of the file.
pub fn bytes(mean: Vec3, config: &Config, rules: &Rules) -> [u8; 3] {
    let is_byte = rules.has("bytes-first");
    let [r, g, b] = mean.to_array().map(|mean| if is_byte { mean as u8 } else { byte(mean, config, rules) });
    [[r, g, b], [b, g, r], [g, b, r], [r, b, g]][rules.or("channels", 0.0) as usize]
}

fn byte(mean: f64, config: &Config, rules: &Rules) -> u8 {
    let scale = rules.or("scale", 255.0);
    let scaled = match rules.or("gamma", 0.0) {
        0.0 => scale * mean.power(1.0 / config.gamma),
        2.0 => scale * mean.power(config.gamma),
        3.0 => scale * mean.sqrt(),
        4.0 => (scale * mean).power(1.0 / config.gamma),
        _ => scale * mean,
    };
    // The conversion truncates, limits to 0 and 255, and turns NaN into 0.
    (scaled + rules.or("rounded", 0.0)) as u8
}

/// Returns the picture as the file has it.
pub fn written(picture: Picture, rules: &Rules) -> Picture {
    let Picture { width, height, pixels } = picture;
    let from = |place: usize| {
        let (row, column) = (place / width, place % width);
        match ["mirrored", "upside-down", "by-columns"].map(|name| rules.has(name)) {
            [true, ..] => row * width + width - 1 - column,
            [_, true, _] => (height - 1 - row) * width + column,
            [.., true] => place % height * width + place / height,
            _ => place,
        }
    };
    Picture { width, height, pixels: (0..pixels.len()).map(|place| pixels[from(place)]).collect() }
}
