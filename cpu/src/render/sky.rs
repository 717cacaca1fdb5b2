//! Pixels that no object can reach, most of them without tracing a ray.
//!
//! Such a pixel's colour is the mean of the background over its samples, and the background is smooth: with
//! `s(d) = d.y / |d|` for a direction `d`, a channel is `light + (dark - light) (s + 1) / 2`. Over a pixel,
//! `d = d0 + x dx + y dy` with `x, y` in `[-1/2, 1/2]`, and Taylor's theorem gives
//!
//! `s(d) = s(d0) + x g.dx + y g.dy + R`, `g = (j - s(d0) d0 / |d0|) / |d0|`, `|R| <= 3 |e|^2 / (|d0| - |e|)^2`
//!
//! where `j` is the unit vector along y, `e = d - d0`, and the bound uses that the second derivative of `s` is at most
//! `6 / |d|^2`. So the mean is known up to `R` once the means of `x` and `y` are, and up to half of
//! `|g.dx| + |g.dy|` even without them. Where all means in that interval give the same byte, that is the pixel's byte,
//! and its rays need not be traced, its places not even drawn. Elsewhere they are.
//!
//! A channel that is 1 at both ends, as the blue of the default sky, is at a byte's boundary, where no interval has one
//! byte. But it is exactly 1 in every sample: with `m` in `[0, 1]` the rounding error of `1 - m` is at most `2^-54`, and
//! the sum `(1 - m) + m` rounds to 1 with it (below 1 that is a tie, and 1 is even). Sums of ones are exact. Likewise 0.

use super::batch::Batch;
use super::span::Span;
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::rng::BlockUniform;
use crate::simd::{Kernel, Simd};
use crate::vec3::Vec3;

/// Rounding of a channel's mean: of each sample's colour, and of their sum, relative to colours of at most one.
fn rounding(samples: u64) -> f64 {
    (samples as f64 + 64.0) * 4.0 * f64::EPSILON
}

/// The stream of places, with draws that have been passed over but not yet skipped.
#[derive(Debug)]
pub struct Offsets {
    stream: BlockUniform,
    passed_over: u64,
}

impl Offsets {
    /// At the beginning of the stream.
    pub fn new(seed: u64) -> Self {
        Self { stream: BlockUniform::new(seed), passed_over: 0 }
    }

    /// Passes over the draws of a pixel.
    #[inline(always)]
    fn pass_over(&mut self, samples: u64) {
        self.passed_over += 2 * samples;
        add(Counter::RayDrawsSkipped, 2 * samples);
    }

    /// The stream at its place.
    #[inline(always)]
    pub fn stream(&mut self) -> &mut BlockUniform {
        if self.passed_over > 0 {
            self.stream.skip(self.passed_over);
            self.passed_over = 0;
        }
        &mut self.stream
    }
}

/// The background around a pixel's middle, to first order.
#[derive(Clone, Copy, Debug)]
struct Slope {
    /// `s(d0)`.
    middle: f64,
    /// `g.dx` and `g.dy`.
    along: [f64; 2],
    /// Bound of `|R|`.
    rest: f64,
}

impl Slope {
    fn new<L: Layout, P: Intersect>(prepared: &Prepared<L, P>, row: usize, column: usize) -> Self {
        let camera = &prepared.camera;
        let d0 = camera.ray(row as f64, column as f64, [0.0; 2]).direction;
        let length = d0.length();
        let middle = d0.y / length;
        let g = (Vec3::new(0.0, 1.0, 0.0) - d0 * (middle / length)) / length;
        let reach = (camera.delta_x.length() + camera.delta_y.length()) / 2.0;
        let closest = (length - reach).max(0.0);
        let rest = 3.0 * (reach / closest) * (reach / closest) * (1.0 + 1e-9);
        Self { middle, along: [g.dot(camera.delta_x), g.dot(camera.delta_y)], rest }
    }

    /// `s` over all samples of the pixel: its mean lies this far from the first number at most.
    fn anywhere(&self) -> (f64, f64) {
        (self.middle, (self.along[0].abs() + self.along[1].abs()) / 2.0 + self.rest)
    }

    /// Whether `(s + 1) / 2`, as it is computed, is in `[0, 1]` all over the pixel.
    fn is_slanted(&self) -> bool {
        let (middle, radius) = self.anywhere();
        middle.abs() + radius < 0.999
    }

    /// `s` over samples with these mean offsets.
    fn at(&self, offset: [f64; 2]) -> (f64, f64) {
        (self.middle + offset[0] * self.along[0] + offset[1] * self.along[1], self.rest)
    }
}

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// Its bytes.
    Bytes([u8; 3]),
    /// Nothing: its samples, drawn into the batch, must be traced.
    Drawn,
}

/// Finds the bytes of a pixel that no object can reach, if they can be known.
pub struct Look<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub row: usize,
    /// The span of the pixel.
    pub pixel: &'a Span,
    pub offsets: &'a mut Offsets,
    pub batch: &'a mut Batch,
    /// The bytes of the last pixel found: the next one's mostly are the same.
    pub last: &'a mut [u8; 3],
}

impl<L: Layout, P: Intersect> Kernel for Look<'_, L, P> {
    type Output = Known;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> Known {
        let Self { prepared, row, pixel, offsets, batch, last } = self;
        let slope = Slope::new(prepared, row, pixel.first);
        let is_slanted = slope.is_slanted();
        if let Some(bytes) = bytes_within(prepared, slope.anywhere(), is_slanted, last) {
            offsets.pass_over(prepared.samples);
            return Known::Bytes(bytes);
        }
        batch.draw(prepared, pixel, offsets.stream());
        let means = [0, 1].map(|axis| sum(&batch.offset[axis][..pixel.count]) / pixel.count as f64);
        bytes_within(prepared, slope.at(means), is_slanted, last).map_or(Known::Drawn, Known::Bytes)
    }
}

