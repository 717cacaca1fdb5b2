//! A search for scenes of a handful of objects: several rays at once, each against every object, in double precision.
//!
//! It says which objects a ray may meet, and so which rays certainly leave the scene; the exact formulas are for the
//! others. Its quadratics are theirs, to the bit, and its margins cover what rounding may do to them
//! (docs/performance.md).

use super::leaving::{crosses_slab, leaves_side, leaves_sphere, misses};
use super::{Found, ObjectId};
use crate::certified::Intersect;
use crate::cylinder::CylinderRecord;
use crate::layout::Objects;
use crate::prepare::Extent;
use crate::ray::Ray;
use crate::real::Real;
use crate::simd::Lanes;
use crate::sphere::SphereRecord;

/// Most objects.
pub const CAPACITY: usize = 8;

/// The objects, of which there are at most `CAPACITY`.
#[derive(Clone, Debug)]
pub struct Few {
    in_order: Vec<ObjectId>,
    /// How far rounding may move a point of the scene, many times over.
    slack: f64,
}

impl Few {
    /// The search over `objects`.
    #[must_use]
    pub fn new(objects: &impl Objects, extent: &Extent) -> Self {
        Self { in_order: super::in_order(objects), slack: extent.reach * (8192.0 * f64::EPSILON) }
    }

    /// The objects in the order of the file.
    #[must_use]
    pub fn in_order(&self) -> &[ObjectId] {
        &self.in_order
    }

    /// The nearest object that a ray, which starts within the scene's reach, meets.
    #[inline(always)]
    pub fn nearest<O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray) -> Found {
        let a = ray.direction.dot(ray.direction);
        let mut found = Found::NOTHING;
        for index in 0..objects.sphere_count() {
            if !misses_sphere(&objects.sphere(index).record, ray, a) {
                found.ask_sphere::<O, P>(objects, index, ray);
            }
        }
        for index in 0..objects.cylinder_count() {
            if !misses_cylinder(&objects.cylinder(index).record, ray, a, self.slack) {
                found.ask_cylinder::<O, P>(objects, index, ray);
            }
        }
        found
    }

    /// The objects that each ray, which starts within the scene's reach, may meet: the sum of 2^[id](ObjectId).
    #[inline(always)]
    pub fn touched<V: Lanes, O: Objects>(&self, objects: &O, ray: &Ray<V>) -> V {
        let a = ray.direction.dot(ray.direction);
        let mut touched = V::of(0.0);
        let mut weight = 1.0;
        for index in 0..objects.sphere_count() {
            let missed = misses_sphere(&objects.sphere(index).record, ray, a);
            touched = touched + V::select(missed, V::of(0.0), V::of(weight));
            weight += weight;
        }
        for index in 0..objects.cylinder_count() {
            let missed = misses_cylinder(&objects.cylinder(index).record, ray, a, self.slack);
            touched = touched + V::select(missed, V::of(0.0), V::of(weight));
            weight += weight;
        }
        touched
    }
}

/// Of objects that rays may meet, as [`Few::touched`] gives them, the nearest that this one meets.
#[inline(always)]
pub fn nearest_of<O: Objects, P: Intersect>(objects: &O, ray: &Ray, touched: u32) -> Found {
    let mut found = Found::NOTHING;
    // Object by object, so that the processor can guess which it will be before it knows the bits.
    for index in 0..objects.sphere_count() {
        if touched >> index & 1 == 1 {
            found.ask_sphere::<O, P>(objects, index, ray);
        }
    }
    for index in 0..objects.cylinder_count() {
        if touched >> (objects.sphere_count() + index) & 1 == 1 {
            found.ask_cylinder::<O, P>(objects, index, ray);
        }
    }
    found
}

/// Whether rays certainly do not meet the sphere. `a` is `direction.direction`.
#[inline(always)]
fn misses_sphere<V: Real>(record: &SphereRecord, ray: &Ray<V>, a: V) -> V::Mask {
    let view = record.lanes::<V>().seen_from(ray.origin);
    let (h, discriminant) = view.quadratic(ray.direction, a);
    let size = view.c.abs() + V::of(2.0 * record.radius_squared);
    misses(discriminant, a * size) | leaves_sphere(a, h, view.c, size)
}

/// Whether rays certainly do not meet the cylinder.
#[inline(always)]
fn misses_cylinder<V: Real>(record: &CylinderRecord, ray: &Ray<V>, a: V, slack: f64) -> V::Mask {
    let lanes = record.lanes::<V>();
    let view = lanes.seen_from(ray.origin);
    let (side_a, h, discriminant) = lanes.quadratic(&view, ray.direction);
    // The whole distance bounds what cancellation may have left of the perpendicular parts.
    let from_center = ray.origin - lanes.center;
    let size = from_center.dot(from_center) + lanes.radius_squared;
    let along = from_center.dot(lanes.axis);
    let slope = ray.direction.dot(lanes.axis);
    misses(discriminant, a * size)
        | leaves_side(side_a, h, view.c, size)
        | !crosses_slab(along, slope, V::of(record.half_height + slack))
}

/// Whether a scene of this many objects is searched like this.
#[must_use]
pub fn suits(objects: &impl Objects) -> bool {
    objects.sphere_count() + objects.cylinder_count() <= CAPACITY
}
