//! Pixels that no object can reach, most of them without tracing a ray.
//!
//! Such a pixel's colour is the mean of the background over its samples, and the background is smooth: the
//! [slope](crate::render::background_slope) of `s`, on which it depends alone, tells the mean of `s` up to a small rest
//! once the means of the samples' places are known, and up to half of the slope's part without even these. Where all
//! means in that interval give the same byte, that is the pixel's byte, and its rays need not be traced, its places
//! mostly not even drawn.
//!
//! What is not a number, or not finite, is in no byte's interval, so such a pixel is traced. Where the magnitudes of
//! camera and scene are extreme, lengths underflow and the slope means nothing: there every pixel is traced
//! (`Painter::row`).
//!
//! A channel that is 1 at both ends, as the blue of the default sky, is at a byte's boundary, where no interval has one
//! byte. But it is exactly 1 in every sample: with `m` in `[0, 1]` the rounding error of `1 - m` is at most `2^-54`,
//! and the sum `(1 - m) + m` rounds to 1 with it (below 1 that is a tie, and 1 is even). Sums of ones are exact.
//! Likewise 0.

use crate::layout::Layout;
use crate::math::real::Real;
use crate::render::background_slope::{DerivativeBound, DerivativeBounds};
use crate::render::prepared::Prepared;
use crate::render::samples::Batch;
use crate::render::span::{Span, WIDEST};
use crate::sampling::pixel_jitter::PixelJitter;
use crate::simd::{Kernel, Simd, SimdF64};

/// Rounding of a channel's mean: of each sample's colour, and of their sum, relative to colours of at most one.
fn rounding(samples: u64) -> f64 {
    (samples as f64 + 64.0) * 4.0 * f64::EPSILON
}

/// What is known of a span's pixels.
#[derive(Debug)]
pub struct BackgroundPixels {
    /// The bytes of those looked at, in order.
    pub bytes: [[u8; 3]; WIDEST],
    slopes: DerivativeBounds,
    /// Between what each channel's mean lies, wherever the samples are.
    anywhere: [Between<[f64; WIDEST]>; 3],
    /// The byte of a channel that is 0 or 1 at both ends, in pixels that [are
    /// slanted](crate::render::background_slope::DerivativeBound::is_slanted).
    constant: [Option<u8>; 3],
    rounding: f64,
    /// The bytes of the last pixel found: the next one's mostly are the same.
    last: [u8; 3],
}

/// Bounds of a number.
#[derive(Clone, Copy, Debug)]
struct Between<T = f64> {
    low: T,
    high: T,
}

impl<T: Real> Between<T> {
    /// Bounds of the mean of a channel, where that of `s` is within `radius` of `middle`.
    #[inline(always)]
    fn new(dark: T, light: T, (middle, radius): (T, T), rounding: T) -> Self {
        let half = T::of(0.5);
        let difference = dark - light;
        let mean = light + difference * ((middle + T::of(1.0)) * half);
        let radius = difference.abs() * (radius * half) + rounding;
        Self { low: mean - radius, high: mean + radius }
    }
}

impl BackgroundPixels {
    /// Nothing yet.
    pub fn new<L: Layout>(prepared: &Prepared<L>) -> Self {
        let background = &prepared.background;
        let constant = [0, 1, 2].map(|channel| {
            let (dark, light) = (background.dark.to_array()[channel], background.light.to_array()[channel]);
            (dark == light && (light == 0.0 || light == 1.0)).then(|| prepared.quantizer.quantize(light))
        });
        Self {
            bytes: [[0; 3]; WIDEST],
            slopes: DerivativeBounds::new(&prepared.camera),
            anywhere: [Between { low: [0.0; WIDEST], high: [0.0; WIDEST] }; 3],
            constant,
            rounding: rounding(prepared.samples),
            last: [0; 3],
        }
    }

    /// Begins with the span's pixels: finds what needs no places of samples, as many pixels at once as there are lanes.
    #[inline(always)]
    fn begin<V: SimdF64, L: Layout>(&mut self, prepared: &Prepared<L>, row: usize, span: &Span) {
        let (dark, light) = (prepared.background.dark.to_array(), prepared.background.light.to_array());
        self.slopes.find::<V>(&prepared.camera, row, span.first, span.width());
        for at in (0..span.width()).step_by(V::LANES) {
            let anywhere = self.slopes.lanes::<V>(at).anywhere();
            for channel in 0..3 {
                let (dark, light, rounding) = (V::of(dark[channel]), V::of(light[channel]), V::of(self.rounding));
                let Between { low, high } = Between::new(dark, light, anywhere, rounding);
                low.store(&mut self.anywhere[channel].low[at..]);
                high.store(&mut self.anywhere[channel].high[at..]);
            }
        }
    }

