//! The real renderer. It renders the pixels in order, one span of a row at a time. A span goes through these stages:
//!
//! 1. Up to the first matte or metal surface, rays need no scatter samples. So camera rays (`camera_rays`) and specular
//!    chains (`specular_chains`) are intersected and shaded several at once.
//! 2. From that surface on, the paths take their scatter samples from one stream, in the order of the samples. So they
//!    are traced one after the other (`trace_paths`).
//! 3. The background of the rays that escape is computed for several rays at once (`path_ends`).
//! 4. The samples are summed in their order (`accumulation`).
//!
//! Uses all folders but `reference`. Begin with [`prepared`], then this file, then the stages in the order of the list.
//! docs/design.md follows one ray through them.

pub(crate) mod accumulation;
pub(crate) mod arrays;
pub mod background;
pub mod background_derivative;
pub mod background_pixels;
pub(crate) mod boxed;
pub mod camera_rays;
pub(crate) mod compensated_lanes;
pub mod frustum;
pub mod hit_lanes;
mod lane_by_lane;
pub(crate) mod lane_numbers;
pub mod limits;
pub(crate) mod lookahead;
pub mod max_depth;
pub mod path;
pub mod path_ends;
pub(crate) mod path_vertex;
pub mod prepared;
pub mod queue;
pub mod ray_error;
pub mod samples;
pub(crate) mod shade;
pub mod span;
pub mod span_state;
pub mod specular_chains;
pub mod stages;
pub mod surface_hit;
pub mod trace_paths;

use std::borrow::Borrow;
use std::ops::ControlFlow;

use crate::render::{
    accumulation::Accumulator, camera_rays::TraceCameraRays, limits::Ended, limits::Limits, prepared::Prepared,
    span::Span, span::spans_of_row, span_state::SpanState, span_state::Streams, specular_chains::TraceSpecularChains,
    stages::ColorPaths, stages::DrawSamples, stages::FindBytes, trace_paths::TracePaths,
};
use crate::{
    counters::Counter, counters::add, image::Image, image::Rgb, input::config::Config, input::error::Error,
    input::scene::Scene, layout::Layout, layout::aos::Aos, layout::soa::Soa, math::vec3::Vec3,
    sampling::scatter_vectors::Scatter, simd::Kernel, simd::Simd, simd::instruction_set::InstructionSet,
};

/// Renders `scene` with the configuration `config`, and returns the picture in the layout `L`. `scatter` says how
/// random vectors are drawn. With [`Scatter::Statement`] the picture is that of `render-aos` and `render-soa`. A scene
/// that is passed by value is freed before rendering.
///
/// The renderer uses the fastest instruction set of this machine, unless the environment variable
/// `RENDER_INSTRUCTION_SET` names another one. A name that is unknown, or whose instruction set this machine lacks, is
/// ignored. The picture's bytes do not depend on the instruction set.
///
/// # Errors
/// [`Error::Picture`] if the picture has more than 2^30 pixels, or if the camera has no projection window: its position
/// equals its target, north is null or parallel to the view, or the window is not finite. [`Error::OutOfMemory`] if
/// memory is short.
pub fn render<L: Renderable>(config: &Config, scene: impl Borrow<Scene>, scatter: Scatter) -> Result<L::Image, Error> {
    render_with(&Prepared::<L>::new(config, scene, scatter)?, InstructionSet::chosen())
}

/// Renders the prepared scene with the instruction set `set`, and returns the picture.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub fn render_with<L: Renderable>(prepared: &Prepared<L>, set: InstructionSet) -> Result<L::Image, Error> {
    let mut image = L::Image::black(prepared.size)?;
    // The result is always `None`.
    let _ = render_from(prepared, set, &Limits::default(), (0, &[]), &mut image, |_, _, _| ControlFlow::Continue(()))?;
    Ok(image)
}

/// Renders the prepared scene into `image`, which must have the picture's size, within `limits`. After each row it
/// calls `after_row` with the number of finished rows, with the image, which holds these rows, and with the random
/// streams. Returns `None` if the picture is complete, or the reason why it ended before. `Break` of `after_row` counts
/// as a request to stop. The pixels of the row in which the picture ended have no meaning.
///
/// A picture begins with row 0 and no words. To go on with an earlier rendering, begin with the row after its last one.
/// The words are then the [`Streams::count`] words that the earlier rendering got from [`Streams::visit`] there.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub fn render_from<L: Renderable>(
    prepared: &Prepared<L>,
    set: InstructionSet,
    limits: &Limits,
    (first_row, words): (usize, &[u64]),
    image: &mut L::Image,
    mut after_row: impl FnMut(usize, &L::Image, &mut Streams<'_>) -> ControlFlow<()>,
) -> Result<Option<Ended>, Error> {
    debug_assert_eq!(image.size(), prepared.size);
    let (mut state, accumulator) = (SpanState::new(prepared, set, limits)?, Accumulator::new(prepared.samples));
    if first_row > 0 {
        debug_assert_eq!(words.len(), Streams::count());
        let mut words = words.iter();
        state.streams().visit(|word| *word = words.next().copied().unwrap_or_default());
    }
    L::run(set, PictureKernel { state, accumulator, first_row, target: Sink::Image(image, &mut after_row) })
}

