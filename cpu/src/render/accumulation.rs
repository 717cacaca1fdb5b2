//! Computes the mean of a pixel's samples. They are summed in their order.

use crate::{math::vec3::Vec3, render::samples::Batch, render::span::Span};

/// Computes the mean colours of pixels from the samples of one [span](Span) after the other. It holds the sum of the
/// pixel whose samples are not complete yet. The samples of a pixel may be spread over several spans, because a span
/// has at most 1,024 samples.
#[derive(Debug)]
pub struct Accumulator {
    /// Number of samples of each pixel.
    samples: u64,
    /// Number of samples that `sum` contains.
    summed: u64,
    sum: Vec3,
}

impl Accumulator {
    /// Returns an empty sum, for pixels of `samples` samples each.
    pub(crate) const fn new(samples: u64) -> Self {
        Self { samples, summed: 0, sum: Vec3::ZERO }
    }

    /// Adds the samples of a span. Their colours are in `batch`. Calls `pixel` with the column and the mean colour of
    /// every pixel whose samples are then complete.
    #[inline(always)]
    pub(crate) fn add(&mut self, span: &Span, batch: &Batch, mut pixel: impl FnMut(usize, Vec3)) {
        for (column, samples) in span.pixels(self.samples) {
            self.summed += samples.len() as u64;
            self.sum = samples.fold(self.sum, |sum, sample| sum + batch.color.get(sample).into());
            if self.summed == self.samples {
                pixel(column, self.sum / self.samples as f64);
                *self = Self::new(self.samples);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_may_take_several_spans_and_a_span_several_pixels() {
        let mut batch = Batch::new().expect("it fits");
        for sample in 0..8 {
            batch.color.set(sample, [sample as f64; 3]);
        }
        let mut accumulator = Accumulator::new(4);
        let mut means = Vec::new();
        // This span has the last three samples of pixel 0, all samples of pixel 1 and one sample of pixel 2.
        (accumulator.sum, accumulator.summed) = (Vec3::splat(1.0), 1);
        let span = Span { first: 0, first_sample: 1, count: 8, last: 2 };
        accumulator.add(&span, &batch, |column, mean| means.push((column, mean.x)));
        assert_eq!(means, [(0, (1.0 + 0.0 + 1.0 + 2.0) / 4.0), (1, (3.0 + 4.0 + 5.0 + 6.0) / 4.0)]);
        assert_eq!(accumulator.sum, Vec3::splat(7.0));
    }
}
