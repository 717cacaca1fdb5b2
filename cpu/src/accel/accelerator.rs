//! The trait of acceleration structures. The path tracing loop is written once, generic over this trait, and compiled
//! for each structure ([`dispatch`](crate::accel::choice::dispatch)).

use crate::accel::{closest_hit::ClosestHit, object::ObjectId, stack::Stack};
use crate::{geometry::ray::Ray, layout::Objects, math::vec3::Vec3, simd::Simd};

/// The start of a ray: its start object, and a prediction of whether the ray enters that object. A wrong prediction
/// costs time, because every object is then intersected, but it never changes the closest hit. Only the flat filter
/// uses the prediction, for rays that start on the dominant sphere.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// The start object: the object on whose surface the ray starts.
    pub object: ObjectId,
    /// Whether the ray is predicted to enter that object. [`Accelerator::start`] finds this from the ray, and
    /// [`Accelerator::next_start`] finds it before the ray is computed.
    pub enters: bool,
}

/// What is known of a scattered ray before it is computed. Its direction is the sum of two vectors: the random vector,
/// and the normal or the mirrored direction.
#[derive(Clone, Copy, Debug)]
pub struct ScatterTerms {
    /// Whether the first term is the normal, as for a matte surface. Otherwise it is the mirrored direction.
    pub is_around_normal: bool,
    /// The random vector.
    pub vector: Vec3,
}

/// An acceleration structure, which finds the closest hit of a ray.
pub trait Accelerator {
    /// Whether a ray may take milliseconds, because it may be tested against any number of objects.
    const MAY_BE_SLOW: bool = true;

    /// Returns the closest hit of a ray. The caller counts the ray. `stack` is memory for the traversal of a tree.
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, start: Start, stack: &mut Stack) -> ClosestHit;

    /// Returns the start of a ray whose start object is `object`.
    #[inline(always)]
    fn start<O: Objects>(&self, _: &O, _: &Ray, object: ObjectId) -> Start {
        Start { object, enters: false }
    }

    /// Predicts the start of the next ray of a path before that ray is computed. The parameters are the path's last
    /// ray, the ray's closest hit, and the terms of the next ray's direction.
    #[inline(always)]
    fn next_start<O: Objects>(&self, _: &O, _: &Ray, hit: &ClosestHit, _: &ScatterTerms) -> Start {
        Start { object: hit.object, enters: false }
    }
}
