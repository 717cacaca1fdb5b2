//! The samples of a span. There is an array for each of their numbers, so that lanes handle several samples at once.

use crate::render::{
    arrays::CAPACITY, arrays::ROOM, arrays::Values, boxed::Boxed, lane_numbers::SampleIndex, prepared::Prepared,
    queue::PathQueue, queue::Queue, queue::SpecularQueue, span::Span,
};
use crate::{
    input::error::Error, layout::Layout, sampling::draw_order::DRAWS_OF_OFFSET, sampling::draw_order::PixelJitter,
    sampling::scatter_vectors::Scatter, simd::columns::Columns,
};

/// The samples of a span, with an array for each of their numbers.
#[derive(Debug)]
pub struct Batch {
    /// Number of samples.
    pub count: usize,
    /// The column of each sample's pixel.
    pub column: Values,
    /// The offset of each sample from the middle of its pixel, in pixels, to the right and down.
    pub offset: Columns<DRAWS_OF_OFFSET, ROOM>,
    /// The samples whose last ray has hit a refractive surface.
    pub specular: SpecularQueue,
    /// The samples whose specular chain has ended on a matte or metal surface.
    pub chained: PathQueue,
    /// The linear colour of each sample. The colours of samples that are in a queue are not known yet.
    pub color: Columns<3, ROOM>,
    draws: [f64; DRAWS_OF_OFFSET * CAPACITY],
}

impl Batch {
    /// Returns a batch without samples.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn new() -> Result<Boxed<Self>, Error> {
        Boxed::new(|| Self {
            count: 0,
            column: [0.0; ROOM],
            offset: Columns::ZERO,
            specular: Queue::EMPTY,
            chained: Queue::EMPTY,
            color: Columns::ZERO,
            draws: [0.0; DRAWS_OF_OFFSET * CAPACITY],
        })
    }

    /// Makes a sample black, because its path is at the maximum depth.
    #[inline(always)]
    pub(crate) fn terminate(&mut self, sample: SampleIndex) {
        self.color.set(sample.get(), [0.0; 3]);
    }

    /// Replaces the samples by those of `span`, and draws their offsets. In deterministic mode all offsets stay 0.
    #[inline(always)]
    pub(crate) fn draw<L: Layout>(&mut self, prepared: &Prepared<L>, span: &Span, pixel_jitter: &mut PixelJitter) {
        self.count = span.count;
        for (column, samples) in span.pixels(prepared.samples) {
            self.column[samples].fill(column as f64);
        }
        if prepared.scatter != Scatter::Deterministic {
            pixel_jitter.draw(span.count, &mut self.draws, &mut self.offset);
        }
    }
}
