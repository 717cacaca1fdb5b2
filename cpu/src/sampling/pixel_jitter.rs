//! The stream of the samples' places in their pixels.

use crate::counters::{Counter, add};
use crate::sampling::block::BlockUniform;

/// The stream, with draws that have been passed over but not yet skipped.
#[derive(Debug)]
pub struct PixelJitter {
    stream: BlockUniform,
    passed_over: u64,
}

impl PixelJitter {
    /// At the beginning of the stream.
    pub fn new(seed: u64) -> Self {
        Self { stream: BlockUniform::new(seed), passed_over: 0 }
    }

    /// Passes over the draws of a pixel.
    #[inline(always)]
    pub fn pass_over(&mut self, samples: u64) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_passed_over_are_skipped_before_the_next_is_made() {
        let (mut offsets, mut stream) = (PixelJitter::new(5), BlockUniform::new(5));
        offsets.pass_over(3);
        offsets.pass_over(200);
        stream.skip(406);
        let (mut left, mut right) = ([0.0; 5], [0.0; 5]);
        offsets.stream().fill(&mut left);
        stream.fill(&mut right);
        assert_eq!(left, right);
    }
}
