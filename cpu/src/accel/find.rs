//! The trait of acceleration structures. The path tracing loop is written once, generic over this trait, and compiled
//! for each structure.

use crate::accel::{bvh::stack::Stack, closest_hit::ClosestHit, object::ObjectId};
use crate::{geometry::ray::Ray, layout::Objects, materials::prepared::PreparedMaterial, math::vec3::Vec3, simd::Simd};

/// The object on which a ray starts, and a prediction of whether the ray enters that object. A wrong prediction costs
/// time, but never changes the closest hit. Only the flat filter uses the prediction, for rays that start on the
/// dominant sphere.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// The object on whose surface the ray starts.
    pub object: ObjectId,
    /// Whether the ray is predicted to enter that object. [`Accelerator::origin`] finds this from the ray, and
    /// [`Accelerator::next_origin`] finds it before the ray is computed. After a wrong prediction every object is
    /// intersected, which costs time but gives the same closest hit.
    pub enters: bool,
}

/// An acceleration structure, which finds the closest hit of a ray.
pub trait Accelerator {
    /// Whether a ray may take milliseconds, because it may be tested against any number of objects.
    const MAY_BE_SLOW: bool = true;

    /// Returns the closest hit of a ray that starts at `from`. `stack` is memory for the traversal. The caller counts
    /// the ray.
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, from: Origin, stack: &mut Stack) -> ClosestHit;

    /// Returns the origin of a ray that starts on the surface of `object`.
    #[inline(always)]
    fn origin<O: Objects>(&self, _: &O, _: &Ray, object: ObjectId) -> Origin {
        Origin { object, enters: false }
    }

    /// Predicts the origin of the next ray of a path before that ray is computed. The parameters are the path's last
    /// ray, the ray's closest hit, and the material and the random vector with which the surface there scatters.
    #[inline(always)]
    fn next_origin<O: Objects>(&self, _: &O, _: &Ray, hit: &ClosestHit, _: &PreparedMaterial, _: Vec3) -> Origin {
        Origin { object: hit.object, enters: false }
    }
}
