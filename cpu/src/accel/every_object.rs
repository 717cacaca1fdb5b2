//! The plain search: every object is asked.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::Found;
use crate::accel::find::{Find, Origin};
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::simd::Simd;

/// Every object is asked.
#[derive(Debug)]
pub struct Plain;

impl Find for Plain {
    #[inline(always)]
    fn find<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Origin, _: &mut Stack) -> Found {
        plain(objects, ray)
    }
}

/// The nearest object, by asking every one.
#[inline(never)]
pub fn plain<O: Objects>(objects: &O, ray: &Ray) -> Found {
    add(Counter::PlainAsks, (objects.sphere_count() + objects.cylinder_count()) as u64);
    let mut found = Found::NOTHING;
    for index in 0..objects.sphere_count() {
        found.ask_sphere(objects, index, ray);
    }
    for index in 0..objects.cylinder_count() {
        found.ask_cylinder(objects, index, ray);
    }
    found
}