    /// Looks for the bytes of the span's pixel `at`; if they cannot be known, its samples have been drawn into the
    /// batch.
    #[inline(always)]
    fn look<V: SimdF64, L: Layout>(
        &mut self,
        prepared: &Prepared<L>,
        span: &Span,
        at: usize,
        (offsets, batch): (&mut PixelJitter, &mut Batch),
    ) -> Option<[u8; 3]> {
        let slope = self.slopes.of(at);
        let anywhere = [0, 1, 2].map(|channel| {
            let Between { low, high } = &self.anywhere[channel];
            Between { low: low[at], high: high[at] }
        });
        if let Some(bytes) = self.bytes_within(prepared, anywhere, &slope) {
            offsets.pass_over(prepared.samples);
            return Some(bytes);
        }
        batch.draw::<V, L>(prepared, &span.pixel(at, prepared.samples), offsets.stream());
        let means = [0, 1].map(|axis| sum(&batch.offset[axis][..batch.count]) / batch.count as f64);
        let (dark, light) = (prepared.background.dark.to_array(), prepared.background.light.to_array());
        let there =
            [0, 1, 2].map(|channel| Between::new(dark[channel], light[channel], slope.at(means), self.rounding));
        self.bytes_within(prepared, there, &slope)
    }

    /// The bytes of a pixel whose channels' means are in these intervals, if all such means give the same.
    #[inline(always)]
    fn bytes_within<L: Layout>(
        &mut self,
        prepared: &Prepared<L>,
        means: [Between; 3],
        slope: &DerivativeBound,
    ) -> Option<[u8; 3]> {
        for (channel, Between { low, high }) in means.into_iter().enumerate() {
            self.last[channel] = match self.constant[channel] {
                Some(byte) if slope.is_slanted() => byte,
                _ => prepared.quantizer.quantize_interval(low, high, self.last[channel])?,
            };
        }
        Some(self.last)
    }
}

/// Finds the bytes of the pixels of a span that no object can reach, as far as they can be known; returns how many,
/// from the first on. If that is not all, the next one's samples, drawn into the batch, must be traced.
pub struct FindBytes<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub row: usize,
    /// Made of whole pixels.
    pub span: &'a Span,
    /// Pixels of it that are done.
    pub done: usize,
    pub sky: &'a mut BackgroundPixels,
    pub offsets: &'a mut PixelJitter,
    pub batch: &'a mut Batch,
}

impl<L: Layout> Kernel for FindBytes<'_, L> {
    type Output = usize;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> usize {
        let Self { prepared, row, span, done, sky, offsets, batch } = self;
        let count = span.width();
        if done == 0 {
            sky.begin::<S::F64, L>(prepared, row, span);
        }
        for at in done..count {
            match sky.look::<S::F64, L>(prepared, span, at, (offsets, batch)) {
                Some(bytes) => sky.bytes[at] = bytes,
                None => return at,
            }
        }
        count
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::quantize::quantize;
    use crate::input::config::Config;
    use crate::input::scene::Scene;
    use crate::layout::aos::Aos;
    use crate::math::vec3::Vec3;
    use crate::render::background::Background;
    use crate::sampling::block::BlockUniform;
    use crate::sampling::scatter_vectors::Scatter;
    use crate::simd::instruction_set::InstructionSet;

    fn prepared(text: &str) -> Prepared<Aos> {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        Prepared::new(&config, &Scene::default(), Scatter::Statement).expect("it can be rendered")
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
        let (mut sky, mut offsets, mut batch) = (BackgroundPixels::new(&prepared), PixelJitter::new(1), Batch::new());
        let span = Span { first: 8, first_sample: 0, count: 640, last: 39 };
        let look = FindBytes {
            prepared: &prepared,
            row: 3,
            span: &span,
            done: 0,
            sky: &mut sky,
            offsets: &mut offsets,
            batch: &mut batch,
        };
        assert_eq!(InstructionSet::Portable.run(look), 32, "all is known of {color}");
        let bytes = prepared.background.light.to_array().map(|channel| quantize(channel, Config::default().gamma));
        assert_eq!(sky.bytes, [bytes; WIDEST], "{color}");
        let (mut next, mut expected, mut stream) = ([0.0], [0.0], BlockUniform::new(1));
        stream.skip(2 * 640);
        stream.fill(&mut expected);
        offsets.stream().fill(&mut next);
        assert_eq!((batch.count, next), (0, expected), "nothing was drawn, and all is passed over");
    }
}
