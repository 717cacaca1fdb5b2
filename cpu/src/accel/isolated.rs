//! Isolated objects: those that no other object overlaps.
//!
//! Spheres and cylinders are convex. If a ray starts on an object and hits it again, the ray is inside that object
//! between the two points. If no other object overlaps that object, no other hit can be closer. Then no other object is
//! intersected. Half of the rays that rough metal scatters go inward, and so do all rays that are refracted into an
//! object.
//!
//! The boxes of the objects are compared once for each scene. This happens only in
//! [moderate](crate::accel::extent::Extent::moderate) scenes, because only their boxes certainly have no NaN and no
//! overflow.

use crate::accel::object::ObjectId;
use crate::{input::error::Error, layout::OBJECTS, layout::with_room};

/// The smallest distance of an isolated object from the box of any other object, relative to the scene's largest
/// coordinate. Rounding moves the two ends of a ray inside the object, and a hit on another object, by less than half
/// of this (docs/margins.md).
pub const SEPARATION: f64 = 1e-8;

/// The set of the isolated objects, which no other object overlaps. If a ray starts on an isolated object and hits it
/// again, this is the closest hit, and no other object is intersected. By default the set is empty.
#[derive(Clone, Debug, Default)]
pub struct Isolated(Vec<u64>);

impl Isolated {
    /// Returns the empty set, with room for `count` objects.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn none(count: usize) -> Result<Self, Error> {
        let mut words = with_room(count.div_ceil(64), OBJECTS)?;
        words.resize(count.div_ceil(64), 0);
        Ok(Self(words))
    }

    /// Whether no object is isolated.
    #[cfg(feature = "internals")]
    pub(crate) fn is_empty(&self) -> bool {
        self.0.iter().all(|&word| word == 0)
    }

    /// Adds the object with the number `id`, for which the set must have room.
    #[inline(always)]
    pub(crate) fn insert(&mut self, id: ObjectId) {
        debug_assert!((id as usize) < 64 * self.0.len());
        self.0[id as usize / 64] |= 1 << (id % 64);
    }

    /// Whether the object with the number `id` is isolated.
    #[inline(always)]
    pub(crate) fn is(&self, id: ObjectId) -> bool {
        self.0.get(id as usize / 64).is_some_and(|word| word >> (id % 64) & 1 == 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_that_was_inserted_is_isolated() {
        let mut isolated = Isolated::none(3).expect("it fits");
        isolated.insert(0);
        isolated.insert(2);
        assert_eq!([0, 1, 2].map(|id| isolated.is(id)), [true, false, true]);
        assert!(!isolated.is(crate::accel::object::NO_OBJECT));
        assert!(!Isolated::default().is(0));
    }

    #[test]
    fn a_hundred_answers_keep_their_places() {
        let mut isolated = Isolated::none(100).expect("it fits");
        (0..100).filter(|id| id % 3 != 0).for_each(|id| isolated.insert(id));
        for id in 0..128 {
            assert_eq!(isolated.is(id), id < 100 && id % 3 != 0, "{id}");
        }
    }
}
