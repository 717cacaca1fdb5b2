//! The plain formula of ray and sphere with its error bound. This is a floating-point filter: it gives a result that is
//! certain, or none.
//!
//! See [`crate::geometry::sphere`] for the formula and [`crate::exact::error_bound`] for the bound. There are two
//! forms, which give the same bits. [`filtered_from`] has no branches, and serves lanes. [`filtered`] has branches, and
//! serves one ray, for which the form without branches computes roots that the branches skip.

use crate::exact::error_bound::{BoundConstants, Decision, ErrorBound, in_scale};
use crate::geometry::{ray::Ray, sphere::SphereRecord, sphere::SphereView};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The constants of the error bound for spheres. `tests/stability/src/proof/exact.rs` proves that an error constant of
/// 25.5 suffices. With this condition limit the relative error of lambda is proven to be at most 5.9e-12.
/// docs/accuracy has the largest error that `stress` finds. In ordinary pictures nearly all hits have a lambda with the
/// bits of the plain formula, and the others have a more accurate one (docs/accuracy/pictures.csv).
pub const SPHERE_BOUND: BoundConstants = BoundConstants { error_constant: 32.0, condition_limit: 12288.0 };

/// Computes the plain formula in the arithmetic `T`. Returns `Certain(Some(lambda))` for a hit, `Certain(None)` for a
/// miss, and `Uncertain` if rounding may have changed a decision or if lambda may be inaccurate.
#[inline(always)]
pub fn filtered<T: Rounding<Mask = bool>>(record: &SphereRecord<T>, ray: &Ray<T>) -> Decision<Option<T>> {
    filtered_or_lower_bound(record, ray).map_or(Decision::Uncertain, Decision::Certain)
}

/// Computes the plain formula as [`filtered`] does.
///
/// # Errors
/// If the plain formula is uncertain, the error is a [lower bound](ErrorBound::lower_bound_of_lambda) of the hit's
/// lambda.
#[inline(always)]
pub fn filtered_or_lower_bound<T: Rounding<Mask = bool>>(
    record: &SphereRecord<T>,
    ray: &Ray<T>,
) -> Result<Option<T>, T> {
    let a = ray.direction.dot(ray.direction);
    let view = record.seen_from(ray.origin);
    let (h, discriminant) = view.quadratic(ray.direction, a);
    let bound = ErrorBound::new(SPHERE_BOUND, a, view.squares);
    if !in_scale(a) {
        return Err(T::of(f64::NEG_INFINITY));
    }
    if bound.misses(discriminant) {
        return Ok(None);
    }
    let sqrt_d = discriminant.sqrt();
    let smaller_fails = bound.is_too_small(a, h - sqrt_d, sqrt_d);
    if !smaller_fails {
        let smaller = bound.root(a, h - sqrt_d, sqrt_d);
        if smaller.hits {
            return Ok(Some(smaller.lambda));
        }
    }
    let larger = bound.root(a, h + sqrt_d, sqrt_d);
    match (smaller_fails && larger.hits, larger.fails) {
        (true, _) => Ok(Some(larger.lambda)),
        // If the larger root is below the smallest lambda, the smaller root is too.
        (_, true) => Ok(None),
        _ => Err(bound.lower_bound_of_lambda(a, if smaller_fails { h + sqrt_d } else { h - sqrt_d }, sqrt_d)),
    }
}

/// The hits of several rays or spheres at once, one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct SphereHits<T: Real> {
    /// The lambda of the hit, or infinity if the ray misses the sphere. It has no meaning in a lane that is not
    /// `certain`.
    pub lambda: T,
    /// The lanes whose result is certain. The other lanes need
    /// [`compensated_or_precise`](crate::exact::sphere::compensated_or_precise).
    pub certain: T::Mask,
}

/// Computes the plain formula without a branch, for several lanes at once. Each lane gets the bits that [`filtered`]
/// gives. `view` has the sphere's terms for the rays' origin, and `a` is the square of the direction's length. The
/// caller checks once for each ray that the direction is [in scale](in_scale).
#[inline(always)]
pub fn filtered_from<T: Rounding>(view: &SphereView<T>, direction: Vec3<T>, a: T) -> SphereHits<T> {
    let (h, discriminant) = view.quadratic(direction, a);
    let bound = ErrorBound::new(SPHERE_BOUND, a, view.squares);
    let sqrt_d = discriminant.sqrt();
    let (smaller, larger) = (bound.root(a, h - sqrt_d, sqrt_d), bound.root(a, h + sqrt_d, sqrt_d));
    let misses = bound.misses(discriminant) | larger.fails;
    let lambda = T::select(smaller.hits, smaller.lambda, larger.lambda);
    SphereHits {
        lambda: T::select(misses, T::of(f64::INFINITY), lambda),
        certain: misses | smaller.hits | (smaller.fails & larger.hits),
    }
}
