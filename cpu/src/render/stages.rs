//! The stages of one span, each to be run alone: for benchmarks. `render.rs` says what they do, and in which order.

use crate::layout::aos::Aos;
use crate::render::prepared::Prepared;
use crate::simd::instruction_set::InstructionSet;

use crate::render::background_pixels::{BackgroundPixels, FindBytes};
use crate::render::frustum::Candidates;
use crate::render::path::PathTracer;
use crate::render::samples::{Batch, Draw};
use crate::render::span::{Span, Spans};
use crate::render::trace_paths::TracePaths;
use crate::render::{camera_rays, path_ends, specular_chains};
use crate::sampling::pixel_jitter::PixelJitter;

/// A span of a picture, and where its samples are on their way.
#[derive(Debug)]
pub struct Stages<'a> {
    prepared: &'a Prepared<Aos>,
    set: InstructionSet,
    row: usize,
    span: Span,
    offsets: PixelJitter,
    sky: BackgroundPixels,
    batch: Box<Batch>,
    tracer: Box<PathTracer>,
    candidates: Candidates,
}

impl<'a> Stages<'a> {
    /// The span of `row` that begins in or after `column`.
    ///
    /// # Panics
    /// When there is none.
    #[must_use]
    pub fn new(prepared: &'a Prepared<Aos>, set: InstructionSet, row: usize, column: usize) -> Self {
        let mut spans = Spans::of_row(prepared.size.width(), prepared.samples);
        let span = spans.find(|span| span.first >= column).expect("the row is longer");
        let mut stages = Self {
            prepared,
            set,
            row,
            span,
            offsets: PixelJitter::new(prepared.ray_seed),
            sky: BackgroundPixels::new(prepared),
            batch: Batch::new(),
            tracer: PathTracer::new(prepared),
            candidates: Candidates::new(prepared).expect("a benchmark's scene fits"),
        };
        stages.cull();
        stages
    }

    /// Samples of the span.
    #[must_use]
    pub const fn samples(&self) -> usize {
        self.span.count
    }

    /// Samples that wait for the glass stage, and for the walk.
    #[must_use]
    pub const fn waiting(&self) -> (usize, usize) {
        (self.batch.specular.count, self.tracer.queue.count)
    }

    /// Finds the candidates of the row and of the span.
    pub fn cull(&mut self) {
        self.candidates.begin_row(self.prepared, self.row);
        self.candidates.narrow(self.prepared, self.row, &self.span);
    }

    /// Looks for the bytes of the span's pixels without rays, as if no object reached it; says how many are known.
    pub fn sky(&mut self) -> usize {
        let (prepared, row, span) = (self.prepared, self.row, &self.span);
        let (mut done, mut known) = (0, 0);
        while done < span.width() {
            let (sky, offsets, batch) = (&mut self.sky, &mut self.offsets, &mut *self.batch);
            let to = self.set.run(FindBytes { prepared, row, span, done, sky, offsets, batch });
            known += to - done;
            done = to + 1;
        }
        known
    }

    /// Draws the samples' places.
    pub fn draw(&mut self) {
        let (prepared, span, offsets) = (self.prepared, &self.span, self.offsets.stream());
        self.set.run(Draw { prepared, span, offsets, batch: &mut self.batch });
    }

    /// Traces and shades the primary rays.
    pub fn primary(&mut self) {
        let (prepared, row, candidates) = (self.prepared, self.row, &self.candidates);
        let (batch, queue) = (&mut *self.batch, &mut self.tracer.queue);
        self.set.run(camera_rays::Trace { prepared, row, candidates, batch, queue });
    }

    /// Follows the samples in glass.
    pub fn glass(&mut self) {
        let (batch, queue) = (&mut *self.batch, &mut self.tracer.queue);
        self.set.run(specular_chains::Trace { prepared: self.prepared, batch, paths: queue });
    }

    /// Walks the waiting samples to their ends.
    pub fn walk(&mut self) {
        self.set.run(TracePaths { prepared: self.prepared, tracer: &mut self.tracer });
    }

    /// Gives the ended paths their colours.
    pub fn ends(&mut self) {
        let PathTracer { queue, ends, .. } = &mut *self.tracer;
        self.set.run(path_ends::Color { prepared: self.prepared, queue, ends, batch: &mut self.batch });
    }
}
