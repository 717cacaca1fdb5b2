//! Background pixels, which no object can reach. Most of them get their bytes from bounds of the background, without
//! any ray.
//!
//! 1. A span is a part of a row, of up to 32 pixels. Its candidates are the objects that frustum culling leaves. If a
//!    span has no candidates and only whole pixels, and bytes are wanted and not means, it is rendered here.
//!    `render.rs` decides this, and `FindBytes` in `render/stages.rs` asks for one pixel after the other.
//! 2. The mean of a channel lies in an interval, which follows from the
//!    [derivative](crate::render::background_derivative)
//!    of the background. If all means in the interval give the same byte, that is the channel's byte, and no number is
//!    drawn.
//! 3. Otherwise the offsets of the samples are drawn, and their mean gives a smaller interval.
//! 4. If the smaller interval does not give a single byte either, the pixel's rays are traced like all others.
//!
//! `image/quantize.rs` tells whether an interval gives a single byte. Neither the reference nor WGSL has this rule:
//! they trace every ray.
//!
//! If a bound is NaN, it is in no byte's interval, so the pixel is traced. If the magnitudes of camera or scene are
//! extreme, lengths may underflow and the derivative has no meaning. So in such a scene every pixel is traced
//! ([`Candidates::are_culled`](crate::render::frustum::Candidates::are_culled)).
//!
//! A channel may be 1 at both ends of the gradient, as the blue of the default background. It is then at a byte's
//! boundary, and no interval around it gives a single byte. But the channel is exactly 1 in every sample. With `m` in
//! `[0, 1]` the rounding error of `1 - m` is at most `2^-54`, and the sum `(1 - m) + m` is rounded to 1. If the error
//! is negative this may be a tie, which rounds to the even number 1. Sums of ones are exact. The same holds for a
//! channel that is 0 at both ends.

use crate::image::quantize::Quantizer;
use crate::layout::Layout;
use crate::math::real::Real;
use crate::render::background::interval;
use crate::render::background_derivative::{DerivativeBound, PixelReach};
use crate::render::span::{Span, WIDEST};
use crate::render::{prepared::Prepared, samples::Batch};
use crate::sampling::draw_order::PixelJitter;
use crate::simd::{MOST_LANES, SimdF64, columns::Columns};

/// Finds the bytes of pixels that no object reaches, without tracing rays, for the pixels of one [span](Span). The
/// [derivative bound](DerivativeBound) of the background gives an interval that holds a channel's mean. If all numbers
/// of the interval are quantised to the same byte, that byte is the channel's.
#[derive(Debug)]
pub struct BackgroundPixels {
    /// The bytes of the pixels that are done, in order.
    pub bytes: [[u8; 3]; WIDEST],
    /// The [`DerivativeBound`] of each pixel.
    derivatives: Columns<4, WIDEST>,
    /// The lowest and the highest mean that each channel can have, for any offsets of the samples.
    intervals: Columns<6, WIDEST>,
    /// The byte of a channel that is 0 at both ends of the gradient, or 1 at both. It is valid in pixels whose
    /// [weight is in the unit interval](DerivativeBound::weight_is_in_unit_interval).
    constant: [Option<u8>; 3],
    /// Bound of the rounding error of a channel's mean. It covers the errors of the samples' colours, each at most 1,
    /// and of their sum.
    rounding: f64,
    /// The bytes of the last pixel whose bytes the bounds gave. They are tried first for the next pixel, which mostly
    /// has the same bytes.
    last: [u8; 3],
}

/// Returns the lowest and the highest mean of red, then those of green, then those of blue. `mean` is the middle and
/// the radius of an interval that contains the mean of `s`; see [`interval`].
#[inline(always)]
fn intervals<T: Real, L: Layout>(prepared: &Prepared<L>, mean: (T, T), rounding: f64) -> [T; 6] {
    let (dark, light) = (prepared.background.dark, prepared.background.light);
    let [red_low, red_high] = interval(dark.x, light.x, mean, rounding);
    let [green_low, green_high] = interval(dark.y, light.y, mean, rounding);
    let [blue_low, blue_high] = interval(dark.z, light.z, mean, rounding);
    [red_low, red_high, green_low, green_high, blue_low, blue_high]
}

/// Returns a bound of the rounding error of a mean of so many samples: `8 u` for each, and `512 u`
/// (docs/margins.md).
pub fn rounding(samples: f64) -> f64 {
    (samples + 64.0) * 4.0 * f64::EPSILON
}

impl BackgroundPixels {
    /// Returns the state before the first span.
    pub(crate) fn new<L: Layout>(prepared: &Prepared<L>) -> Self {
        let background = &prepared.background;
        let constant = [0, 1, 2].map(|channel| {
            let (dark, light) = (background.dark.to_array()[channel], background.light.to_array()[channel]);
            (dark == light && (light == 0.0 || light == 1.0)).then(|| prepared.quantizer.quantize(light))
        });
        let rounding = rounding(prepared.samples as f64);
        let bytes = [[0; 3]; WIDEST];
        Self { bytes, derivatives: Columns::ZERO, intervals: Columns::ZERO, constant, rounding, last: [0; 3] }
    }

