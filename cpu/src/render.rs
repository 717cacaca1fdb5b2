//! The real renderer: pixels in order, a span of a row at a time.
//!
//! The camera rays of a span need no material's random numbers, so they are drawn, intersected and shaded several at
//! once (`camera_rays`, `specular_chains`), up to the first matte or metal surface. What follows there takes its random
//! vectors from one stream in the order of the samples, and is traced one path after the other (`trace_paths`). Where
//! rays leave the scene, their background is computed several at once again (`path_ends`), and the samples are summed
//! in order (`accumulation`).
//!
//! Uses all folders but `reference` and `output`. Begin with [`prepared`], then this file, then the stages in that
//! order; docs/design.md follows one ray through them.

pub(crate) mod accumulation;
pub(crate) mod arrays;
pub mod background;
pub(crate) mod background_pixels;
pub(crate) mod background_slope;
pub(crate) mod camera_rays;
pub(crate) mod context;
pub(crate) mod fallback;
pub(crate) mod frustum;
pub(crate) mod hit_lanes;
pub(crate) mod lane_by_lane;
pub(crate) mod lookahead;
pub(crate) mod path;
pub(crate) mod path_ends;
pub(crate) mod path_vertex;
pub mod prepared;
pub(crate) mod queue;
pub(crate) mod samples;
pub(crate) mod shade;
pub(crate) mod span;
pub(crate) mod specular_chains;
#[cfg(feature = "internals")]
pub mod stages;
pub(crate) mod surface;
pub(crate) mod trace_paths;

use std::ops::ControlFlow;

use crate::counters::{Counter, add};
use crate::image::quantize::Quantizer;
use crate::image::{Image, Rgb};
use crate::input::config::Config;
use crate::input::error::Error;
use crate::input::scene::Scene;
use crate::layout::Layout;
use crate::math::vec3::Vec3;
use crate::render::accumulation::Sums;
use crate::render::background_pixels::{BackgroundPixels, FindBytes};
use crate::render::frustum::Candidates;
use crate::render::path::PathTracer;
use crate::render::prepared::Prepared;
use crate::render::samples::{Batch, Draw};
use crate::render::span::{Span, Spans};
use crate::sampling::pixel_jitter::PixelJitter;
use crate::sampling::scatter_vectors::Scatter;
use crate::simd::instruction_set::InstructionSet;
use crate::simd::{Kernel, Simd};

/// Renders `scene` as `config` asks, in the layout `L`, with the instruction set that this machine offers.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when it does not fit.
pub fn render<L: Layout>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<L::Image, Error> {
    render_with(&Prepared::<L>::new(config, scene, scatter)?, InstructionSet::chosen())
}

/// Renders what was prepared, with a given instruction set.
///
/// # Errors
/// [`Error::OutOfMemory`] when the picture does not fit.
pub fn render_with<L: Layout>(prepared: &Prepared<L>, set: InstructionSet) -> Result<L::Image, Error> {
    let mut image = L::Image::black(prepared.size)?;
    // Nobody stops this one.
    let _ = render_into(prepared, set, &mut image, |_| ControlFlow::Continue(()))?;
    Ok(image)
}

/// Renders what was prepared into an image of its size, and calls `after_row` with the number of rows that are done;
/// the rendering stops where it breaks off, with the rows done so far in the image.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn render_into<L: Layout>(
    prepared: &Prepared<L>,
    set: InstructionSet,
    image: &mut L::Image,
    after_row: impl FnMut(usize) -> ControlFlow<()>,
) -> Result<ControlFlow<()>, Error> {
    let (candidates, sink) = (Candidates::new(prepared)?, Bytes { image, quantizer: &prepared.quantizer });
    set.run(Picture { prepared, candidates, sink, after_row })
}

/// Renders what was prepared and hands every pixel's mean, before it becomes bytes, to `pixel` with its index.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn render_linear<L: Layout>(
    prepared: &Prepared<L>,
    set: InstructionSet,
    pixel: impl FnMut(usize, Vec3),
) -> Result<(), Error> {
    let candidates = Candidates::new(prepared)?;
    // Nobody stops this one.
    let _ = set.run(Picture { prepared, candidates, sink: Means(pixel), after_row: |_| ControlFlow::Continue(()) })?;
    Ok(())
}

/// Where pixels go.
trait Sink {
    /// Whether a pixel's mean is wanted even where its bytes can be known without it.
    const WANTS_MEANS: bool;

    /// Takes a pixel's mean.
    fn mean(&mut self, index: usize, mean: Vec3);
    /// Takes a pixel's bytes.
    fn bytes(&mut self, index: usize, color: Rgb);
}

/// Pixels into an image.
struct Bytes<'a, I> {
    image: &'a mut I,
    quantizer: &'a Quantizer,
}

