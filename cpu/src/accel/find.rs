//! The trait of acceleration structures; the path tracing loop is written once over it, and compiled for each.

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
    /// The closest hit of a ray. The caller counts the ray.
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

    /// The origin of the ray that a surface of this material scatters with a random vector; predicted before that ray
    /// is computed.
    #[inline(always)]
    fn next_origin<O: Objects>(&self, _: &O, _: &Ray, found: &ClosestHit, _: &PreparedMaterial, _: Vec3) -> Origin {
        Origin { object: found.object, goes_in: false }
    }
}
