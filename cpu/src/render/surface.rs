//! The surface that a ray hits: its point, its normal and its material.

use crate::{
    accel::closest_hit::ClosestHit, accel::object::ObjectRef, counters::Counter, counters::add, geometry::ray::Ray,
    input::scene::MaterialId, layout::Objects, math::vec3::Vec3,
};

/// A point of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The point.
    pub point: Vec3,
    /// The normal that leaves the object.
    pub outward: Vec3,
    /// The object's material.
    pub material: MaterialId,
}

impl Surface {
    /// The surface at the closest hit.
    #[inline(always)]
    pub fn new<O: Objects>(objects: &O, ray: &Ray, hit: &ClosestHit) -> Self {
        add(Counter::Hits, 1);
        let point = ray.at(hit.lambda);
        match ObjectRef::of(objects, hit.object) {
            ObjectRef::Sphere(index) => {
                let sphere = objects.sphere(index);
                Self { point, outward: sphere.record.outward(point), material: sphere.material }
            }
            ObjectRef::Cylinder(index) => {
                let cylinder = objects.cylinder(index);
                Self { point, outward: cylinder.record.outward(hit.part, point), material: cylinder.material }
            }
        }
    }
}
