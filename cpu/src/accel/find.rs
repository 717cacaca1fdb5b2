//! The trait of acceleration structures; the path tracing loop is written once over it, and compiled for each.

use crate::accel::{bvh::stack::Stack, closest_hit::ClosestHit, object::ObjectId};
use crate::{geometry::ray::Ray, layout::Objects, materials::prepared::PreparedMaterial, math::vec3::Vec3, simd::Simd};

/// Where a ray starts.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// The object on whose surface the ray starts.
    pub object: ObjectId,
    /// Whether the ray is expected to enter that object. The closest hit does not depend on it, but the time does.
    pub enters: bool,
}

/// An acceleration structure.
pub trait Accelerator {
    /// The closest hit of a ray that starts at `from`. The caller counts the ray.
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, from: Origin, stack: &mut Stack) -> ClosestHit;

    /// Where a ray from the surface of `object` starts.
    #[inline(always)]
    fn origin<O: Objects>(&self, _: &O, _: &Ray, object: ObjectId) -> Origin {
        Origin { object, enters: false }
    }

    /// The origin of the ray that a surface of this material scatters with a random vector, predicted before that ray
    /// is computed.
    #[inline(always)]
    fn next_origin<O: Objects>(&self, _: &O, _: &Ray, hit: &ClosestHit, _: &PreparedMaterial, _: Vec3) -> Origin {
        Origin { object: hit.object, enters: false }
    }
}
