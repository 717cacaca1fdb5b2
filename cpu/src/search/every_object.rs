//! The plain search: every object is asked.

use super::find::{Find, Origin};
use super::found::Found;
use super::stack::Stack;
use crate::counters::{Counter, add};
use crate::layout::Objects;
use crate::ray::Ray;
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
