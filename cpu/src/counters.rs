//! Counts rays, object tests and random draws, and how much work the shortcuts save.
//!
//! Only builds with the feature `counters` count. Measured programs are built without it: [`add`] then does nothing.
//! Each thread has counters of its own, so that tests can run in parallel.

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
            pub const ALL: &[Self] = &[$(Self::$name,)+];
        }
    };
}

counters! {
    /// Camera rays.
    CameraRays,
    /// Camera rays times the objects that they were tested against.
    CameraRayTests,
    /// Objects of the scene, summed over spans.
    SpanObjects,
    /// Candidate objects of a span, summed over spans.
    SpanCandidates,
    /// Rays of specular chains that were traced several at once.
    SpecularRays,
    /// All other rays that start on a surface.
    PathRays,
    /// First rays of paths that were tested ahead, as if the paths before them escaped; some more than once.
    LookaheadRays,
    /// Nodes of the BVH whose boxes were tested.
    NodeVisits,
    /// Exact tests of spheres by rays that start on a surface.
    SphereTests,
    /// Exact tests of cylinders by rays that start on a surface.
    CylinderTests,
    /// Last rays of paths that certainly hit, so that no object was tested.
    LastRaysSkipped,
    /// Exact tests without a filter, in scenes of extreme magnitudes.
    UnfilteredTests,
    /// Rays from the dominant sphere whose entry was predicted wrong.
    MispredictedEntries,
    /// Rays that hit a surface.
    Hits,
    /// Uncertain intersections with spheres that the compensated formula decided.
    Compensated,
    /// Uncertain intersections that were computed in double-double arithmetic.
    Fallbacks,
    /// Draws of the pixel jitter.
    RayDraws,
    /// Draws of the pixel jitter that were skipped.
    RayDrawsSkipped,
    /// Draws of the scatter samples.
    MaterialDraws,
    /// Scatter samples that surfaces used.
    ScatterSamples,
    /// Pixels whose bytes were known without a ray.
    BackgroundPixels,
    /// Pixels whose rays can hit no object, but were traced, because the byte was not known without them.
    BackgroundPixelsTraced,
    /// Power functions of the gamma correction.
    Powers,
    /// Paths that reached the maximum depth.
    MaxDepthReached,
}

#[cfg(feature = "counters")]
mod counting {
    use std::cell::Cell;

    use super::Counter;

    const COUNT: usize = Counter::ALL.len();

    thread_local! {
        static COUNTS: [Cell<u64>; COUNT] = const { [const { Cell::new(0) }; COUNT] };
    }

    /// Adds to a counter of this thread.
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

#[cfg(feature = "counters")]
pub use counting::{add, reset, snapshot};

/// Does nothing, because the feature `counters` is not compiled in.
#[cfg(not(feature = "counters"))]
#[inline(always)]
pub fn add(_: Counter, _: u64) {}
