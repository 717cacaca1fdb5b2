//! Spans: consecutive samples of a row of pixels.

use std::ops::Range;

use crate::render::arrays::CAPACITY;

/// Largest width of a span, in pixels. In a wider span each ray would be tested against more candidates. A span may be
/// narrower. This constant is a multiple of every instruction set's number of lanes, because it is the length of arrays
/// that are stored in whole lanes.
pub const WIDEST: usize = 32;

/// Consecutive samples over consecutive pixels of a row. They begin with sample `first_sample` of the pixel in column
/// `first`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// Column of the first pixel.
    pub first: usize,
    /// Number of samples of the first pixel that belong to earlier spans.
    pub first_sample: u64,
    /// Number of samples.
    pub count: usize,
    /// Column of the last pixel.
    pub last: usize,
}

impl Span {
    /// Returns the number of pixels. Pixels that are only partly in the span count too.
    #[inline(always)]
    pub const fn width(&self) -> usize {
        self.last - self.first + 1
    }

    /// Whether the span has all samples of each of its pixels. `samples` is the number of samples of each pixel.
    pub(crate) const fn is_whole(&self, samples: u64) -> bool {
        self.first_sample == 0 && self.count as u64 == self.width() as u64 * samples
    }

    /// Returns the column of every pixel, with the indices of the pixel's samples in the span. `samples` is the number
    /// of samples of each pixel.
    #[inline(always)]
    pub(crate) fn pixels(&self, samples: u64) -> impl Iterator<Item = (usize, Range<usize>)> {
        let (count, mut left, mut to) = (self.count, samples - self.first_sample, 0);
        (self.first..=self.last).map(move |column| {
            let from = to;
            to = usize::try_from(left).map_or(count, |left| count.min(from.saturating_add(left)));
            left = samples;
            (column, from..to)
        })
    }

    /// Returns the span that has only the pixel at index `at` of this span. `samples` is the number of samples of each
    /// pixel, and this span must have all samples of its pixels.
    #[inline(always)]
    pub(crate) const fn pixel(&self, at: usize, samples: u64) -> Self {
        debug_assert!(self.is_whole(samples));
        let column = self.first + at;
        Self { first: column, first_sample: 0, count: samples as usize, last: column }
    }
}

/// The spans of a row of `width` pixels with `samples` samples each, in order. Each has at most `most` samples
/// in at most [`WIDEST`] pixels. `most` must not exceed the length of the arrays of a span (`render/arrays.rs`).
pub fn spans_of_row(width: usize, samples: u64, most: usize) -> impl Iterator<Item = Span> {
    debug_assert!(most <= CAPACITY);
    let (mut column, mut sample) = (0, 0);
    std::iter::from_fn(move || {
        if column == width {
            return None;
        }
        let (first, first_sample) = (column, sample);
        let room = most as u64;
        let left_in_pixel = samples - first_sample;
        if left_in_pixel > room {
            sample += room;
            return Some(Span { first, first_sample, count: most, last: first });
        }
        // The span has the rest of the first pixel, then as many whole pixels as fit.
        let whole = ((room - left_in_pixel) / samples).min(WIDEST as u64 - 1) as usize;
        let whole = whole.min(width - first - 1);
        (column, sample) = (first + 1 + whole, 0);
        let count = (left_in_pixel + whole as u64 * samples) as usize;
        Some(Span { first, first_sample, count, last: first + whole })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spans(width: usize, samples: u64, most: usize) -> Vec<Span> {
        spans_of_row(width, samples, most).collect()
    }

    #[test]
    fn spans_cover_a_row_in_order() {
        for (width, samples) in [(1, 1), (100, 1), (33, 20), (7, 300), (3, CAPACITY as u64), (2, 5000), (5, 1025)] {
            for most in [CAPACITY, 32] {
                let all = spans(width, samples, most);
                let total: u64 = all.iter().map(|span| span.count as u64).sum();
                assert_eq!(total, width as u64 * samples, "{width} pixels of {samples}");
                let mut position = 0;
                for span in &all {
                    let mut next = 0;
                    for (column, range) in span.pixels(samples) {
                        let first = span.first as u64 * samples + span.first_sample + range.start as u64;
                        assert_eq!((range.start, column as u64), (next, first / samples));
                        next = range.end;
                    }
                    assert_eq!(next, span.count);
                    assert_eq!(span.first as u64 * samples + span.first_sample, position);
                    position += span.count as u64;
                    assert_eq!(span.last as u64, (position - 1) / samples);
                    assert!(span.count <= most && span.last - span.first < WIDEST);
                }
            }
        }
    }

    #[test]
    fn a_span_of_whole_pixels_falls_into_them() {
        let span = Span { first: 3, first_sample: 0, count: 40, last: 4 };
        let one = |column| Span { first: column, first_sample: 0, count: 20, last: column };
        assert_eq!((span.width(), span.pixel(0, 20), span.pixel(1, 20)), (2, one(3), one(4)));
        assert!(span.is_whole(20) && !span.is_whole(30));
        assert!(!Span { first_sample: 20, count: 20, ..span }.is_whole(20));
    }

    #[test]
    fn the_first_span_of_a_pixel_with_most_samples_is_full() {
        let first = spans_of_row(1, u64::MAX, CAPACITY).next();
        assert_eq!(first, Some(Span { first: 0, first_sample: 0, count: CAPACITY, last: 0 }));
    }
}
