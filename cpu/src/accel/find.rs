//! The trait of acceleration structures. The path tracing loop is written once, generic over this trait, and compiled
//! for each structure.

use crate::accel::{bvh::stack::Stack, closest_hit::ClosestHit, object::ObjectId};
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::materials::prepared::PreparedMaterial;
use crate::math::vec3::Vec3;
use crate::simd::Simd;

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
    /// Returns the closest hit of a ray that starts at `origin`. `stack` is memory for the traversal. The caller adds
    /// the ray to the [`counters`](crate::counters).
    fn closest_hit_from<S: Simd, O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        origin: Origin,
        stack: &mut Stack,
    ) -> ClosestHit;

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
