//! The samples of a span: an array for each number, so that lanes handle several samples at once.

use crate::render::{
    arrays::CAPACITY, arrays::ROOM, arrays::Values, boxed::Boxed, prepared::Prepared, queue::PathQueue, queue::Queue,
    queue::SpecularQueue, span::Span,
};
use crate::{
    accel::bvh::stack::Stack, input::error::Error, layout::Layout, sampling::draw_order::PixelJitter,
    sampling::scatter_vectors::Scatter, simd::SimdF64, simd::columns::Columns,
};

/// The samples of a span.
#[derive(Debug)]
pub struct Batch {
    /// Number of samples.
    pub count: usize,
    /// Column of each sample's pixel.
    pub column: Values,
    /// Offsets in their pixels, to the right and down.
    pub offset: Columns<2, ROOM>,
    /// Samples whose ray has just hit a refractive surface.
    pub specular: SpecularQueue,
    /// Samples whose specular chain has ended on a surface that scatters.
    pub chained: PathQueue,
    /// Colours of the samples, linear; those of samples in a queue are not known yet.
    pub color: Columns<3, ROOM>,
    /// Traversal stack of the acceleration structure.
    pub stack: Stack,
    draws: [f64; 2 * CAPACITY],
}

impl Batch {
    /// No samples.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new() -> Result<Boxed<Self>, Error> {
        Boxed::new(Self {
            count: 0,
            column: [0.0; ROOM],
            offset: Columns::ZERO,
            specular: Queue::EMPTY,
            chained: Queue::EMPTY,
            color: Columns::ZERO,
            stack: Stack::EMPTY,
            draws: [0.0; 2 * CAPACITY],
        })
    }

    /// Replaces the samples by those of a span, and draws their offsets.
    #[inline(always)]
    pub fn draw<V: SimdF64, L: Layout>(&mut self, prepared: &Prepared<L>, span: &Span, pixel_jitter: &mut PixelJitter) {
        self.count = span.count;
        for (column, samples) in span.pixels(prepared.samples) {
            self.column[samples].fill(column as f64);
        }
        if prepared.scatter != Scatter::Deterministic {
            pixel_jitter.draw::<V, ROOM>(span.count, &mut self.draws, &mut self.offset);
        }
    }
}
