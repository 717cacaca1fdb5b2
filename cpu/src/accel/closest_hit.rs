//! The closest hit so far of one ray. Several rays at once have theirs in `render/hit_lanes.rs`.

use crate::accel::object::{NO_OBJECT, ObjectId, ObjectRef};
use crate::counters::{Counter, add};
use crate::exact::{self, error_bound::Decision};
use crate::geometry::{cylinder::CylinderPart, ray::Ray, tie::is_closer};
use crate::layout::Objects;

/// The closest hit among the objects intersected so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestHit {
    /// Lambda of the hit; infinite if there is no hit.
    pub lambda: f64,
    /// The object that is hit, or [`NO_OBJECT`].
    pub object: ObjectId,
    /// The object's place in the file, which decides between two hits at the same lambda.
    pub order: u32,
    /// The part of a cylinder; the side for a sphere.
    pub part: CylinderPart,
}

impl ClosestHit {
    /// No hit. Any hit is closer, even one at infinity.
    pub const NOTHING: Self = Self { lambda: f64::INFINITY, object: NO_OBJECT, order: 0, part: CylinderPart::Side };

    /// Whether any object is hit.
    #[inline(always)]
    pub const fn is_hit(&self) -> bool {
        self.object != NO_OBJECT
    }

    /// Replaces the hit by this one if it is closer.
    #[inline(always)]
    pub fn update(&mut self, lambda: f64, object: ObjectId, order: u32, part: CylinderPart) {
        if is_closer((lambda, order), (self.lambda, self.order)) {
            *self = Self { lambda, object, order, part };
        }
    }

    /// Intersects the object at `id`.
    #[inline(always)]
    pub fn intersect<O: Objects>(&mut self, objects: &O, id: ObjectId, ray: &Ray) {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => self.intersect_sphere(objects, index, ray),
            ObjectRef::Cylinder(index) => self.intersect_cylinder(objects, index, ray),
        }
    }

    /// Intersects the sphere at `index`.
    #[inline(always)]
    pub fn intersect_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let decision = exact::sphere::filtered(&objects.sphere(index).record, ray);
        self.update_by_sphere(objects, index, ray, decision);
    }

    /// Intersects the dominant sphere, with the compensated formula inline: rays near it are often uncertain.
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
            self.update(lambda, index as ObjectId, objects.sphere(index).order, CylinderPart::Side);
        }
    }

    /// Intersects the cylinder at `index` among the cylinders.
    #[inline(always)]
    pub fn intersect_cylinder<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::CylinderTests, 1);
        let cylinder = objects.cylinder(index);
        let hit = match exact::cylinder::filtered(&cylinder.record, ray) {
            Decision::Certain(hit) => hit,
            Decision::Uncertain => precise_cylinder(objects, index, *ray),
        };
        if let Some((lambda, part)) = hit {
            self.update(lambda, (objects.sphere_count() + index) as ObjectId, cylinder.order, part);
        }
    }
}

/// The hit by the precise formulas. The function fetches the object again and takes the ray by value, so that neither
/// has to be in memory for rays that do not need it.
#[cold]
#[inline(never)]
fn precise_sphere<O: Objects>(objects: &O, index: usize, ray: Ray) -> Option<f64> {
    exact::sphere::compensated_or_precise(&objects.sphere(index).record, &ray)
}

/// See [`precise_sphere`].
#[cold]
#[inline(never)]
fn precise_cylinder<O: Objects>(objects: &O, index: usize, ray: Ray) -> Option<(f64, CylinderPart)> {
    exact::cylinder::precise(&objects.cylinder(index).record, &objects.axis(index), &ray)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_hit_counts_and_of_two_at_the_same_lambda_the_later() {
        let mut closest = ClosestHit::NOTHING;
        assert!(!closest.is_hit());
        closest.update(2.0, 7, 3, CylinderPart::Side);
        closest.update(2.0, 8, 1, CylinderPart::Side);
        assert_eq!(closest.object, 7);
        closest.update(2.0, 9, 4, CylinderPart::Top);
        assert_eq!((closest.object, closest.part), (9, CylinderPart::Top));
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
