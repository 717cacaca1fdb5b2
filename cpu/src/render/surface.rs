//! The surface that a ray meets: its point, its normal, its material, and where it sends the ray.

use crate::accel::closest_hit::ClosestHit;
use crate::accel::object::{ObjectId, ObjectRef};
use crate::counters::{Counter, add};
use crate::geometry::ray::{Hit, Ray};
use crate::input::scene::MaterialId;
use crate::layout::Objects;
use crate::materials::prepared::{BsdfKind, PreparedMaterial};
use crate::materials::scatter;
use crate::math::vec3::Vec3;

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

/// Where a surface sends a ray.
#[derive(Clone, Copy, Debug)]
pub enum ScatterResult {
    /// Around this vector: a random one is added.
    Around(Vec3),
    /// Along this direction.
    Along(Vec3),
}

impl Surface {
    /// The surface at the closest hit.
    #[inline(always)]
    pub fn new<O: Objects>(objects: &O, ray: &Ray, found: &ClosestHit) -> Self {
        add(Counter::Hits, 1);
        let point = ray.at(found.lambda);
        match ObjectRef::of(objects, found.object) {
            ObjectRef::Sphere(index) => {
                let sphere = objects.sphere(index);
                Self { point, outward: sphere.record.outward(point), material: sphere.material }
            }
            ObjectRef::Cylinder(index) => {
                let cylinder = objects.cylinder(index);
                Self { point, outward: cylinder.record.outward(found.part, point), material: cylinder.material }
            }
        }
    }

    /// Scatters a ray that comes along `direction` by this prepared material.
    #[inline(always)]
    pub fn scatter_result(&self, material_data: &PreparedMaterial, direction: Vec3) -> ScatterResult {
        match material_data.kind {
            BsdfKind::Matte => ScatterResult::Around(Hit::facing(direction, self.point, self.outward).normal),
            // The mirror image is the same, to the bit, for a normal and its opposite: both signs cancel.
            BsdfKind::Metal => ScatterResult::Around(scatter::mirror(direction, self.outward)),
            BsdfKind::Refractive => {
                let hit = Hit::facing(direction, self.point, self.outward);
                let ratio = if hit.front { material_data.inverse_index } else { material_data.index };
                ScatterResult::Along(scatter::refract(direction, hit.normal, ratio))
            }
        }
    }
}

/// The material of the object at `object`.
#[inline(always)]
pub fn material_of<O: Objects>(objects: &O, object: ObjectId) -> MaterialId {
    match ObjectRef::of(objects, object) {
        ObjectRef::Sphere(index) => objects.sphere(index).material,
        ObjectRef::Cylinder(index) => objects.cylinder(index).material,
    }
}
