//! A sphere much larger than all else, which nearly every ray would have to ask: it is asked apart.

use super::touch::{SphereTarget, Touch};
use super::{Bounds, Found, ObjectId};
use crate::certified::Intersect;
use crate::layout::Objects;
use crate::prepare::Extent;

/// A sphere at least this many times as large as everything else is asked apart.
const RATIO: f64 = 8.0;

/// Most objects that reach into the ground for it to pay to ask each of them.
const MOST_SUNK: usize = 4;

/// The sphere that is asked apart, if there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ground(Option<ObjectId>);

impl Ground {
    /// The ground among `objects`.
    #[must_use]
    pub fn of(objects: &impl Objects) -> Self {
        let radius = |index| objects.sphere(index).record.radius;
        let by_radius = |&left: &usize, &right: &usize| radius(left).total_cmp(&radius(right));
        let Some(largest) = (0..objects.sphere_count()).max_by(by_radius) else {
            return Self(None);
        };
        let others = (0..objects.sphere_count()).filter(|&index| index != largest).map(radius);
        let cylinders = (0..objects.cylinder_count()).map(|index| {
            let record = objects.cylinder(index).record;
            record.radius.hypot(record.half_height)
        });
        let next = others.chain(cylinders).fold(0.0, f64::max);
        Self((radius(largest) >= RATIO * next).then_some(largest as ObjectId))
    }

    /// Its position in the search.
    #[must_use]
    pub const fn id(self) -> Option<ObjectId> {
        self.0
    }

    /// Whether it is the object `id`.
    #[inline(always)]
    #[must_use]
    pub fn is(self, id: ObjectId) -> bool {
        self.0 == Some(id)
    }

    /// The objects that reach into it, but for what rounding may do to points of its surface: a ray from that surface that
    /// meets it again stays inside in between, for it is convex, and can meet no other. `None` when there are more than
    /// [`MOST_SUNK`], or no ground.
    #[must_use]
    pub fn sunk(self, objects: &impl Objects, extent: &Extent) -> Option<Vec<ObjectId>> {
        let ground = self.0?;
        let record = objects.sphere(ground as usize).record;
        // A textbook's root moves a point off the surface by some 26 units in the last place of (q + r^2) / r.
        let squares = 12.0 * extent.reach * extent.reach;
        let slack = 1e-9 * extent.reach + 64.0 * f64::EPSILON * squares / record.radius;
        let count = objects.sphere_count() + objects.cylinder_count();
        let mut sunk = Vec::new();
        for id in (0..count as ObjectId).filter(|&id| !self.is(id)) {
            if Bounds::of_object(objects, id as usize, extent).distance(record.center) <= record.radius + slack {
                if sunk.len() == MOST_SUNK {
                    return None;
                }
                sunk.push(id);
            }
        }
        Some(sunk)
    }

    /// Takes it into account, unless the ray certainly does not meet it.
    #[inline(always)]
    pub fn ask<O: Objects, P: Intersect>(self, found: &mut Found, objects: &O, touch: &Touch<f64>) {
        if let Some(id) = self.0
            && touch.sphere(&SphereTarget::new(&objects.sphere(id as usize).record))
        {
            found.ask_sphere::<O, P>(objects, id as usize, &touch.ray);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::AosObjects;
    use crate::scene::Scene;

    fn ground_of(objects: &str) -> Option<ObjectId> {
        let scene = Scene::parse(format!("matte: m 1 1 1\n{objects}").as_bytes()).expect("the scene is valid");
        Ground::of(&AosObjects::build(&scene).expect("it fits")).id()
    }

    #[test]
    fn only_a_sphere_much_larger_than_all_else_is_asked_apart() {
        assert_eq!(ground_of("sphere: 0 0 0 1 m\nsphere: 0 -9 0 8 m\n"), Some(1));
        assert_eq!(ground_of("sphere: 0 0 0 1 m\nsphere: 0 -9 0 7.9 m\n"), None);
        assert_eq!(ground_of("sphere: 0 -9 0 8 m\ncylinder: 0 0 0 .1 0 3 0 m\n"), None, "the cylinder is long");
        assert_eq!(ground_of("cylinder: 0 0 0 .1 0 3 0 m\n"), None, "there is no sphere");
        assert_eq!(ground_of("sphere: 0 0 0 1 m\n"), Some(0), "alone it is larger than all else");
    }
}