/// A sum in no particular order, for a bound that allows for its rounding.
#[inline(always)]
fn sum(values: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (chunks, rest) = values.as_chunks::<8>();
    for chunk in chunks {
        for (sum, value) in sums.iter_mut().zip(chunk) {
            *sum += value;
        }
    }
    sums.iter().chain(rest).sum()
}

/// The bytes of a pixel whose mean of `s` is within `radius` of `middle`, if all such means give the same; channels that
/// are 0 or 1 at both ends are exact if the pixel [is slanted](Slope::is_slanted).
#[inline(always)]
fn bytes_within<L: Layout, P: Intersect>(
    prepared: &Prepared<L, P>,
    (middle, radius): (f64, f64),
    is_slanted: bool,
    last: &mut [u8; 3],
) -> Option<[u8; 3]> {
    let (dark, light) = (prepared.background.dark.to_array(), prepared.background.light.to_array());
    let rounding = rounding(prepared.samples);
    for channel in 0..3 {
        let difference = dark[channel] - light[channel];
        if is_slanted && difference == 0.0 && (light[channel] == 1.0 || light[channel] == 0.0) {
            last[channel] = prepared.quantizer.quantize(light[channel]);
            continue;
        }
        let mean = light[channel] + difference * ((middle + 1.0) / 2.0);
        let radius = difference.abs() * (radius / 2.0) + rounding;
        last[channel] = prepared.quantizer.quantize_interval(mean - radius, mean + radius, last[channel])?;
    }
    Some(*last)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::background::Background;
    use crate::config::Config;
    use crate::layout::Aos;
    use crate::scatter::Scatter;
    use crate::scene::Scene;
    use crate::simd::InstructionSet;

    fn prepared(text: &str) -> Prepared<Aos> {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        Prepared::new(&config, &Scene::default(), Scatter::Statement).expect("it can be rendered")
    }

    #[test]
    fn the_slope_bounds_the_background_over_the_pixel() {
        let mut draws = crate::rng::Uniform::new(3);
        for fov in [1.0, 20.0, 90.0, 150.0, 175.0] {
            let prepared = prepared(&format!("image_width: 12\nfield_of_view: {fov}\ncamera_north: 1 2 0\n"));
            let (mut tight, mut all) = (0, 0);
            for pixel in 0..prepared.size.pixels() {
                let (row, column) = (pixel / 12, pixel % 12);
                let slope = Slope::new(&prepared, row, column);
                for _ in 0..50 {
                    let offset = [draws.draw(-0.5, 0.5), draws.draw(-0.5, 0.5)];
                    let direction = prepared.camera.ray(row as f64, column as f64, offset).direction;
                    let s = direction.y / direction.length();
                    for (middle, radius) in [slope.anywhere(), slope.at(offset)] {
                        assert!((s - middle).abs() <= radius + 1e-14, "{fov} degrees, pixel {pixel}");
                    }
                    all += 1;
                    tight += u32::from(slope.rest < 0.5);
                }
            }
            assert!(fov > 90.0 || tight > all / 2, "the bound says nothing at {fov} degrees");
        }
    }

    #[test]
    fn draws_passed_over_are_skipped_before_the_next_is_made() {
        let (mut offsets, mut stream) = (Offsets::new(5), BlockUniform::new(5));
        offsets.pass_over(3);
        offsets.pass_over(200);
        stream.skip(406);
        let (mut left, mut right) = ([0.0; 5], [0.0; 5]);
        offsets.stream().fill(&mut left);
        stream.fill(&mut right);
        assert_eq!(left, right);
    }

    #[test]
    fn a_channel_of_ones_is_one_in_every_sample() {
        let background = Background { dark: Vec3::new(1.0, 0.0, 0.0), light: Vec3::new(1.0, 0.0, 1.0) };
        let mut draws = crate::rng::Uniform::new(3);
        for _ in 0..100_000 {
            let direction = Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            if (direction.y / direction.length()).abs() < 0.999 {
                let color = background.color(direction);
                assert_eq!((color.x, color.y), (1.0, 0.0), "{direction:?}");
            }
        }
    }

    #[test]
    fn a_uniform_background_needs_no_ray() {
        for color in [".3 .4 .5", "1 0 .5", "1 0 1"] {
            no_ray_is_needed(color);
        }
    }

    fn no_ray_is_needed(color: &str) {
        let text = format!("image_width: 40\nbackground_dark_color: {color}\nbackground_light_color: {color}\n");
        let prepared = prepared(&text);
        let mut batch = Batch::new();
        let mut offsets = Offsets::new(1);
        let mut last = [0; 3];
        for column in 0..40 {
            let span = Span { first: column, first_sample: 0, count: 20, last: column };
            let look = Look {
                prepared: &prepared,
                row: 3,
                pixel: &span,
                offsets: &mut offsets,
                batch: &mut batch,
                last: &mut last,
            };
            let known = InstructionSet::Portable.run(look);
            assert!(matches!(known, Known::Bytes(_)), "column {column}: {known:?}");
        }
        assert_eq!(offsets.passed_over, 40 * 40, "nothing was drawn");
    }
}
