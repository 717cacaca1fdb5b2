//! The sky, a gradient from top to bottom, as the picture of a light around the scene, and such pictures as our sky.

use std::f64::consts::PI;

use cpu::{Config, Vec3};

use crate::picture::floats::Floats;

/// How directions lie in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Rows from +y to -y at equal angles, as Mitsuba reads them. It interpolates between rows.
    Rows,
    /// pbrt's square: +z in the middle, -z in the corners, pixels of equal solid angle. It does not interpolate.
    Square,
}

impl Layout {
    /// Width and height of the pictures that are written. Their largest error is 5e-6 by rows, and a 256th of the
    /// difference of both colours in the square.
    const fn size(self) -> [usize; 2] {
        match self {
            Self::Rows => [4, 513],
            Self::Square => [512, 512],
        }
    }

    /// Returns the cosine of the angle between the axis and the middle of a pixel. The pixels nearest to the poles get
    /// exactly 1 and -1, so the colours can be read back.
    fn cosine(self, [width, height]: [usize; 2], [column, row]: [usize; 2]) -> f64 {
        match self {
            Self::Rows if height < 2 => 0.0,
            Self::Rows => (PI * row as f64 / (height - 1) as f64).cos(),
            Self::Square => {
                let part = |at: usize, side: usize| ((2 * at + 1) as f64 / side as f64 - 1.0).abs();
                let sum = part(column, width) + part(row, height);
                let pixel = 1.0 / width.max(height) as f64;
                let radius = 1.0 - (1.0 - sum).abs();
                if radius <= 2.5 * pixel && (sum < 0.5 || sum > 2.0 - 2.5 * pixel) {
                    return (1.0 - sum).signum();
                }
                (1.0 - radius * radius).copysign(1.0 - sum)
            }
        }
    }

    fn gradient(self, size: [usize; 2], dark: Vec3, light: Vec3) -> Result<Floats, String> {
        let mut picture = Floats::zeros(size[0], size[1], 3)?;
        for (at, pixel) in picture.values.chunks_exact_mut(3).enumerate() {
            let share = (self.cosine(size, [at % size[0], at / size[0]]) + 1.0) / 2.0;
            let color = light * (1.0 - share) + dark * share;
            pixel.copy_from_slice(&color.to_array().map(|channel| channel as f32));
        }
        Ok(picture)
    }

    /// Returns the picture of the sky of `config`.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn picture(self, config: &Config) -> Result<Floats, String> {
        self.gradient(self.size(), config.background_dark_color, config.background_light_color)
    }

    /// Returns the colours at the top and at the bottom of a picture, and whether it is the gradient between them.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn colors(self, picture: &Floats) -> Result<([Vec3; 2], bool), String> {
        let size = [picture.width, picture.height];
        let pixel = |at: usize| {
            let channels = &picture.values[at * picture.channels..][..picture.channels];
            [0, 1, 2].map(|channel| f64::from(channels[channel.min(channels.len() - 1)]))
        };
        let mean = |pole: f64| {
            let is_there = |at: usize| self.cosine(size, [at % size[0], at / size[0]]) == pole;
            let all = 0..size[0] * size[1];
            // A small picture may have no pixel at a pole. The mean of all pixels takes its place.
            let has_pole = all.clone().any(is_there);
            let (sum, count) = all
                .filter(|&at| !has_pole || is_there(at))
                .fold((Vec3::ZERO, 0.0), |(sum, count), at| (sum + pixel(at).into(), count + 1.0));
            // The shortest decimal of an `f32` is the number of the configuration, if that has up to seven digits.
            (sum / count).map(|channel| (channel as f32).to_string().parse().unwrap_or(f64::NAN))
        };
        let colors = [mean(1.0), mean(-1.0)];
        let expected = self.gradient(size, colors[0], colors[1])?;
        let is_near = |(at, wanted): (usize, &[f32])| {
            pixel(at).iter().zip(wanted).all(|(value, wanted)| (value - f64::from(*wanted)).abs() <= 0.005)
        };
        Ok((colors, expected.values.chunks_exact(3).enumerate().all(is_near)))
    }
}
