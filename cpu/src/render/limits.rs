//! The limits at which a picture ends before it is complete: a request to stop, and the surfaces that paths hit.
//!
//! A path may send up to 2^64 rays, and a pixel may have as many samples. So the renderer looks at the request before
//! each span, each 64 paths if there is no lookahead, and within a path at each [pause]. The test for a pause takes the
//! place of a test that each ray needs anyway.
//!
//! In a large scene one ray may take milliseconds, for instance if all objects are at one place. For such a scene,
//! `Limits::prompt` chooses shorter spans, and a look before each ray.
//!
//! [pause]: crate::render::max_depth::RaysLeft::pauses

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::render::arrays::CAPACITY;

/// Number of paths between two looks at the request to stop.
pub const PIECE: usize = 64;

/// The limits of one picture. The default has none.
#[derive(Clone, Debug)]
pub struct Limits {
    /// True when the picture is to stop. Any thread may set it. The renderer then stops after some milliseconds.
    pub stop: Arc<AtomicBool>,
    /// Largest number of surfaces that the paths of a span may hit together, after their first ones. The renderer
    /// stores 8 bytes for each. It has room for 8,192 of them from the start, so a smaller limit has no effect.
    pub surfaces: usize,
    /// Whether the renderer looks at the request before each ray that starts on a surface. Structures for few objects
    /// ignore this, because their rays are short work.
    pub every_ray: bool,
    /// Largest number of samples of a span, at most 1,024.
    pub samples: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { stop: Arc::default(), surfaces: usize::MAX, every_ray: false, samples: CAPACITY }
    }
}

/// The reason why a picture ended before it was complete, although neither its texts nor memory were at fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The picture was asked to stop.
    Stopped,
    /// The paths of a span hit more surfaces than [`Limits::surfaces`].
    TooManySurfaces,
}

impl Limits {
    /// Returns limits with which a picture of so many objects stops within a tenth of a second, also if every ray is
    /// tested against each object. Large scenes take a little longer with them.
    #[cfg(feature = "internals")]
    #[must_use]
    pub fn prompt(objects: usize) -> Self {
        // So many tests of camera rays, several at once, take less than a tenth of a second, also without SIMD.
        const TESTS: usize = 1 << 23;
        const FEW: usize = 1000;

        Self { every_ray: objects > FEW, samples: (TESTS / objects.max(1)).clamp(8, CAPACITY), ..Self::default() }
    }

    /// Whether the picture is to stop, and the renderer looks before each ray.
    #[inline(always)]
    pub(crate) fn stops_every_ray(&self) -> bool {
        self.every_ray && self.is_stopped()
    }

    /// Whether the picture is to stop.
    #[inline(always)]
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prompt_limits_follow_the_number_of_objects() {
        let samples = [1, 8192, 16_384, 1 << 17, 1 << 30].map(|objects| Limits::prompt(objects).samples);
        assert_eq!(samples, [1024, 1024, 512, 64, 8]);
        assert_eq!(Limits::prompt(0).samples, Limits::default().samples);
        assert_eq!([1000, 1001].map(|objects| Limits::prompt(objects).every_ray), [false, true]);
    }
}
