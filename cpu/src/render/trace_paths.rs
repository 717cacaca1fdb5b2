//! The part of the paths that is sequential by definition: from the first surface that scatters on, sample after
//! sample, each taking its random vectors from one stream.
//!
//! With fewer than four objects, [`lookahead`](crate::render::lookahead) replaces this loop.

use crate::accel::choice::Accel;
use crate::accel::every_object::EveryObject;
use crate::accel::find::Accelerator;
use crate::accel::small_scene::SmallScene;
use crate::layout::Layout;
use crate::render::context::Compiled;
use crate::render::lookahead;
use crate::render::path::PathTracer;
use crate::render::prepared::Prepared;
use crate::simd::{Kernel, Simd};

/// Traces every path of the queue to its end.
pub struct TracePaths<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub tracer: &'a mut PathTracer,
}

impl<L: Layout> Kernel for TracePaths<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { prepared, tracer } = self;
        // The loop is compiled once for each structure; with many objects width matters more than latency.
        match &prepared.search {
            Accel::EveryObject => simd.run_promptly(OneByOne { prepared, tracer, accel: &EveryObject }),
            Accel::SmallScene(accel) if !accel.uses_object_lanes() && tracer.all_may_send_rays() => {
                simd.run_promptly(WithLookahead { prepared, tracer, accel });
            }
            Accel::SmallScene(accel) => simd.run_promptly(OneByOne { prepared, tracer, accel }),
            Accel::FlatFilter(accel) => simd.run(OneByOne { prepared, tracer, accel }),
            Accel::Bvh(accel) => simd.run(OneByOne { prepared, tracer, accel }),
        }
    }
}

/// Traces the paths one after the other.
struct OneByOne<'a, L: Layout, A> {
    prepared: &'a Prepared<L>,
    tracer: &'a mut PathTracer,
    accel: &'a A,
}

impl<L: Layout, A: Accelerator> Kernel for OneByOne<'_, L, A> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { prepared, tracer, accel } = self;
        tracer.trace(&Compiled { simd, prepared, accel });
    }
}

/// Traces the paths with [`lookahead`].
struct WithLookahead<'a, L: Layout> {
    prepared: &'a Prepared<L>,
    tracer: &'a mut PathTracer,
    accel: &'a SmallScene,
}

impl<L: Layout> Kernel for WithLookahead<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { prepared, tracer, accel } = self;
        lookahead::trace(&Compiled { simd, prepared, accel }, tracer);
    }
}
