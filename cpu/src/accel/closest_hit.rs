//! The nearest hit so far.

use crate::accel::object::{NOWHERE, ObjectId, ObjectRef};
use crate::counters::{Counter, add};
use crate::exact;
use crate::exact::error_bound::Decision;
use crate::geometry::cylinder::CylinderPart;
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::simd::Simd;

/// The closest hit among the objects intersected so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestHit {
    /// Where on the ray; infinite when there is none.
    pub lambda: f64,
    /// What is met, or [`NOWHERE`].
    pub object: ObjectId,
    /// The object's place in the file: of two hits at the same lambda the later object counts.
    pub order: u32,
    /// The part of a cylinder; the side for a sphere.
    pub part: CylinderPart,
}

impl ClosestHit {
    /// Nothing yet.
    pub const NOTHING: Self = Self { lambda: f64::INFINITY, object: NOWHERE, order: 0, part: CylinderPart::Side };

    /// Whether anything is met.
    #[inline(always)]
    #[must_use]
    pub const fn is_hit(&self) -> bool {
        self.object != NOWHERE
    }

    /// Takes a hit into account.
    #[inline(always)]
    pub fn update(&mut self, lambda: f64, object: ObjectId, order: u32, part: CylinderPart) {
        if lambda < self.lambda || (lambda == self.lambda && (order > self.order || !self.is_hit())) {
            *self = Self { lambda, object, order, part };
        }
    }

    /// Takes the object at `id` into account.
    #[inline(always)]
    pub fn intersect<O: Objects>(&mut self, objects: &O, id: ObjectId, ray: &Ray) {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => self.intersect_sphere(objects, index, ray),
            ObjectRef::Cylinder(index) => self.intersect_cylinder(objects, index, ray),
        }
    }

    /// Takes the sphere at `index` into account.
    #[inline(always)]
    pub fn intersect_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let verdict = exact::sphere::filtered(&objects.sphere(index).record, ray);
        self.take_sphere(objects, index, ray, verdict);
    }

    /// Intersects the dominant sphere, with the compensated formula inline: rays near it are often uncertain.
    #[inline(always)]
    pub fn intersect_dominant_sphere<S: Simd, O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let record = objects.sphere(index).record;
        let verdict = if S::FUSES {
            exact::sphere::filtered_or_compensated(&record, ray)
        } else {
            exact::sphere::filtered(&record, ray)
        };
        self.take_sphere(objects, index, ray, verdict);
    }

    #[inline(always)]
    fn take_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray, verdict: Decision<Option<f64>>) {
        add(Counter::SphereAsks, 1);
        let lambda = match verdict {
            Decision::Certain(lambda) => lambda,
            Decision::Uncertain => precise_sphere(objects, index, *ray),
        };
        if let Some(lambda) = lambda {
            self.update(lambda, index as ObjectId, objects.sphere(index).order, CylinderPart::Side);
        }
    }

    /// Takes the cylinder at `index` among the cylinders into account.
    #[inline(always)]
    pub fn intersect_cylinder<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::CylinderAsks, 1);
        let cylinder = objects.cylinder(index);
        let met = match exact::cylinder::filtered(&cylinder.record, ray) {
            Decision::Certain(met) => met,
            Decision::Uncertain => precise_cylinder(objects, index, *ray),
        };
        if let Some((lambda, part)) = met {
            self.update(lambda, (objects.sphere_count() + index) as ObjectId, cylinder.order, part);
        }
    }
}

/// The precise answer. It fetches the object again and takes the ray by value, so that neither has to be in memory for
/// rays that do not need it.
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
    fn the_nearest_counts_and_of_equals_the_later_in_the_file() {
        let mut found = ClosestHit::NOTHING;
        assert!(!found.is_hit());
        found.update(2.0, 7, 3, CylinderPart::Side);
        found.update(2.0, 8, 1, CylinderPart::Side);
        assert_eq!(found.object, 7);
        found.update(2.0, 9, 4, CylinderPart::Top);
        assert_eq!((found.object, found.part), (9, CylinderPart::Top));
        found.update(1.0, 1, 0, CylinderPart::Side);
        found.update(1.5, 2, 9, CylinderPart::Side);
        assert_eq!((found.object, found.lambda), (1, 1.0));
    }

    #[test]
    fn even_a_hit_at_infinity_is_a_hit() {
        let mut found = ClosestHit::NOTHING;
        found.update(f64::INFINITY, 5, 0, CylinderPart::Side);
        assert_eq!(found.object, 5);
    }
}
