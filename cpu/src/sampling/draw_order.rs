//! The order of the random draws, which decides every byte (specification, sections 7.3 and 11).
//!
//! 1. Pixels follow row by row, and the samples of a pixel one after the other. Each path ends before the next begins.
//! 2. A sample takes two random numbers of the generator of rays: its offset in the pixel to the right, then down.
//!    [`PixelJitter`] draws them.
//! 3. A hit on a matte or metal surface takes one scatter sample of the generator of materials: x, then y, then z. The
//!    surface takes the sample even at the maximum depth, where no ray follows. A refractive surface takes none.
//!    [`ScatterSamples`](crate::sampling::scatter_stream::ScatterSamples) makes the scatter samples.
//!
//! Numbers that can change no byte are not drawn. There are three such cases: deterministic mode; background pixels
//! with bytes that are known without a ray ([`PixelJitter::pass_over`]); and scenes in which `needs_samples` of
//! `render/prepared.rs` finds no material for which a scatter sample matters at this maximum depth. The reference's
//! copy of the rule is in `reference.rs` (`render_recorded` and `scatter`), and the copy in WGSL is in
//! `trace_samples.wgsl`.
//!
//! The order follows from the loops over rows in `render.rs` and over the pixels of a span in `render/span.rs`. Which
//! samples take random numbers is decided in `render/samples.rs`, and which surfaces take a scatter sample in
//! `takes_scatter_sample` of `materials/prepared.rs`. `render/path.rs`, `render/trace_paths.rs` and
//! `render/lookahead.rs` take the samples. Specular chains do not end in the order of the samples; `merge` in
//! `render/queue.rs` restores it. How many numbers a sample takes depends on the convention
//! (`sampling/scatter_vectors.rs`).

use crate::sampling::block::BlockUniform;
use crate::{counters::Counter, counters::add, geometry::camera::HALF_PIXEL, simd::columns::Columns};

/// Number of random numbers for the position of one sample in its pixel: one to the right, one down.
pub const DRAWS_OF_OFFSET: usize = 2;

/// Number of random numbers for one scatter sample. The published convention draws them again until their vector is in
/// the unit ball (specification, section 11.2).
pub const DRAWS_OF_SCATTER_SAMPLE: usize = 3;

/// The stream of the samples' offsets in their pixels. Samples that need no offset are passed over: their random
/// numbers are only counted. The next draw skips all of them at once.
#[derive(Debug)]
pub struct PixelJitter {
    stream: BlockUniform,
    passed_over: u64,
}

impl PixelJitter {
    /// Returns the stream with a generator that starts from `seed`.
    pub(crate) fn new(seed: u64) -> Self {
        Self { stream: BlockUniform::new(seed), passed_over: 0 }
    }

    /// Calls `visit` with each word of the stream's state, after skipping the random numbers that were passed over.
    pub(crate) fn visit(&mut self, visit: &mut impl FnMut(&mut u64)) {
        self.stream.skip(std::mem::take(&mut self.passed_over));
        self.stream.visit(visit);
    }

    /// Passes over the offsets of the next `samples` samples.
    #[inline(always)]
    pub(crate) fn pass_over(&mut self, samples: u64) {
        let draws = DRAWS_OF_OFFSET as u64 * samples;
        self.passed_over += draws;
        add(Counter::RayDrawsSkipped, draws);
    }

    /// Draws the offsets of the next `count` samples, in pixels, each in `[-1/2, 1/2)`. `draws` is memory for the
    /// random numbers of these samples.
    #[inline(always)]
    pub(crate) fn draw<const LENGTH: usize>(
        &mut self,
        count: usize,
        draws: &mut [f64],
        offsets: &mut Columns<DRAWS_OF_OFFSET, LENGTH>,
    ) {
        add(Counter::RayDraws, (DRAWS_OF_OFFSET * count) as u64);
        let draws = &mut draws[..DRAWS_OF_OFFSET * count];
        self.next_draws(draws);
        // By the specification a draw in [-1/2, 1/2) is u * 1 - 1/2, and the factor 1 changes nothing.
        let [rights, downs] = &mut offsets.0;
        for (&[x, y], (right, down)) in draws.as_chunks().0.iter().zip(rights.iter_mut().zip(downs)) {
            (*right, *down) = (x - HALF_PIXEL, y - HALF_PIXEL);
        }
    }

    /// Skips the random numbers that were passed over, and fills `draws` with the next ones.
    #[inline(always)]
    fn next_draws(&mut self, draws: &mut [f64]) {
        if self.passed_over > 0 {
            self.stream.skip(self.passed_over);
            self.passed_over = 0;
        }
        self.stream.fill(draws);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_passed_over_are_skipped_before_the_next_is_made() {
        let (mut jitter, mut stream) = (PixelJitter::new(5), BlockUniform::new(5));
        jitter.pass_over(3);
        jitter.pass_over(100);
        stream.skip(206);
        let (mut actual, mut expected) = ([0.0; 5], [0.0; 5]);
        jitter.next_draws(&mut actual);
        stream.fill(&mut expected);
        assert_eq!(actual, expected);
    }

    #[test]
    fn a_sample_is_placed_to_the_right_and_then_down() {
        let (mut jitter, mut stream) = (PixelJitter::new(7), BlockUniform::new(7));
        let (mut draws, mut offsets) = ([0.0; 32], Columns::<2, 16>::ZERO);
        jitter.draw(11, &mut draws, &mut offsets);
        for at in 0..11 {
            let mut expected = [0.0; 2];
            stream.fill(&mut expected);
            assert_eq!(offsets.get(at), expected.map(|u| u - 0.5));
        }
    }
}
