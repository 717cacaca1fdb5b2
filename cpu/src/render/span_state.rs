//! The data that all stages of a span use, and that are reused for the next span. `render.rs` runs the stages.

use crate::render::{
    background_pixels::BackgroundPixels, boxed::Boxed, frustum::Candidates, limits::Limits, path::PathTracer,
    prepared::Prepared, samples::Batch,
};
use crate::{
    accel::stack::Stack, input::error::Error, layout::Layout, sampling::draw_order::PixelJitter,
    sampling::scatter_stream::ScatterSamples, sampling::scatter_vectors::Scatter,
    simd::instruction_set::InstructionSet,
};

/// The random streams of a picture: the offsets of the samples, and the scatter samples.
pub struct Streams<'a>(&'a mut PixelJitter, &'a mut ScatterSamples);

impl Streams<'_> {
    /// Calls `visit` with each word of the states of both streams, to read or to replace it.
    pub fn visit(&mut self, mut visit: impl FnMut(&mut u64)) {
        self.0.visit(&mut visit);
        self.1.visit(&mut visit);
    }

    /// Returns the number of scatter samples that surfaces have taken since row 0. A picture that began later counts
    /// from an unknown number.
    #[must_use]
    #[cfg(any(feature = "internals", test))]
    pub const fn scatter_samples(&self) -> u64 {
        self.1.taken()
    }

    /// Returns the number of words that [`Streams::visit`] visits. It is the same for all pictures.
    #[must_use]
    pub fn count() -> usize {
        let mut samples = ScatterSamples::new(Scatter::Deterministic, 1, InstructionSet::Portable);
        let mut count = 0;
        Streams(&mut PixelJitter::new(1), &mut samples).visit(|_| count += 1);
        count
    }
}

/// The prepared scene, and all that the stages of a span read and write. It is reused for every span.
pub struct SpanState<'a, L: Layout> {
    /// The prepared scene.
    pub prepared: &'a Prepared<L>,
    /// The row of the span, from 0 at the top.
    pub row: usize,
    /// The objects that rays of the row and of the span may hit.
    pub candidates: Candidates,
    /// The stream of the samples' offsets in their pixels.
    pub pixel_jitter: PixelJitter,
    /// Bounds of the pixels that no object can reach.
    pub background_pixels: BackgroundPixels,
    /// The samples of the span.
    pub batch: Boxed<Batch>,
    /// The paths of the span.
    pub tracer: Boxed<PathTracer>,
    /// The traversal stack of the acceleration structure.
    pub stack: Boxed<Stack>,
}

impl<'a, L: Layout> SpanState<'a, L> {
    /// Returns the state before the first span of a picture with these limits. `set` is the instruction set that makes
    /// the scatter samples: the one that renders the picture.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn new(prepared: &'a Prepared<L>, set: InstructionSet, limits: &Limits) -> Result<Self, Error> {
        Ok(Self {
            prepared,
            row: 0,
            candidates: Candidates::new(prepared)?,
            pixel_jitter: PixelJitter::new(prepared.ray_seed),
            background_pixels: BackgroundPixels::new(prepared),
            batch: Batch::new()?,
            tracer: PathTracer::new(prepared, set, limits)?,
            stack: Boxed::new(|| Stack::EMPTY)?,
        })
    }

    /// Returns the random streams. Between two rows they are where the next row begins.
    pub(crate) fn streams(&mut self) -> Streams<'_> {
        Streams(&mut self.pixel_jitter, &mut self.tracer.scatter_samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scatter_samples_are_counted_from_the_first_one() {
        let mut samples = ScatterSamples::new(Scatter::Statement, 1, InstructionSet::Portable);
        let mut jitter = PixelJitter::new(1);
        for count in 0..2000 {
            assert_eq!(Streams(&mut jitter, &mut samples).scatter_samples(), count);
            samples.prepare();
            let _ = samples.next();
        }
    }
}
