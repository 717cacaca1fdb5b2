//! The limits at which a picture ends before it is complete: a request to stop, and the surfaces that paths hit.
//!
//! A path may send up to 2^64 rays, and a pixel may have as many samples. So the renderer looks at the request before
//! each span of at most 1,024 samples, before each [`PIECE`] paths, and within a path at each [pause](RaysLeft::pauses).
//! The pauses take the place of a test that each ray needs anyway, so they cost nothing.
//!
//! [`RaysLeft::pauses`]: crate::render::max_depth::RaysLeft::pauses

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

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
}

impl Default for Limits {
    fn default() -> Self {
        Self { stop: Arc::default(), surfaces: usize::MAX }
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
    /// Whether the picture is to stop.
    #[inline(always)]
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
