//! What the renderer does, counted: rays, tests, draws, and what it was spared.
//!
//! Counting is compiled in with the feature `counters` alone, which no program that is measured has; without it
//! [`add`] is nothing. Counts belong to the thread that renders, so that tests run beside each other.

/// What is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counter {
    /// Samples whose primary ray was traced.
    PrimaryRays,
    /// Primary rays times the objects that they were tested against.
    PrimaryTests,
    /// Objects of the scene, summed over spans.
    SpanObjects,
    /// Objects that a span's cull left, summed over spans.
    SpanCandidates,
    /// Rays followed several at once from one refractive surface to the next.
    GlassRays,
    /// All other rays that left a surface.
    WalkRays,
    /// First rays of samples that were tried several at once, as if those before them left; some more than once.
    Guesses,
    /// Nodes of the tree whose boxes were tested.
    NodeVisits,
    /// Spheres asked exactly by rays that left a surface.
    SphereAsks,
    /// Cylinders asked exactly by rays that left a surface.
    CylinderAsks,
    /// Last rays of paths that are known to meet something before any object is asked.
    LastRaysSpared,
    /// Objects asked without any filter, in scenes of extreme magnitudes.
    PlainAsks,
    /// Rays from the ground that did not go the way that was expected.
    Unexpected,
    /// Rays that met a surface.
    Hits,
    /// Spheres that were in doubt and answered by the formula without cancellation.
    Compensated,
    /// Intersections that were in doubt and repeated more precisely.
    Fallbacks,
    /// Draws of the samples' places.
    RayDraws,
    /// Draws of the samples' places that were passed over.
    RayDrawsSkipped,
    /// Draws for random vectors.
    MaterialDraws,
    /// Random vectors that surfaces took.
    VectorsTaken,
    /// Pixels whose bytes were known without a ray.
    SkyPixels,
    /// Pixels that no object reaches whose rays were traced all the same.
    SkyTraced,
    /// Power functions of the gamma correction.
    Powers,
    /// Paths that had used up their depth.
    DepthReached,
}

impl Counter {
    /// All of them.
    pub const ALL: [Self; 24] = [
        Self::PrimaryRays,
        Self::PrimaryTests,
        Self::SpanObjects,
        Self::SpanCandidates,
        Self::GlassRays,
        Self::WalkRays,
        Self::Guesses,
        Self::NodeVisits,
        Self::SphereAsks,
        Self::CylinderAsks,
        Self::LastRaysSpared,
        Self::PlainAsks,
        Self::Unexpected,
        Self::Hits,
        Self::Compensated,
        Self::Fallbacks,
        Self::RayDraws,
        Self::RayDrawsSkipped,
        Self::MaterialDraws,
        Self::VectorsTaken,
        Self::SkyPixels,
        Self::SkyTraced,
        Self::Powers,
        Self::DepthReached,
    ];
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

    /// Counters as they stood at one time.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct Snapshot([u64; COUNT]);

    impl Snapshot {
        /// What a counter had counted.
        #[must_use]
        pub fn of(&self, counter: Counter) -> u64 {
            self.0[counter as usize]
        }
    }

    /// How the counters of this thread stand.
    #[must_use]
    pub fn snapshot() -> Snapshot {
        COUNTS.with(|counts| Snapshot(counts.each_ref().map(Cell::get)))
    }

    /// Sets all counters of this thread to nought.
    pub fn reset() {
        COUNTS.with(|counts| counts.iter().for_each(|cell| cell.set(0)));
    }
}

#[cfg(feature = "counters")]
pub use counting::{Snapshot, add, reset, snapshot};

/// Adds to a counter of this thread: nothing without the feature `counters`.
#[cfg(not(feature = "counters"))]
#[inline(always)]
pub fn add(_: Counter, _: u64) {}
