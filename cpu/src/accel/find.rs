//! What the kinds of search have in common: walks are written once over it, and compiled for each kind apart.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::object::ObjectId;
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::materials::prepared::PreparedMaterial;
use crate::math::vec3::Vec3;
use crate::simd::Simd;

/// Where a ray starts.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// The object on whose surface.
    pub object: ObjectId,
    /// Whether it is expected to go into that object. What is found does not depend on it, but how soon.
    pub goes_in: bool,
}

/// A kind of search.
pub trait Accelerator {
    /// The nearest object that a ray meets. Who asks counts the ray.
    fn closest_hit_from<S: Simd, O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        origin: Origin,
        stack: &mut Stack,
    ) -> ClosestHit;

    /// Where a ray from the surface of `object` starts.
    #[inline(always)]
    fn origin<O: Objects>(&self, _: &O, _: &Ray, object: ObjectId) -> Origin {
        Origin { object, goes_in: false }
    }

    /// Where the ray starts that a surface with this finish makes, with a random vector, of one that has found it; told before
    /// that ray is known.
    #[inline(always)]
    fn next_origin<O: Objects>(&self, _: &O, _: &Ray, found: &ClosestHit, _: &PreparedMaterial, _: Vec3) -> Origin {
        Origin { object: found.object, goes_in: false }
    }
}
