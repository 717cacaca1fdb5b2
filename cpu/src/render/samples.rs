//! A span's samples on their way: an array for each value, so that several are worked on at once.

use crate::accel::bvh::stack::Stack;
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::render::prepared::Prepared;
use crate::sampling::block::BlockUniform;
use crate::sampling::scatter_vectors::Scatter;
use crate::simd::{Kernel, Simd, SimdF64};

use crate::render::arrays::{CAPACITY, Values, Vectors, ZEROS};
use crate::render::queue::{PathQueue, Queue, SpecularQueue};
use crate::render::span::Span;

/// Begins a span: places its samples in their pixels.
pub struct Draw<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub span: &'a Span,
    pub offsets: &'a mut BlockUniform,
    pub batch: &'a mut Batch,
}

impl<L: Layout> Kernel for Draw<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        self.batch.draw::<S::F64, L>(self.prepared, self.span, self.offsets);
    }
}

/// The samples of a span.
#[derive(Debug)]
pub struct Batch {
    /// Number of samples.
    pub count: usize,
    /// Column of each sample's pixel.
    pub column: Values,
    /// Places in their pixels, to the right and down.
    pub offset: [Values; 2],
    /// Samples whose ray has just hit a refractive surface.
    pub specular: SpecularQueue,
    /// Samples whose specular chain has ended on a surface that scatters.
    pub chained: PathQueue,
    /// Colours of the samples, linear; those of samples in a queue are not known yet.
    pub color: Vectors,
    /// Room for the search.
    pub stack: Stack,
    draws: [f64; 2 * CAPACITY],
}

impl Batch {
    /// Room for a batch.
    pub fn new() -> Box<Self> {
        Box::new(Self {
            count: 0,
            column: ZEROS,
            offset: [ZEROS; 2],
            specular: Queue::EMPTY,
            chained: Queue::EMPTY,
            color: Vectors::ZERO,
            stack: Stack::EMPTY,
            draws: [0.0; 2 * CAPACITY],
        })
    }

    /// See [`Draw`].
    #[inline(always)]
    pub fn draw<V: SimdF64, L: Layout>(&mut self, prepared: &Prepared<L>, span: &Span, offsets: &mut BlockUniform) {
        self.count = span.count;
        let mut left_in_pixel = prepared.samples - span.first_sample;
        let (mut column, mut from) = (span.first, 0);
        while from < span.count {
            let to =
                span.count.min(usize::try_from(left_in_pixel).map_or(span.count, |left| left.saturating_add(from)));
            self.column[from..to].fill(column as f64);
            (from, column, left_in_pixel) = (to, column + 1, prepared.samples);
        }
        if prepared.scatter == Scatter::Deterministic {
            return;
        }
        add(Counter::RayDraws, 2 * span.count as u64);
        offsets.fill(&mut self.draws[..2 * span.count]);
        // A draw in [-1/2, 1/2) is u * 1 - 1/2, and the factor changes nothing. Lanes beyond the last sample are of no
        // meaning.
        let half = V::of(0.5);
        for at in (0..span.count).step_by(V::LANES) {
            let (right, down) = V::load(&self.draws[2 * at..]).unzip(V::load(&self.draws[2 * at + V::LANES..]));
            (right - half).store(&mut self.offset[0][at..]);
            (down - half).store(&mut self.offset[1][at..]);
        }
    }
}
