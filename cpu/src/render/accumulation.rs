//! The mean of a pixel's samples, summed in their order.

use crate::math::vec3::Vec3;
use crate::render::samples::Batch;
use crate::render::span::Span;

/// The sum of the pixel that is under way.
#[derive(Debug)]
pub struct Sums {
    samples: u64,
    sum: Vec3,
}

impl Sums {
    /// No sample yet, of `samples` a pixel.
    pub const fn new(samples: u64) -> Self {
        Self { samples, sum: Vec3::ZERO }
    }

    /// Adds the span's samples and hands every pixel that is complete to `pixel`, with its column.
    #[inline(always)]
    pub fn add(&mut self, span: &Span, batch: &Batch, mut pixel: impl FnMut(usize, Vec3)) {
        let mut taken = span.first_sample;
        let (mut column, mut from) = (span.first, 0);
        while from < span.count {
            let left = usize::try_from(self.samples - taken).unwrap_or(usize::MAX);
            let to = span.count.min(from.saturating_add(left));
            let mut sum = self.sum;
            for sample in from..to {
                sum = sum + batch.color.get(sample);
            }
            if to - from == left {
                pixel(column, sum / self.samples as f64);
                self.sum = Vec3::ZERO;
            } else {
                self.sum = sum;
            }
            (from, column, taken) = (to, column + 1, 0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_may_take_several_spans_and_a_span_several_pixels() {
        let mut batch = Batch::new();
        for sample in 0..8 {
            batch.color.set(sample, Vec3::splat(sample as f64));
        }
        let mut sums = Sums::new(4);
        let mut means = Vec::new();
        // The last three samples of pixel 0, all of pixel 1, one of pixel 2.
        sums.sum = Vec3::splat(1.0);
        let span = Span { first: 0, first_sample: 1, count: 8, last: 2 };
        sums.add(&span, &batch, |column, mean| means.push((column, mean.x)));
        assert_eq!(means, [(0, (1.0 + 0.0 + 1.0 + 2.0) / 4.0), (1, (3.0 + 4.0 + 5.0 + 6.0) / 4.0)]);
        assert_eq!(sums.sum, Vec3::splat(7.0));
    }
}
