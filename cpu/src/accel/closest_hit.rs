//! The nearest hit so far.

use crate::accel::conservative::Touch;
use crate::accel::object::{NOWHERE, ObjectId};
use crate::counters::{Counter, add};
use crate::exact;
use crate::exact::error_bound::Verdict;
use crate::geometry::cylinder::Part;
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::math::vec3::Vec3;
use crate::simd::Simd;

/// The nearest hit among the objects asked so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Where on the ray; infinite when there is none.
    pub lambda: f64,
    /// What is met, or [`NOWHERE`].
    pub object: ObjectId,
    /// The object's place in the file: of two hits at the same lambda the later object counts.
    pub order: u32,
    /// The part of a cylinder; the side for a sphere.
    pub part: Part,
}

impl Found {
    /// Nothing yet.
    pub const NOTHING: Self = Self { lambda: f64::INFINITY, object: NOWHERE, order: 0, part: Part::Side };

    /// Whether anything is met.
    #[inline(always)]
    #[must_use]
    pub const fn is_hit(&self) -> bool {
        self.object != NOWHERE
    }

    /// Takes a hit into account.
    #[inline(always)]
    pub fn offer(&mut self, lambda: f64, object: ObjectId, order: u32, part: Part) {
        if lambda < self.lambda || (lambda == self.lambda && (order > self.order || !self.is_hit())) {
            *self = Self { lambda, object, order, part };
        }
    }

    /// Takes the object at `id` into account.
    #[inline(always)]
    pub fn ask<O: Objects>(&mut self, objects: &O, id: ObjectId, ray: &Ray) {
        match (id as usize).checked_sub(objects.sphere_count()) {
            None => self.ask_sphere(objects, id as usize, ray),
            Some(index) => self.ask_cylinder(objects, index, ray),
        }
    }

    /// The same, unless the filter stops the ray, in a scene of this reach.
    #[inline(always)]
    pub fn ask_if_touched<O: Objects>(&mut self, objects: &O, id: ObjectId, touch: &Touch<f64>, reach: f64) {
        match (id as usize).checked_sub(objects.sphere_count()) {
            None => {
                if touch.sphere_at(objects, id as usize) {
                    self.ask_sphere(objects, id as usize, &touch.ray);
                }
            }
            Some(index) => {
                if touch.cylinder_at(objects, index, reach) {
                    self.ask_cylinder(objects, index, &touch.ray);
                }
            }
        }
    }

    /// Takes the sphere at `index` into account.
    #[inline(always)]
    pub fn ask_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let verdict = exact::sphere::judge(&objects.sphere(index).record, ray);
        self.take_sphere(objects, index, ray, verdict);
    }

    /// The same, for a sphere so large that rays near it are often in doubt.
    #[inline(always)]
    pub fn ask_large_sphere<S: Simd, O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        let record = objects.sphere(index).record;
        let verdict =
            if S::FUSES { exact::sphere::judge_large(&record, ray) } else { exact::sphere::judge(&record, ray) };
        self.take_sphere(objects, index, ray, verdict);
    }

    #[inline(always)]
    fn take_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray, verdict: Verdict<Option<f64>>) {
        add(Counter::SphereAsks, 1);
        let lambda = match verdict {
            Verdict::Certain(lambda) => lambda,
            Verdict::Doubtful => {
                let Ray { origin: o, direction: d } = *ray;
                resolve_sphere(objects, index, o.x, o.y, o.z, d.x, d.y, d.z)
            }
        };
        if let Some(lambda) = lambda {
            self.offer(lambda, index as ObjectId, objects.sphere(index).order, Part::Side);
        }
    }

    /// Takes the cylinder at `index` among the cylinders into account.
    #[inline(always)]
    pub fn ask_cylinder<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::CylinderAsks, 1);
        let cylinder = objects.cylinder(index);
        let met = match exact::cylinder::judge(&cylinder.record, ray) {
            Verdict::Certain(met) => met,
            Verdict::Doubtful => {
                let Ray { origin: o, direction: d } = *ray;
                resolve_cylinder(objects, index, o.x, o.y, o.z, d.x, d.y, d.z)
            }
        };
        if let Some((lambda, part)) = met {
            self.offer(lambda, (objects.sphere_count() + index) as ObjectId, cylinder.order, part);
        }
    }
}

/// The precise answer. It fetches the object again and takes the ray by components: what a call may read through a
/// reference would have to be in memory for every ray.
#[cold]
#[inline(never)]
#[expect(clippy::too_many_arguments, reason = "these fit the registers")]
fn resolve_sphere<O: Objects>(
    objects: &O,
    index: usize,
    x: f64,
    y: f64,
    z: f64,
    dx: f64,
    dy: f64,
    dz: f64,
) -> Option<f64> {
    let ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
    exact::sphere::reconsider(&objects.sphere(index).record, &ray)
}

/// See [`resolve_sphere`].
#[cold]
#[inline(never)]
#[expect(clippy::too_many_arguments, reason = "these fit the registers")]
fn resolve_cylinder<O: Objects>(
    objects: &O,
    index: usize,
    x: f64,
    y: f64,
    z: f64,
    dx: f64,
    dy: f64,
    dz: f64,
) -> Option<(f64, Part)> {
    let ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
    exact::cylinder::resolve(&objects.cylinder(index).record, &objects.axis(index), &ray)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_counts_and_of_equals_the_later_in_the_file() {
        let mut found = Found::NOTHING;
        assert!(!found.is_hit());
        found.offer(2.0, 7, 3, Part::Side);
        found.offer(2.0, 8, 1, Part::Side);
        assert_eq!(found.object, 7);
        found.offer(2.0, 9, 4, Part::Top);
        assert_eq!((found.object, found.part), (9, Part::Top));
        found.offer(1.0, 1, 0, Part::Side);
        found.offer(1.5, 2, 9, Part::Side);
        assert_eq!((found.object, found.lambda), (1, 1.0));
    }

    #[test]
    fn even_a_hit_at_infinity_is_a_hit() {
        let mut found = Found::NOTHING;
        found.offer(f64::INFINITY, 5, 0, Part::Side);
        assert_eq!(found.object, 5);
    }
}
