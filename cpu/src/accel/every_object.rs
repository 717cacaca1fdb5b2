//! The simplest acceleration structure, which intersects every object.

use std::ops::Range;

use crate::accel::{
    accelerator::Accelerator, accelerator::Start, closest_hit::ClosestHit, object::ObjectId, object::count,
    object::cylinder_index, stack::Stack,
};
use crate::{counters::Counter, counters::add, geometry::ray::Ray, layout::Objects, simd::Simd};

/// An acceleration structure without data, whose closest hit is found by intersecting every object of the scene.
/// [`Accel::new`](crate::accel::choice::Accel::new) chooses it for scenes whose numbers are too large or too small for
/// the other structures.
#[derive(Debug)]
pub struct EveryObject;

impl Accelerator for EveryObject {
    #[inline(always)]
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Start, _: &mut Stack) -> ClosestHit {
        intersect(objects, every(objects), ray)
    }
}

/// Returns the numbers of all spheres, and those of all cylinders.
#[inline(always)]
fn every<O: Objects>(objects: &O) -> [Range<ObjectId>; 2] {
    let spheres = objects.sphere_count() as ObjectId;
    [0..spheres, spheres..count(objects) as ObjectId]
}

/// Returns the closest hit among all objects. The parameter `ray` is a value and no reference. Other structures seldom
/// call this function, and a reference would force them to keep every ray in memory instead of registers.
#[inline(never)]
pub fn intersect_every_object<O: Objects>(objects: &O, ray: Ray) -> ClosestHit {
    intersect(objects, every(objects), &ray)
}

/// Returns the closest hit among the objects with these numbers, spheres and cylinders.
#[inline(never)]
pub(crate) fn intersect_objects<O: Objects>(objects: &O, numbers: [Range<ObjectId>; 2], ray: Ray) -> ClosestHit {
    intersect(objects, numbers, &ray)
}

/// Does what [`intersect_objects`] does, compiled for the caller's instruction set. Among extreme magnitudes the plain
/// formula of a sphere is often uncertain, so the compensated formula is inlined too.
#[inline(always)]
fn intersect<O: Objects>(objects: &O, [spheres, cylinders]: [Range<ObjectId>; 2], ray: &Ray) -> ClosestHit {
    add(Counter::UnfilteredTests, (spheres.len() + cylinders.len()) as u64);
    let mut closest = ClosestHit::NOTHING;
    for id in spheres {
        closest.intersect_uncertain_sphere(objects, id as usize, ray);
    }
    for id in cylinders {
        closest.intersect_cylinder(objects, cylinder_index(objects, id), ray);
    }
    closest
}
