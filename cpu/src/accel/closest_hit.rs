//! The closest hit found so far, for one ray. `render/hit_lanes.rs` has the closest hits of several rays at once.

use crate::accel::object::{NO_OBJECT, ObjectId, ObjectRef};
use crate::counters::{Counter, add};
use crate::exact::{self, error_bound::Decision};
use crate::geometry::{cylinder::CylinderPart, ray::Ray, tie::Place, tie::is_closer};
use crate::layout::Objects;

/// The closest hit among the objects intersected so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestHit {
    /// The lambda of the hit. It is infinite if there is no hit.
    pub lambda: f64,
    /// The object that is hit, or [`NO_OBJECT`] if there is no hit.
    pub object: ObjectId,
    /// The object's place in the scene file, which decides between hits at the same lambda.
    pub order: u32,
    /// The part of a cylinder that is hit. It is the side for a sphere.
    pub part: CylinderPart,
}

impl ClosestHit {
    /// The value before any hit. Every hit replaces it, even one whose lambda is infinite, because no hit at the same
    /// lambda has a lower rank than the last object's cap.
    pub const NOTHING: Self =
        Self { lambda: f64::INFINITY, object: NO_OBJECT, order: u32::MAX, part: CylinderPart::Bottom };

    #[inline(always)]
    fn place(&self) -> Place {
        Place { order: self.order, on_cap: self.part != CylinderPart::Side }
    }

    /// Whether any object is hit.
    #[inline(always)]
    pub const fn is_hit(&self) -> bool {
        self.object != NO_OBJECT
    }

    /// Replaces the hit by the one that the parameters describe, if that one is closer by the [rule for
    /// ties](crate::geometry::tie). `order` is the object's place in the scene file.
    #[inline(always)]
    pub fn update(&mut self, lambda: f64, object: ObjectId, order: u32, part: CylinderPart) {
        self.update_by(&Self { lambda, object, order, part });
    }

    /// Replaces the hit by `other`, which must be a hit, if that one is closer.
    #[inline(always)]
    pub fn update_by(&mut self, other: &Self) {
        debug_assert!(other.is_hit());
        if is_closer((other.lambda, other.place()), (self.lambda, self.place())) {
            *self = *other;
        }
    }

    /// Intersects the object with the number `id`, and updates the closest hit.
    #[inline(always)]
    pub fn intersect<O: Objects>(&mut self, objects: &O, id: ObjectId, ray: &Ray) {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => self.intersect_sphere(objects, index, ray),
            ObjectRef::Cylinder(index) => self.intersect_cylinder(objects, index, ray),
        }
    }

    /// Intersects the sphere at `index` among the spheres, and updates the closest hit.
    #[inline(always)]
    pub fn intersect_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let decision = exact::sphere::filtered(&objects.sphere(index).record, ray);
        self.update_by_sphere(objects, index, ray, decision);
    }

    /// Intersects the dominant sphere, which is at `index` among the spheres, and updates the closest hit. The
    /// compensated formula is inlined into this function, because the filter is often uncertain for rays that start
    /// near the dominant sphere.
    #[inline(always)]
    pub fn intersect_dominant_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let decision = exact::sphere::filtered_or_compensated(&objects.sphere(index).record, ray);
        self.update_by_sphere(objects, index, ray, decision);
    }

    #[inline(always)]
    fn update_by_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray, decision: Decision<Option<f64>>) {
        add(Counter::SphereTests, 1);
        let lambda = match decision {
            Decision::Certain(lambda) => lambda,
            Decision::Uncertain => precise_sphere(objects, index, *ray),
        };
        if let Some(lambda) = lambda {
            let id = ObjectRef::Sphere(index).number(objects.sphere_count());
            self.update(lambda, id, objects.sphere(index).order, CylinderPart::Side);
        }
    }

    /// Intersects the cylinder at `index` among the cylinders, and updates the closest hit.
    #[inline(always)]
    pub fn intersect_cylinder<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::CylinderTests, 1);
        let cylinder = objects.cylinder(index);
        let hit = match exact::cylinder::filtered(&cylinder.record, ray) {
            Decision::Certain(hit) => hit,
            Decision::Uncertain => precise_cylinder(objects, index, *ray),
        };
        if let Some((lambda, part)) = hit {
            let id = ObjectRef::Cylinder(index).number(objects.sphere_count());
            self.update(lambda, id, cylinder.order, part);
        }
    }
}

/// Returns the lambda by the compensated or precise formulas, or `None` for a miss. The function reads the object
/// again, and `ray` is no reference. So rays that do not need this function keep both in registers.
#[cold]
#[inline(never)]
fn precise_sphere<O: Objects>(objects: &O, index: usize, ray: Ray) -> Option<f64> {
    exact::sphere::compensated_or_precise(&objects.sphere(index).record, &ray)
}

/// Returns lambda and part by the precise formulas, or `None` for a miss. See [`precise_sphere`] for the parameters.
#[cold]
#[inline(never)]
fn precise_cylinder<O: Objects>(objects: &O, index: usize, ray: Ray) -> Option<(f64, CylinderPart)> {
    exact::cylinder::precise(&objects.cylinder(index).record, &objects.axis(index), &ray)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_hit_counts_and_of_those_at_the_same_lambda_the_last_side_or_the_first_cap() {
        let mut closest = ClosestHit::NOTHING;
        assert!(!closest.is_hit());
        closest.update(2.0, 7, 3, CylinderPart::Side);
        closest.update(2.0, 8, 1, CylinderPart::Side);
        assert_eq!(closest.object, 7);
        closest.update(2.0, 6, 4, CylinderPart::Top);
        closest.update(2.0, 9, 5, CylinderPart::Side);
        assert_eq!((closest.object, closest.part), (9, CylinderPart::Side));
        closest.update(1.0, 1, 0, CylinderPart::Side);
        closest.update(1.5, 2, 9, CylinderPart::Side);
        assert_eq!((closest.object, closest.lambda), (1, 1.0));
    }

    #[test]
    fn even_a_hit_at_infinity_is_a_hit() {
        let mut closest = ClosestHit::NOTHING;
        closest.update(f64::INFINITY, 5, 0, CylinderPart::Side);
        assert_eq!(closest.object, 5);
    }
}
