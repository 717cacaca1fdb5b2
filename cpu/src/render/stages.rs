//! The short stages of a span, as kernels. The long stages have files of their own: `camera_rays.rs`,
//! `specular_chains.rs` and `trace_paths.rs`.

use crate::render::{path::PathTracer, span::Span, span_state::SpanState};
use crate::{layout::Layout, simd::Kernel, simd::Simd};

/// Begins a span: draws the offsets of its samples.
pub struct DrawSamples<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>, pub &'s Span);

impl<L: Layout> Kernel for DrawSamples<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let SpanState { prepared, batch, pixel_jitter, .. } = self.0;
        batch.draw::<S::F64, L>(prepared, self.1, pixel_jitter);
    }
}

/// Finds the bytes of the pixels of a span that no object can reach. Stops at the first pixel whose bytes the bounds do
/// not give, and returns its index, or the width of the span if there is none. The samples of that pixel are then in
/// the batch, and must be traced.
pub struct FindBytes<'s, 'a, L: Layout> {
    /// The state of the span.
    pub state: &'s mut SpanState<'a, L>,
    /// A span of whole pixels.
    pub span: &'s Span,
    /// Number of its leading pixels that are done.
    pub done: usize,
}

impl<L: Layout> Kernel for FindBytes<'_, '_, L> {
    type Output = usize;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> usize {
        let Self { state, span, done } = self;
        let SpanState { prepared, row, background_pixels, pixel_jitter, batch, .. } = state;
        if done == 0 {
            background_pixels.begin::<S::F64, L>(prepared, *row, span);
        }
        for at in done..span.width() {
            match background_pixels.find::<S::F64, L>(prepared, (span, at), pixel_jitter, batch) {
                Some(bytes) => background_pixels.bytes[at] = bytes,
                None => return at,
            }
        }
        span.width()
    }
}

/// Ends a span: gives every path of the queue its colour.
pub struct ColorPaths<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>);

impl<L: Layout> Kernel for ColorPaths<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let SpanState { prepared, batch, tracer, .. } = self.0;
        let PathTracer { ends, queue, .. } = &mut **tracer;
        ends.color::<S::F64, L>(prepared, queue, batch);
    }
}
