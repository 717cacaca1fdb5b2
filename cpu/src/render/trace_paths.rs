//! The part of the paths that is sequential by definition: from the first surface that scatters on, sample after
//! sample, each taking its random vectors from one stream.
//!
//! With fewer than four objects, [`lookahead`](crate::render::lookahead) replaces this loop.

use crate::accel::choice::Accel;
use crate::accel::every_object::EveryObject;
use crate::accel::find::Accelerator;
use crate::accel::small_scene::SmallScene;
use crate::layout::Layout;
use crate::render::lookahead;
use crate::render::path::PathTracer;
use crate::render::prepared::Prepared;
use crate::simd::{Kernel, Simd};

/// Follows every waiting sample to its end.
pub struct Follow<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub walk: &'a mut PathTracer,
}

impl<L: Layout> Kernel for Follow<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        // The loop is compiled once for each structure; with many objects width matters more than latency.
        match &self.prepared.search {
            Accel::EveryObject => simd.run_promptly(OneByOne { follow: self, search: &EveryObject }),
            Accel::SmallScene(few) if !few.uses_object_lanes() && self.walk.all_may_send_rays() => {
                simd.run_promptly(Leaping { follow: self, few });
            }
            Accel::SmallScene(search) => simd.run_promptly(OneByOne { follow: self, search }),
            Accel::FlatFilter(search) => simd.run(OneByOne { follow: self, search }),
            Accel::Bvh(search) => simd.run(OneByOne { follow: self, search }),
        }
    }
}

/// Traces the paths one after the other.
struct OneByOne<'a, L: Layout, F> {
    follow: Follow<'a, L>,
    search: &'a F,
}

impl<L: Layout, F: Accelerator> Kernel for OneByOne<'_, L, F> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { follow: Follow { prepared, walk }, search } = self;
        walk.trace::<S, L, F>(prepared, search, simd);
    }
}

/// Traces the paths with [`lookahead`].
struct Leaping<'a, L: Layout> {
    follow: Follow<'a, L>,
    few: &'a SmallScene,
}

impl<L: Layout> Kernel for Leaping<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { follow: Follow { prepared, walk }, few } = self;
        lookahead::trace(prepared, few, walk, simd);
    }
}