/// Renders the prepared scene within `limits`. Calls `pixel` for every pixel, with its index and its mean colour before
/// quantisation. Returns `None` if the picture is complete, or the reason why it ended before.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
#[cfg_attr(not(feature = "internals"), expect(dead_code, reason = "for tests and tools"))]
pub fn render_linear<L: Renderable>(
    prepared: &Prepared<L>,
    set: InstructionSet,
    limits: &Limits,
    mut pixel: impl FnMut(usize, Vec3),
) -> Result<Option<Ended>, Error> {
    let (state, accumulator) = (SpanState::new(prepared, set, limits)?, Accumulator::new(prepared.samples));
    L::run(set, PictureKernel { state, accumulator, first_row: 0, target: Sink::Means(&mut pixel) })
}

/// A layout for which the renderer is compiled. The kernel is large: it exists for each instruction set and
/// acceleration structure. A function of this trait is no template, so it is compiled once, in this crate, and not in
/// each crate that renders.
pub trait Renderable: Layout + Sized {
    /// Renders a picture, and returns why it ended early, if it did.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    fn run(set: InstructionSet, picture: PictureKernel<'_, Self>) -> Result<Option<Ended>, Error>;
}

macro_rules! renderable {
    ($($layout:ty)+) => {
        $(impl Renderable for $layout {
            #[inline(never)]
            fn run(set: InstructionSet, picture: PictureKernel<'_, Self>) -> Result<Option<Ended>, Error> {
                set.run(picture)
            }
        })+
    };
}
renderable!(Aos Soa);

/// The destination of the pixels.
enum Sink<'a, I> {
    /// An image, which gets the bytes of the pixels, and the function to call after each row.
    Image(&'a mut I, &'a mut dyn FnMut(usize, &I, &mut Streams<'_>) -> ControlFlow<()>),
    /// A function, which gets the means of the pixels. Then every mean is computed, even if bounds would give its
    /// bytes.
    Means(&'a mut dyn FnMut(usize, Vec3)),
}

/// A kernel that renders the picture from row `first_row` on, row by row.
pub struct PictureKernel<'a, L: Layout> {
    state: SpanState<'a, L>,
    accumulator: Accumulator,
    first_row: usize,
    target: Sink<'a, L::Image>,
}

impl<L: Layout> Kernel for PictureKernel<'_, L> {
    type Output = Result<Option<Ended>, Error>;

    #[inline(always)]
    fn call<S: Simd>(mut self, simd: S) -> Self::Output {
        let prepared = self.state.prepared;
        for row in self.first_row..prepared.size.height() {
            self.state.row = row;
            self.state.candidates.begin_row(prepared, row);
            for span in spans_of_row(prepared.size.width(), prepared.samples, self.state.tracer.limits.samples) {
                self.span(simd, &span);
                if let Some(ended) = self.state.tracer.ended()? {
                    return Ok(Some(ended));
                }
            }
            if let Sink::Image(image, after_row) = &mut self.target
                && after_row(row + 1, image, &mut self.state.streams()).is_break()
            {
                return Ok(Some(Ended::Stopped));
            }
        }
        Ok(None)
    }
}

impl<L: Layout> PictureKernel<'_, L> {
    /// Renders a span of a row.
    fn span<S: Simd>(&mut self, simd: S, span: &Span) {
        let Self { state, target, .. } = self;
        let (prepared, candidates) = (state.prepared, &mut state.candidates);
        candidates.begin_span(prepared, state.row, span);
        let is_background = candidates.are_culled && candidates.span.is_empty();
        if is_background && span.is_whole(prepared.samples) && matches!(target, Sink::Image(..)) {
            self.background_span(simd, span);
        } else {
            simd.run(DrawSamples(state, span));
            self.trace(simd, span);
        }
    }

    /// Renders a span of whole pixels that no object can reach.
    fn background_span<S: Simd>(&mut self, simd: S, span: &Span) {
        let prepared = self.state.prepared;
        let first = self.state.row * prepared.size.width() + span.first;
        let mut done = 0;
        while done < span.width() {
            let known = simd.run(FindBytes { state: &mut self.state, span, done });
            add(Counter::BackgroundPixels, (known - done) as u64);
            if let Sink::Image(image, _) = &mut self.target {
                for at in done..known {
                    let [red, green, blue] = self.state.background_pixels.bytes[at];
                    image.set_pixel(first + at, Rgb { red, green, blue });
                }
            }
            if known < span.width() {
                add(Counter::BackgroundPixelsTraced, 1);
                self.trace(simd, &span.pixel(known, prepared.samples));
            }
            done = known + 1;
        }
    }

    /// Traces the samples of the batch, and adds their colours to their pixels. Their offsets must have been drawn.
    fn trace<S: Simd>(&mut self, simd: S, span: &Span) {
        let Self { state, accumulator, target, .. } = self;
        debug_assert_eq!(state.batch.count, span.count);
        simd.run(TraceCameraRays(state));
        if state.batch.specular.count > 0 {
            simd.run(TraceSpecularChains(state));
        }
        if state.tracer.queue.count > 0 {
            simd.run(TracePaths(state));
            simd.run(ColorPaths(state));
        }
        let (first, quantizer) = (state.row * state.prepared.size.width(), &state.prepared.quantizer);
        accumulator.add(span, &state.batch, |column, mean| match target {
            Sink::Image(image, _) => {
                let [red, green, blue] = mean.to_array().map(|channel| quantizer.quantize(channel));
                image.set_pixel(first + column, Rgb { red, green, blue });
            }
            Sink::Means(pixel) => pixel(first + column, mean),
        });
    }
}
