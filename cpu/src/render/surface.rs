//! The surface at a hit: point, normal and material.

use crate::{
    accel::closest_hit::ClosestHit, accel::object::ObjectRef, counters::Counter, counters::add, geometry::ray::Ray,
    input::scene::MaterialId, layout::Objects, math::vec3::Vec3,
};

/// A point on the surface of an object, where a ray hits it.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The hit point, in scene units.
    pub point: Vec3,
    /// The normal that points out of the object. On the side of a cylinder it is as long as the radius. Elsewhere its
    /// length is one.
    pub outward: Vec3,
    /// The material of the object, an index.
    pub material: MaterialId,
}

impl Surface {
    /// Returns the surface at the closest hit, which must be a hit, and counts the hit.
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
