//! The plain search: every object is asked.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::find::{Accelerator, Origin};
use crate::accel::object::count;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::simd::Simd;

/// Every object is asked.
#[derive(Debug)]
pub struct EveryObject;

impl Accelerator for EveryObject {
    #[inline(always)]
    fn closest_hit_from<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Origin, _: &mut Stack) -> ClosestHit {
        plain(objects, ray)
    }
}

/// The nearest object, by asking every one.
#[inline(never)]
pub fn plain<O: Objects>(objects: &O, ray: &Ray) -> ClosestHit {
    add(Counter::PlainAsks, count(objects) as u64);
    let mut found = ClosestHit::NOTHING;
    for index in 0..objects.sphere_count() {
        found.intersect_sphere(objects, index, ray);
    }
    for index in 0..objects.cylinder_count() {
        found.intersect_cylinder(objects, index, ray);
    }
    found
}
