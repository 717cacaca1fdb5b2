//! The plain formula of ray and sphere with its error bound: a floating-point filter, whose result is certain, or none.
//!
//! See [`crate::geometry::sphere`] for the formula and [`crate::exact::error_bound`] for the bound. There
//! are two forms with the same bits: without branches for lanes, and with branches for one ray, where the form for
//! lanes takes 61 % more instructions.

use crate::exact::error_bound::{Decision, ErrorBound, Limits, in_scale};
use crate::geometry::{ray::Ray, sphere::SphereRecord, sphere::SphereView};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// Counted in `docs/accuracy.md`: the error constant is at most 26. With this condition limit lambdas are right to
/// 5.9e-12 (a search reached 2.7e-12) and 99.6 % of an ordinary picture's keep the bits of the plain formula.
pub const LIMITS: Limits = Limits { error_constant: 32.0, condition_limit: 12288.0 };

/// Returns the result of the plain formula in the arithmetic `T`, or that rounding may have changed it.
#[inline(always)]
pub fn filtered<T: Rounding<Mask = bool>>(record: &SphereRecord<T>, ray: &Ray<T>) -> Decision<Option<T>> {
    let a = ray.direction.dot(ray.direction);
    let view = record.seen_from(ray.origin);
    let (h, discriminant) = view.quadratic(ray.direction, a);
    let bound = ErrorBound::new(LIMITS, a, view.squares);
    if !in_scale(a) {
        return Decision::Uncertain;
    }
    if bound.misses(discriminant) {
        return Decision::Certain(None);
    }
    let root = discriminant.sqrt();
    let near_fails = bound.is_too_small(a, h - root, root);
    if !near_fails {
        let near = bound.root(a, h - root, root);
        if near.hits {
            return Decision::Certain(Some(near.lambda));
        }
    }
    let far = bound.root(a, h + root, root);
    match (near_fails && far.hits, far.fails) {
        (true, _) => Decision::Certain(Some(far.lambda)),
        // If the larger root is too near, the smaller is too.
        (_, true) => Decision::Certain(None),
        _ => Decision::Uncertain,
    }
}

/// The hits of several rays or spheres at once.
#[derive(Clone, Copy, Debug)]
pub struct SphereHits<T: Real> {
    /// The result of the plain formula; infinite where it finds no hit. Undefined in a lane that is not certain.
    pub lambda: T,
    /// Lanes whose result is right. The others need
    /// [`compensated_or_precise`](crate::exact::sphere::compensated_or_precise).
    pub certain: T::Mask,
}

/// [`filtered`] without a branch, for several lanes at once: the same bits in every lane, for the sphere as it is seen
/// from the origin of the rays. `a` is the direction's length squared; the caller checks, once a ray, that it is
/// [in scale](in_scale).
#[inline(always)]
pub fn filtered_from<T: Rounding>(view: &SphereView<T>, direction: Vec3<T>, a: T) -> SphereHits<T> {
    let (h, discriminant) = view.quadratic(direction, a);
    let bound = ErrorBound::new(LIMITS, a, view.squares);
    let root = discriminant.sqrt();
    let (near, far) = (bound.root(a, h - root, root), bound.root(a, h + root, root));
    let misses = bound.misses(discriminant) | far.fails;
    let lambda = T::select(near.hits, near.lambda, far.lambda);
    SphereHits {
        lambda: T::select(misses, T::of(f64::INFINITY), lambda),
        certain: misses | near.hits | (near.fails & far.hits),
    }
}
