//! Kernels for the short stages of a span: they draw its samples, find bytes without rays, and colour its paths. The
//! long stages have files of their own: `camera_rays.rs`, `specular_chains.rs` and `trace_paths.rs`.

use crate::render::{path::PathTracer, span::Span, span_state::SpanState};
use crate::{layout::Layout, simd::Kernel, simd::Simd};

/// A kernel that begins a span: it draws the pixel jitter of the span's samples.
pub struct DrawSamples<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>, pub &'s Span);

impl<L: Layout> Kernel for DrawSamples<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let SpanState { prepared, batch, pixel_jitter, .. } = self.0;
        batch.draw(prepared, self.1, pixel_jitter);
    }
}

/// A kernel that finds the bytes of the pixels of a span that no object can reach, by bounds instead of rays. It stops
/// at the first pixel whose bytes the bounds do not give, and returns the pixel's index in the span. The samples of
/// that pixel are then in the batch, and must be traced. If the bounds give all bytes, it returns the width of the
/// span.
pub struct FindBytes<'s, 'a, L: Layout> {
    /// The state of the span.
    pub state: &'s mut SpanState<'a, L>,
    /// The span, which must have only whole pixels.
    pub span: &'s Span,
    /// Number of the span's leading pixels whose bytes have been found already.
    pub done: usize,
}

impl<L: Layout> Kernel for FindBytes<'_, '_, L> {
    type Output = usize;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> usize {
        let Self { state, span, done } = self;
        let SpanState { prepared, row, background_pixels, pixel_jitter, batch, .. } = state;
        debug_assert!(span.is_whole(prepared.samples));
        if done == 0 {
            background_pixels.begin::<S::F64, L>(prepared, *row, span);
        }
        for at in done..span.width() {
            match background_pixels.find(prepared, (span, at), pixel_jitter, batch) {
                Some(bytes) => background_pixels.bytes[at] = bytes,
                None => return at,
            }
        }
        span.width()
    }
}

/// A kernel that ends a span: it computes the colours of all paths of the queue.
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
