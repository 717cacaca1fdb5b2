//! Objects into which no other reaches.
//!
//! Spheres and cylinders are convex: a ray that starts on one and meets it again is inside in between. Where no other
//! object reaches inside, none can be nearer, and none is asked. Half of what rough metal scatters goes inward, and all
//! that glass lets through.
//!
//! Boxes are compared once a scene, with coordinates of up to 10^9 in single precision. A box that is not made of
//! numbers overlaps nothing, but moderate scenes have none.

use crate::accel::bounds::Bounds;
use crate::accel::extent::Extent;
use crate::accel::object::{ObjectId, room};
use crate::input::error::Error;
use crate::layout::Objects;

/// Which objects are isolated, a bit each.
#[derive(Clone, Debug)]
pub struct Isolated(Vec<u64>);

impl Isolated {
    /// The objects whose box no other's overlaps, as `overlapped` says, but for one that is asked apart anyway.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(count: usize, mut overlapped: impl FnMut(ObjectId) -> bool) -> Result<Self, Error> {
        let mut words = room(count.div_ceil(64))?;
        words.resize(count.div_ceil(64), 0);
        for id in 0..count {
            words[id / 64] |= u64::from(!overlapped(id as ObjectId)) << (id % 64);
        }
        Ok(Self(words))
    }

    /// Nothing is known to be alone.
    pub const fn none() -> Self {
        Self(Vec::new())
    }

    /// Whether a ray that starts on `id` and meets it again certainly meets nothing before that but what is asked
    /// apart.
    #[inline(always)]
    #[must_use]
    pub fn is(&self, id: ObjectId) -> bool {
        self.0.get(id as usize / 64).is_some_and(|word| word >> (id % 64) & 1 == 1)
    }
}

/// The box of an object, with room for how far rounding may move the points of its surface.
#[must_use]
pub fn roomy_bounds(objects: &impl Objects, id: ObjectId, extent: &Extent) -> Bounds {
    Bounds::of_object(objects, id, extent).enlarged((1e-9 * extent.reach) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_other_overlaps_is_alone() {
        let alone = Isolated::new(3, |id| id == 1).expect("it fits");
        assert_eq!([0, 1, 2].map(|id| alone.is(id)), [true, false, true]);
        assert!(!alone.is(crate::accel::object::NOWHERE));
        assert!(!Isolated::none().is(0));
    }

    #[test]
    fn a_hundred_answers_keep_their_places() {
        let alone = Isolated::new(100, |id| id % 3 == 0).expect("it fits");
        for id in 0..128 {
            assert_eq!(alone.is(id), id < 100 && id % 3 != 0, "{id}");
        }
    }
}
