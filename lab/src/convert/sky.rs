//! The sky, a gradient from top to bottom, as the picture of a light around the scene.

use std::f64::consts::PI;

use cpu::Config;

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
    /// exactly 1 and -1, so they have the two colours of the sky.
    fn cosine(self, [column, row]: [usize; 2]) -> f64 {
        let [width, height] = self.size();
        match self {
            Self::Rows => (PI * row as f64 / (height - 1) as f64).cos(),
            Self::Square => {
                let part = |at: usize, side: usize| ((2 * at + 1) as f64 / side as f64 - 1.0).abs();
                let sum = part(column, width) + part(row, height);
                let pixel = 1.0 / width as f64;
                let radius = 1.0 - (1.0 - sum).abs();
                if radius <= 2.5 * pixel && (sum < 0.5 || sum > 2.0 - 2.5 * pixel) {
                    return (1.0 - sum).signum();
                }
                (1.0 - radius * radius).copysign(1.0 - sum)
            }
        }
    }

    /// Returns the picture of the sky of `config`.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn picture(self, config: &Config) -> Result<Floats, String> {
        let size = self.size();
        let mut picture = Floats::zeros(size[0], size[1], 3)?;
        for (at, pixel) in picture.values.chunks_exact_mut(3).enumerate() {
            let share = (self.cosine([at % size[0], at / size[0]]) + 1.0) / 2.0;
            let color = config.background_light_color * (1.0 - share) + config.background_dark_color * share;
            pixel.copy_from_slice(&color.to_array().map(|channel| channel as f32));
        }
        Ok(picture)
    }
}
