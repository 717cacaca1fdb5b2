//! Exact intersection of ray and sphere, in four steps. They are the plain formula with its [error
//! bound](crate::exact::sphere_filter), the [compensated](sphere_compensated) formula, [double-double](sphere_wide)
//! arithmetic, and dyadic arithmetic. A step is needed only if the step before it is uncertain.
//!
//! In dyadic arithmetic the coefficients of the quadratic are sums of products of the inputs. So the coefficients, the
//! discriminant and the result of every comparison are exact. Only for the root itself they are rounded, to 106 bits
//! each.

use crate::counters::{Counter, add};
use crate::exact::exact_lambda::{ExactLambda, ExactQuadratic};
use crate::exact::exact_vector::{Exact3, ExactResult, NotFinite, exact_least_lambda, to_dyadic};
pub use crate::exact::sphere_filter::{filtered, filtered_from, filtered_or_lower_bound};
use crate::exact::{error_bound::Decision, sphere_compensated, sphere_wide};
use crate::geometry::{ray::Ray, sphere::SphereRecord};
use crate::simd::fused::run_fused;

/// Returns the lambda at which the ray hits the sphere: the smallest lambda, of at least
/// [`LAMBDA_MIN`](crate::geometry::ray::LAMBDA_MIN) when it is rounded to `f64`, for which `ray.at(lambda)` is on the
/// sphere. If there is none, the ray misses, and the result is `None`. Rounding changes neither whether the ray hits
/// nor which of the two roots is returned, and the relative error of lambda is at most 5.9e-12. The plain formula,
/// [`SphereRecord::intersect`], is faster and does not guarantee this.
///
/// ```
/// use cpu::intersect::{self, SphereRecord};
/// use cpu::{Ray, Vec3};
///
/// // A grain of sand, 10 km away, hit at its rim. The discriminant of the plain formula is nothing but rounding error.
/// let sand = SphereRecord::new(Vec3::new(1e-4, 0.0, 1e4), 1e-4);
/// let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(0.0, 0.0, 1.0) };
/// assert_eq!(intersect::sphere(&sand, &ray), Some(1e4));
/// ```
#[inline(always)]
#[must_use]
pub fn intersect(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    match filtered(record, ray) {
        Decision::Certain(hit) => hit,
        Decision::Uncertain => compensated_or_precise(record, ray),
    }
}

/// Returns the result of [`filtered`]. If that is uncertain, the result is that of [`sphere_compensated::compensated`].
/// Both are inlined, unlike [`compensated_or_precise`]. This serves a large sphere, for which the filter is uncertain
/// about most rays that start near it.
#[inline(always)]
pub fn filtered_or_compensated(record: &SphereRecord, ray: &Ray) -> Decision<Option<f64>> {
    let decision = filtered(record, ray);
    if decision != Decision::Uncertain {
        return decision;
    }
    let decision = sphere_compensated::compensated(record, ray);
    add(Counter::Compensated, u64::from(decision != Decision::Uncertain));
    decision
}

/// Returns the lambda of a ray for which [`filtered`] is uncertain, or `None` for a miss. The compensated formula runs
/// first. If it is uncertain too, [`wide_or_precise`] gives the result.
#[cold]
#[inline(never)]
pub fn compensated_or_precise(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    let decision = run_fused!(|record: &SphereRecord, ray: &Ray| -> Decision<Option<f64>> {
        sphere_compensated::compensated(record, ray)
    });
    add(Counter::Compensated, u64::from(decision != Decision::Uncertain));
    match decision {
        Decision::Certain(hit) => hit,
        Decision::Uncertain => wide_or_precise(record, ray),
    }
}

/// Returns the lambda, or `None` for a miss, by [double-double](sphere_wide) arithmetic. If that is uncertain,
/// [`precise`] gives the result. Where it is certain, [`precise`] would give the same: the `f64` nearest to the exact
/// lambda.
#[cold]
#[inline(never)]
pub(crate) fn wide_or_precise(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    match wide(record, ray) {
        Decision::Certain(hit) => hit,
        Decision::Uncertain => precise(record, ray),
    }
}

/// Returns the lambda, or `None` for a miss, if double-double arithmetic is certain about it.
pub(crate) fn wide(record: &SphereRecord, ray: &Ray) -> Decision<Option<f64>> {
    let decision =
        run_fused!(|record: &SphereRecord, ray: &Ray| -> Decision<Option<f64>> { sphere_wide::wide(record, ray) });
    add(Counter::Wide, u64::from(decision != Decision::Uncertain));
    decision
}

/// Returns the lambda, or `None` for a miss, by dyadic arithmetic, which takes some thousand operations.
#[cold]
#[inline(never)]
pub fn precise(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    add(Counter::Fallbacks, 1);
    match exact_lambda(record, ray) {
        Ok(lambda) => lambda.map(|lambda| lambda.rounded()),
        Err(NotFinite) => record.intersect(ray),
    }
}

/// Returns the exact lambda at which the ray hits the sphere, or `None` if it misses. The error says that an input is
/// not finite.
pub(crate) fn exact_lambda(record: &SphereRecord, ray: &Ray) -> ExactResult<ExactLambda> {
    let direction = Exact3::new(ray.direction)?;
    let to_center = Exact3::new(record.center)?.minus(&Exact3::new(ray.origin)?);
    let c = &to_center.dot(&to_center) - &to_dyadic(record.radius)?.squared();
    let least = exact_least_lambda()?;
    let quadratic = ExactQuadratic::with_roots(direction.dot(&direction), direction.dot(&to_center), c);
    Ok(quadratic.and_then(|quadratic| quadratic.smallest_root(|root| root.is_at_least(&least))))
}

#[cfg(test)]
mod tests;
