//! What a ray hits: point, normal and material.

use crate::{
    accel::closest_hit::ClosestHit, accel::object::ObjectRef, counters::Counter, counters::add, geometry::ray::Ray,
    input::scene::MaterialId, layout::Objects, math::vec3::Vec3,
};

/// What a scattered ray depends on at the point where a ray hits an object: the hit point, the normal and the material.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit {
    /// The hit point, in scene units.
    pub point: Vec3,
    /// The normal that points out of the object. On the side of a cylinder it is as long as the radius. Elsewhere its
    /// length is one.
    pub outward: Vec3,
    /// The material of the object, an index.
    pub material: MaterialId,
}

impl SurfaceHit {
    /// Returns the hit point, the normal and the material of the closest hit, and counts the hit. `hit` must be a hit.
    #[inline(always)]
    pub fn new<O: Objects>(objects: &O, ray: &Ray, hit: &ClosestHit) -> Self {
        debug_assert!(hit.is_hit());
        add(Counter::Hits, 1);
        let point = ray.at(hit.lambda);
        match ObjectRef::of(objects, hit.object) {
            ObjectRef::Sphere(index) => {
                let sphere = objects.sphere(index);
                Self { point, outward: sphere.record.outward_by_reciprocal(point), material: sphere.material }
            }
            ObjectRef::Cylinder(index) => {
                let cylinder = objects.cylinder(index);
                Self { point, outward: cylinder.record.outward(hit.part, point), material: cylinder.material }
            }
        }
    }
}