    /// Begins a span: computes the derivative bound and the intervals of each pixel, for any offsets of the samples.
    /// Each lane has one pixel.
    #[inline(always)]
    pub(super) fn begin<V: SimdF64, L: Layout>(&mut self, prepared: &Prepared<L>, row: usize, span: &Span) {
        let (camera, row) = (prepared.camera.lanes(), V::of(row as f64));
        let reach = PixelReach::new(&prepared.camera, &prepared.ray_error).lanes();
        for at in (0..span.width()).step_by(V::LANES) {
            let column = V::of((span.first + at) as f64) + V::load(&LANE_NUMBERS);
            let derivative = DerivativeBound::new(&camera, row, column, reach);
            self.derivatives.store(at, derivative.numbers());
            self.intervals.store(at, intervals(prepared, derivative.anywhere(), self.rounding));
        }
    }

    /// Returns the bytes of the pixel at index `at` of the span, or `None` if the bounds do not give them. After `None`
    /// the batch holds the pixel's samples, which must be traced.
    #[inline(always)]
    pub(super) fn find<L: Layout>(
        &mut self,
        prepared: &Prepared<L>,
        (span, at): (&Span, usize),
        pixel_jitter: &mut PixelJitter,
        batch: &mut Batch,
    ) -> Option<[u8; 3]> {
        let derivative = DerivativeBound::of(self.derivatives.get(at));
        if let Some(bytes) = self.bytes_within(&prepared.quantizer, self.intervals.get(at), &derivative) {
            pixel_jitter.pass_over(prepared.samples);
            return Some(bytes);
        }
        batch.draw(prepared, &span.pixel(at, prepared.samples), pixel_jitter);
        let [right, down] = &batch.offset.0;
        let offset = [right, down].map(|offsets| sum(&offsets[..batch.count]) / batch.count as f64);
        self.bytes_within(&prepared.quantizer, intervals(prepared, derivative.at(offset), self.rounding), &derivative)
    }

    /// Returns the bytes of a pixel whose means lie in these intervals. The result is `None` if the means of an
    /// interval may give different bytes.
    #[inline(always)]
    fn bytes_within(&mut self, table: &Quantizer, means: [f64; 6], derivative: &DerivativeBound) -> Option<[u8; 3]> {
        // A local copy: a load of three bytes that were just stored one by one waits until the stores are in the cache.
        let mut bytes = self.last;
        for (channel, &[low, high]) in means.as_chunks().0.iter().enumerate() {
            bytes[channel] = match self.constant[channel] {
                Some(byte) if derivative.weight_is_in_unit_interval() => byte,
                _ => table.quantize_interval(low, high, bytes[channel])?,
            };
        }
        self.last = bytes;
        Some(bytes)
    }
}

/// Returns the sum of the values. It has eight partial sums in lanes, which are added in pairs: three dependent
/// additions instead of eight. Its rounding differs from that of a sum in order. The bound `rounding` covers the
/// difference.
#[inline(always)]
fn sum(values: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (chunks, remainder) = values.as_chunks::<8>();
    for chunk in chunks {
        for (sum, value) in sums.iter_mut().zip(chunk) {
            *sum += value;
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    let remainder: f64 = remainder.iter().sum();
    (((a + e) + (c + g)) + ((b + f) + (d + h))) + remainder
}

/// The distance of each lane from the first.
const LANE_NUMBERS: [f64; MOST_LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::quantize::quantize;
    use crate::input::config::Config;
    use crate::input::scene::Scene;
    use crate::layout::aos::Aos;
    use crate::math::vec3::Vec3;
    use crate::render::stages::{DrawSamples, FindBytes};
    use crate::render::{background::Background, limits::Limits, span_state::SpanState};
    use crate::sampling::block::BlockUniform;
    use crate::sampling::scatter_vectors::Scatter;
    use crate::simd::instruction_set::InstructionSet;

    fn prepared(text: &str) -> Prepared<Aos> {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        Prepared::new(&config, Scene::default(), Scatter::Statement).expect("it can be rendered")
    }

    #[test]
    fn a_sum_has_every_value_once() {
        // Sums of whole numbers are exact, so a value that is left out or counted twice shows.
        let values: Vec<f64> = (0..40_u32).map(|number| f64::from(number * number + 1)).collect();
        for count in 0..=values.len() {
            assert_eq!(sum(&values[..count]), values[..count].iter().sum::<f64>(), "{count}");
        }
    }

    #[test]
    fn a_channel_of_ones_is_one_in_every_sample() {
        let background = Background { dark: Vec3::new(1.0, 0.0, 0.0), light: Vec3::new(1.0, 0.0, 1.0) };
        let mut draws = crate::sampling::uniform::Uniform::new(3);
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
        let mut state = SpanState::new(&prepared, InstructionSet::Portable, &Limits::default()).expect("it fits");
        state.row = 3;
        let span = Span { first: 8, first_sample: 0, count: 640, last: 39 };
        let find = FindBytes { state: &mut state, span: &span, done: 0 };
        assert_eq!(InstructionSet::Portable.run(find), 32, "all is known of {color}");
        let bytes = prepared.background.light.to_array().map(|channel| quantize(channel, Config::default().gamma));
        assert_eq!(state.background_pixels.bytes, [bytes; WIDEST], "{color}");
        assert_eq!(state.batch.count, 0, "nothing was drawn");
        let (mut expected, mut stream) = ([0.0; 2], BlockUniform::new(Config::default().ray_rng_seed));
        stream.skip(2 * 640);
        stream.fill(&mut expected);
        InstructionSet::Portable.run(DrawSamples(&mut state, &Span { count: 1, last: 8, ..span }));
        let next = state.batch.offset.get(0);
        assert_eq!(next, expected.map(|u| u - 0.5), "all is passed over");
    }
}
