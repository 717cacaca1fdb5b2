//! The part of the paths that is sequential by definition: from the first surface that scatters on, sample after sample,
//! each taking its random vectors from one stream.
//!
//! With two or three objects it is done [otherwise](crate::render::lookahead).

use crate::accel::choice::Search;
use crate::accel::every_object::Plain;
use crate::accel::find::Find;
use crate::accel::small_scene::Few;
use crate::layout::Layout;
use crate::render::lookahead;
use crate::render::path::Walk;
use crate::render::prepared::Prepared;
use crate::simd::{Kernel, Simd};

/// Follows every waiting sample to its end.
pub struct Follow<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub walk: &'a mut Walk,
}

impl<L: Layout> Kernel for Follow<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        // Each kind of search has a walk of its own, compiled apart; with many objects lanes count for more than promptness.
        match &self.prepared.search {
            Search::Plain => simd.run_promptly(OneByOne { follow: self, search: &Plain }),
            Search::Few(few) if !few.is_side_by_side() && self.walk.queue.fewest_rays > 0 => {
                simd.run_promptly(Leaping { follow: self, few });
            }
            Search::Few(search) => simd.run_promptly(OneByOne { follow: self, search }),
            Search::Flat(search) => simd.run(OneByOne { follow: self, search }),
            Search::Tree(search) => simd.run(OneByOne { follow: self, search }),
        }
    }
}

/// The same, with the instruction set that it is called with, perhaps the one for work on one ray after the other.
struct OneByOne<'a, L: Layout, F> {
    follow: Follow<'a, L>,
    search: &'a F,
}

impl<L: Layout, F: Find> Kernel for OneByOne<'_, L, F> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { follow: Follow { prepared, walk }, search } = self;
        walk.follow::<S, L, F>(prepared, search, simd);
    }
}

/// The same with [leaps].
struct Leaping<'a, L: Layout> {
    follow: Follow<'a, L>,
    few: &'a Few,
}

impl<L: Layout> Kernel for Leaping<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Self { follow: Follow { prepared, walk }, few } = self;
        lookahead::follow(prepared, few, walk, simd);
    }
}
