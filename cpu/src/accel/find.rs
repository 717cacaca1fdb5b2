//! The trait of acceleration structures. The path tracing loop is written once, generic over this trait, and compiled
//! for each structure.

use crate::accel::{bvh::stack::Stack, closest_hit::ClosestHit, object::ObjectId};
use crate::{geometry::ray::Ray, layout::Objects, materials::prepared::PreparedMaterial, math::vec3::Vec3, simd::Simd};

/// The object on which a ray starts, and whether the ray is expected to enter it.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// The object on whose surface the ray starts.
    pub object: ObjectId,
    /// Whether the ray is expected to enter that object. A wrong expectation costs time, but does not change the
    /// closest hit.
    pub enters: bool,
}

/// An acceleration structure, which finds the closest hit of a ray.
pub trait Accelerator {
    /// The closest hit of a ray that starts at `from`. The caller counts the ray.
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, from: Origin, stack: &mut Stack) -> ClosestHit;

    /// Returns the origin of a ray that starts on the surface of `object`.
    #[inline(always)]
    fn origin<O: Objects>(&self, _: &O, _: &Ray, object: ObjectId) -> Origin {
        Origin { object, enters: false }
    }

    /// Predicts the origin of the next ray of a path before that ray is computed. `hit` is the closest hit of the
    /// present ray. The surface there scatters with this material and this random vector.
    #[inline(always)]
    fn next_origin<O: Objects>(&self, _: &O, _: &Ray, hit: &ClosestHit, _: &PreparedMaterial, _: Vec3) -> Origin {
        Origin { object: hit.object, enters: false }
    }
}