impl<I: Image> Sink for Bytes<'_, I> {
    const WANTS_MEANS: bool = false;

    #[inline(always)]
    fn mean(&mut self, index: usize, mean: Vec3) {
        let [red, green, blue] = mean.to_array().map(|channel| self.quantizer.quantize(channel));
        self.image.set_pixel(index, Rgb { red, green, blue });
    }
    #[inline(always)]
    fn bytes(&mut self, index: usize, color: Rgb) {
        self.image.set_pixel(index, color);
    }
}

/// Means to whoever wants them.
struct Means<F>(F);

impl<F: FnMut(usize, Vec3)> Sink for Means<F> {
    const WANTS_MEANS: bool = true;

    fn mean(&mut self, index: usize, mean: Vec3) {
        self.0(index, mean);
    }
    fn bytes(&mut self, _: usize, _: Rgb) {}
}

/// The whole picture.
struct Picture<'a, L: Layout, K, R> {
    prepared: &'a Prepared<L>,
    candidates: Candidates,
    sink: K,
    after_row: R,
}

impl<L: Layout, K: Sink, R: FnMut(usize) -> ControlFlow<()>> Kernel for Picture<'_, L, K, R> {
    type Output = Result<ControlFlow<()>, Error>;

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) -> Self::Output {
        let Self { prepared, candidates, sink, mut after_row } = self;
        let mut painter = Painter {
            prepared,
            sink,
            offsets: PixelJitter::new(prepared.ray_seed),
            batch: Batch::new(),
            tracer: PathTracer::new(prepared),
            candidates,
            sums: Sums::new(prepared.samples),
            sky: BackgroundPixels::new(prepared),
        };
        for row in 0..prepared.size.height() {
            painter.row(simd, row);
            painter.tracer.ends.check()?;
            if after_row(row + 1).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// What goes on from span to span.
struct Painter<'a, L: Layout, K> {
    prepared: &'a Prepared<L>,
    sink: K,
    offsets: PixelJitter,
    batch: Box<Batch>,
    tracer: Box<PathTracer>,
    candidates: Candidates,
    sums: Sums,
    sky: BackgroundPixels,
}

impl<L: Layout, K: Sink> Painter<'_, L, K> {
    fn row<S: Simd>(&mut self, simd: S, row: usize) {
        let prepared = self.prepared;
        self.candidates.begin_row(prepared, row);
        for span in Spans::of_row(prepared.size.width(), prepared.samples) {
            self.candidates.narrow(prepared, row, &span);
            let is_background = self.candidates.are_culled() && self.candidates.span.is_empty();
            if !K::WANTS_MEANS && is_background && span.is_whole(prepared.samples) {
                self.sky(simd, row, &span);
            } else {
                simd.run(Draw { prepared, span: &span, offsets: self.offsets.stream(), batch: &mut self.batch });
                self.trace(simd, row, &span);
            }
        }
    }

    /// A span of whole pixels that no object can reach.
    fn sky<S: Simd>(&mut self, simd: S, row: usize, span: &Span) {
        let prepared = self.prepared;
        let first = row * prepared.size.width() + span.first;
        let mut done = 0;
        while done < span.width() {
            let (sky, offsets, batch) = (&mut self.sky, &mut self.offsets, &mut *self.batch);
            let known = simd.run(FindBytes { prepared, row, span, done, sky, offsets, batch });
            add(Counter::SkyPixels, (known - done) as u64);
            for at in done..known {
                let [red, green, blue] = self.sky.bytes[at];
                self.sink.bytes(first + at, Rgb { red, green, blue });
            }
            if known < span.width() {
                add(Counter::SkyTraced, 1);
                self.trace(simd, row, &span.pixel(known, prepared.samples));
            }
            done = known + 1;
        }
    }

    /// A span whose samples have been drawn.
    fn trace<S: Simd>(&mut self, simd: S, row: usize, span: &Span) {
        let (prepared, batch) = (self.prepared, &mut *self.batch);
        let queue = &mut self.tracer.queue;
        simd.run(camera_rays::Trace { prepared, row, candidates: &self.candidates, batch, queue });
        if batch.specular.count > 0 {
            simd.run(specular_chains::Trace { prepared, batch, paths: queue });
        }
        if queue.count > 0 {
            simd.run(trace_paths::TracePaths { prepared, tracer: &mut self.tracer });
            let PathTracer { queue, ends, .. } = &mut *self.tracer;
            simd.run(path_ends::Color { prepared, queue, ends, batch });
        }
        let first_pixel = row * prepared.size.width();
        self.sums.add(span, batch, |column, mean| self.sink.mean(first_pixel + column, mean));
    }
}
