//! The simplest acceleration structure, which intersects every object.

use crate::accel::{accelerator::Accelerator, accelerator::Start, closest_hit::ClosestHit, object::count};
use crate::{counters::Counter, counters::add, geometry::ray::Ray, layout::Objects, simd::Simd};

/// An acceleration structure without data, whose closest hit is found by intersecting every object of the scene.
/// [`Accel::new`](crate::accel::choice::Accel::new) chooses it for scenes whose numbers are too large or too small for
/// the other structures.
#[derive(Debug)]
pub struct EveryObject;

impl Accelerator for EveryObject {
    const IS_PROMPT: bool = true;

    #[inline(always)]
    fn closest_hit<S: Simd, O: Objects>(&mut self, objects: &O, ray: &Ray, _: Start) -> ClosestHit {
        intersect_every_object(objects, *ray)
    }
}

/// Returns the closest hit among all objects. The parameter `ray` is a value and no reference. Other structures seldom
/// call this function, and a reference would force them to keep every ray in memory instead of registers.
#[inline(never)]
pub fn intersect_every_object<O: Objects>(objects: &O, ray: Ray) -> ClosestHit {
    add(Counter::UnfilteredTests, count(objects) as u64);
    let mut closest = ClosestHit::NOTHING;
    for index in 0..objects.sphere_count() {
        closest.intersect_sphere(objects, index, &ray);
    }
    for index in 0..objects.cylinder_count() {
        closest.intersect_cylinder(objects, index, &ray);
    }
    closest
}
