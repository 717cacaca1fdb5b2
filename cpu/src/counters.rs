//! Counts rays, object tests and random draws, and how much work the shortcuts save.
//!
//! Builds with the feature `counters` count, and so do builds for tests: those with the feature `internals` and with
//! debug assertions. The programs that are measured are built otherwise, and [`add`] then does nothing. Each thread has
//! its own counters, so that tests can run in parallel.

/// Defines [`Counter`] and the list of all counters from one table.
macro_rules! counters {
    ($($(#[$documentation:meta])* $name:ident,)+) => {
        /// A quantity that the renderer counts.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Counter {
            $($(#[$documentation])* $name,)+
        }

        impl Counter {
            /// All counters.
            #[cfg(feature = "internals")]
            pub const ALL: &[Self] = &[$(Self::$name,)+];
        }
    };
}

counters! {
    /// Camera rays.
    CameraRays,
    /// Tests of camera rays: for each camera ray, the number of candidate objects.
    CameraRayTests,
    /// Number of objects in the scene, added once for each span.
    SpanObjects,
    /// Number of a span's candidate objects, added for each span.
    SpanCandidates,
    /// Rays of specular chains, which are traced several at once.
    SpecularRays,
    /// All rays that start on a surface, except those that `SpecularRays` counts.
    PathRays,
    /// First rays of paths that the lookahead tested. A ray that is tested twice counts twice.
    LookaheadRays,
    /// Nodes of the BVH whose boxes were tested.
    NodeVisits,
    /// Exact tests of spheres by rays that start on a surface.
    SphereTests,
    /// Exact tests of cylinders by rays that start on a surface.
    CylinderTests,
    /// Last rays of paths for which no object was tested, because they certainly hit.
    LastRaysSkipped,
    /// Exact tests by rays that start on a surface, in scenes of extreme magnitudes, where each ray tests every object.
    UnfilteredTests,
    /// Rays from the dominant sphere for which the prediction was wrong whether they enter the sphere.
    MispredictedEntries,
    /// Rays that hit a surface.
    Hits,
    /// Uncertain intersections that the compensated formulas decided.
    Compensated,
    /// Uncertain intersections that double-double arithmetic decided.
    Wide,
    /// Uncertain intersections that dyadic arithmetic decided.
    Fallbacks,
    /// Comparisons of two hits whose lambdas differ by less than their errors.
    NearHits,
    /// Those of `NearHits` that were compared in dyadic arithmetic.
    NearHitsExactly,
    /// Random numbers drawn for the pixel jitter, two for each sample.
    RayDraws,
    /// Random numbers of the pixel jitter that were skipped, because no byte depends on them.
    RayDrawsSkipped,
    /// Random numbers drawn for scatter samples.
    MaterialDraws,
    /// Scatter samples that surfaces used.
    ScatterSamples,
    /// Pixels whose bytes were known without a ray.
    BackgroundPixels,
    /// Pixels whose rays can hit no object, but were traced, because a byte was not known without them.
    BackgroundPixelsTraced,
    /// Power functions computed to turn means into bytes.
    Powers,
    /// Paths that reached the maximum depth.
    MaxDepthReached,
}

#[cfg(any(feature = "counters", all(feature = "internals", debug_assertions)))]
mod counting {
    use std::cell::Cell;

    use super::Counter;

    const COUNT: usize = Counter::ALL.len();

    thread_local! {
        static COUNTS: [Cell<u64>; COUNT] = const { [const { Cell::new(0) }; COUNT] };
    }

    /// Adds `count` to a counter of this thread.
    pub fn add(counter: Counter, count: u64) {
        COUNTS.with(|counts| {
            let cell = &counts[counter as usize];
            cell.set(cell.get() + count);
        });
    }

    /// The counters of this thread, by their numbers in [`Counter`].
    pub fn snapshot() -> [u64; COUNT] {
        COUNTS.with(|counts| counts.each_ref().map(Cell::get))
    }

    /// Sets all counters of this thread to 0.
    pub fn reset() {
        COUNTS.with(|counts| counts.iter().for_each(|cell| cell.set(0)));
    }
}

#[cfg(any(feature = "counters", all(feature = "internals", debug_assertions)))]
pub use counting::{add, reset, snapshot};

/// Does nothing, because this build does not count.
#[cfg(not(any(feature = "counters", all(feature = "internals", debug_assertions))))]
#[inline(always)]
pub fn add(_: Counter, _: u64) {}
