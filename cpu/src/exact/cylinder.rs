//! Exact intersection of ray and closed cylinder: a ladder of three steps. A step is taken only if the step before it
//! is uncertain.
//!
//! 1. [`filtered`]: [plain](crate::exact::cylinder_plain) formulas with a bound of their rounding errors.
//! 2. [`compensated`]: [formulas](crate::exact::cylinder_compensated) in which less cancels.
//! 3. [`precise`]: dyadic arithmetic, which has no rounding. It is in this file, and defines what steps 1 and 2 must
//!    decide. Before it, [`compensated_or_precise`] intersects the ray with a larger sphere around the cylinder. A ray
//!    that misses the sphere misses the cylinder. This helps if the ray starts so far away that the cylinder's formulas
//!    overflow.
//!
//! How is one hit of a cylinder decided? Read three files, in this order, each from top to bottom:
//!
//! 1. `exact/cylinder.rs`, this file: the ladder, and step 3, which has no rounding;
//! 2. `exact/cylinder_decision.rs`: how [`decide`] decides in steps 1 and 2, by what is certain about side and caps;
//! 3. `exact/cylinder_plain.rs`: the formulas of step 1, with their error bounds. Those of step 2 give the same kinds
//!    of facts.
//!
//! Let `O + lambda d` be the ray, `C` the cylinder's centre, `V` the axis of the scene file, and `q = O - C`. The
//! formulas of step 3 are multiplied by `V.V`, so that they need no unit vector:
//!
//! - the side is `a lambda^2 - 2 h lambda + c = 0` with `a = |d x V|^2`, `h = -(q x V).(d x V)` and
//!   `c = |q x V|^2 - r^2 V.V`;
//! - a point `P` is between the caps if `|(P - C).V| <= V.V / 2`;
//! - the plane of the top cap is `(P - C).V = V.V / 2`.

use std::cmp::Ordering;

use crate::counters::{Counter, add};
use crate::exact::cylinder_compensated::{CompensatedCaps, CompensatedSide};
use crate::exact::cylinder_decision::{CylinderHit, decide, is_inside, with_caps};
use crate::exact::cylinder_plain::{PlainCaps, PlainSide, is_long};
use crate::exact::exact_lambda::{ExactLambda, ExactQuadratic};
use crate::exact::exact_vector::{Exact3, ExactResult, NotFinite, exact_least_lambda, to_dyadic};
use crate::exact::{error_bound::Decision, error_bound::in_scale, sphere};
use crate::geometry::{
    cap::PARALLEL, cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord,
};
use crate::math::{dyadic::Dyadic, rounding::Rounding, vec3::Vec3};
use crate::simd::fused::run_fused;

/// Returns lambda and part of the ray's closest hit with the side, the top cap or the bottom cap, or `None` if the ray
/// misses all three. Of parts at the same lambda, the first in this order counts. [`CylinderRecord::intersect`] follows
/// this rule with rounding errors, but here rounding never changes a decision. `file_axis` is the axis of the scene
/// file, and its length is the cylinder's height. `record` must be made from this axis, and the length must be finite.
///
/// ```
/// use cpu::intersect::{self, CylinderPart, CylinderRecord};
/// use cpu::{Ray, Vec3};
///
/// let axis = Vec3::new(0.0, 4.0, 0.0);
/// let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, axis);
/// // The ray passes exactly through the rim. Side and cap have the same lambda, and the side counts.
/// let ray = Ray { origin: Vec3::new(0.0, 4.0, -3.0), direction: Vec3::new(0.0, -1.0, 1.0) };
/// assert_eq!(intersect::cylinder(&cylinder, &axis, &ray), Some((2.0, CylinderPart::Side)));
/// ```
#[inline(always)]
#[must_use]
pub fn intersect(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    debug_assert!(is_made_from(record, *file_axis));
    match filtered(record, ray) {
        Decision::Certain(hit) => hit,
        Decision::Uncertain => compensated_or_precise(record, file_axis, ray),
    }
}

/// Whether the record is that of a cylinder with this axis, or the axis has no direction in `f64`.
fn is_made_from(record: &CylinderRecord, file_axis: Vec3) -> bool {
    let (unit, height) = file_axis.unit_and_length();
    (unit, height / 2.0) == (record.axis, record.half_height) || !unit.is_finite()
}

/// Computes the plain formulas in the arithmetic `T`. Returns `Certain(Some((lambda, part)))` for a hit,
/// `Certain(None)` for a miss, and `Uncertain` if rounding may have changed a decision.
#[inline(always)]
pub fn filtered<T: Rounding<Mask = bool>>(record: &CylinderRecord<T>, ray: &Ray<T>) -> Decision<CylinderHit<T>> {
    decide(record, ray, &PlainSide::new(record, &record.seen_from(ray.origin), ray, is_long(record)), &PlainCaps)
}

/// Intersects a ray for which [`filtered`] is uncertain. The [compensated](crate::exact::cylinder_compensated) formulas
/// are tried first. If they are uncertain too, and the ray does not certainly miss a sphere around the cylinder,
/// [`precise`] gives the result. `file_axis` is the axis of the scene file.
#[cold]
#[inline(never)]
pub fn compensated_or_precise(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    match compensated(record, file_axis, ray) {
        Decision::Certain(hit) => {
            add(Counter::Compensated, 1);
            hit
        }
        Decision::Uncertain if sphere::wide(&sphere_around(record), ray) == Decision::Certain(None) => None,
        Decision::Uncertain => precise(record, file_axis, ray),
    }
}

/// Returns a sphere that holds the cylinder. It is larger than needed, so no rounding error makes it too small.
fn sphere_around(record: &CylinderRecord) -> SphereRecord {
    SphereRecord::new(record.center, 2.0 * (record.radius + record.half_height))
}

/// Returns the hit by the [compensated](crate::exact::cylinder_compensated) formulas, if rounding certainly has not
/// changed it.
pub fn compensated(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Decision<CylinderHit<f64>> {
    run_fused!(|record: &CylinderRecord, file_axis: &Vec3, ray: &Ray| -> Decision<CylinderHit<f64>> {
        let caps = CompensatedCaps(*file_axis);
        // If a cylinder is not long, most uncertain rays from inside are uncertain only because of a cap.
        if !is_long(record) && is_inside(&record.seen_from(ray.origin)) && in_scale(ray.direction.dot(ray.direction)) {
            let decision = with_caps(record, ray, &caps, Decision::Uncertain);
            if decision != Decision::Uncertain {
                return decision;
            }
        }
        decide(record, ray, &CompensatedSide::new(record, *file_axis, ray), &caps)
    })
}

/// Intersects a ray by dyadic arithmetic. This takes some thousand operations, and few rays need it. `file_axis` is the
/// axis of the scene file.
#[cold]
#[inline(never)]
pub fn precise(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    add(Counter::Fallbacks, 1);
    closest_exactly(record, *file_axis, ray).unwrap_or_else(|NotFinite| record.intersect(ray))
}

/// Returns the rounded lambda and the part of the ray's hit with the cylinder, or `None` if it misses. `file_axis` is
/// the axis of the scene file, and its length is the cylinder's height. The error says that an input is not finite.
fn closest_exactly(record: &CylinderRecord, file_axis: Vec3, ray: &Ray) -> ExactResult<(f64, CylinderPart)> {
    let terms = ExactTerms::new(record, file_axis, ray)?;
    let parts = [terms.side(), terms.cap(false)?, terms.cap(true)?];
    Ok(closest_part(parts).map(|(lambda, part)| (lambda.rounded(), part)))
}

/// The terms of the formulas of side and caps as exact numbers: a ray, a cylinder, and the products that both formulas
/// use.
struct ExactTerms {
    /// `d`: the ray's direction.
    direction: Exact3,
    /// `q`: the vector from the cylinder's centre to the ray's origin.
    from_center: Exact3,
    /// `V`: the axis of the scene file, which is as long as the cylinder is high.
    file_axis: Exact3,
    radius_squared: Dyadic,
    /// Half of `V.V`.
    half: Dyadic,
    /// `d.V`.
    slope: Dyadic,
    /// `q.V`.
    start_along: Dyadic,
    /// [`exact_least_lambda`].
    lambda_min: Dyadic,
}

impl ExactTerms {
    fn new(
        &CylinderRecord { center, radius, .. }: &CylinderRecord,
        file_axis: Vec3,
        ray: &Ray,
    ) -> Result<Self, NotFinite> {
        let (direction, file_axis) = (Exact3::new(ray.direction)?, Exact3::new(file_axis)?);
        let from_center = Exact3::new(ray.origin)?.minus(&Exact3::new(center)?);
        let (half, slope, start_along) =
            (file_axis.dot(&file_axis).times_power_of_two(-1), direction.dot(&file_axis), from_center.dot(&file_axis));
        let (radius_squared, lambda_min) = (to_dyadic(radius)?.squared(), exact_least_lambda()?);
        Ok(Self { direction, from_center, file_axis, radius_squared, half, slope, start_along, lambda_min })
    }

    /// Returns the side's lambda, or `None` if the ray misses the side.
    fn side(&self) -> Option<ExactLambda> {
        let length_squared = self.half.times_power_of_two(1);
        let flat = |product: Dyadic, along: Dyadic| &(&product * &length_squared) - &along;
        let a = flat(self.direction.dot(&self.direction), self.slope.squared());
        let minus_h = flat(self.from_center.dot(&self.direction), &self.start_along * &self.slope);
        let c = flat(&self.from_center.dot(&self.from_center) - &self.radius_squared, self.start_along.squared());
        ExactQuadratic::with_roots(a, -&minus_h, c)?.smallest_root(|root| self.side_counts(root))
    }

    /// Whether a root is in range, and its point is between the caps' planes.
    fn side_counts(&self, root: &ExactLambda) -> bool {
        let Self { half, slope, start_along, lambda_min, .. } = self;
        root.is_at_least(lambda_min)
            && root.is_linear_form_nonnegative(&(half - start_along), &-slope)
            && root.is_linear_form_nonnegative(&(half + start_along), slope)
    }

    /// Returns the lambda of a cap's plane as numerator and denominator. The denominator is not negative.
    fn plane(&self, is_bottom: bool) -> (Dyadic, Dyadic) {
        let Self { half, slope, start_along, .. } = self;
        let signed_half = if is_bottom { -half } else { half.clone() };
        let numerator = &signed_half - start_along;
        match slope.sign() {
            Ordering::Less => (-&numerator, -slope),
            _ => (numerator, slope.clone()),
        }
    }

    /// Returns a cap's lambda, or `None` if the ray misses the cap. The rule is that of [`crate::geometry::cap`].
    fn cap(&self, is_bottom: bool) -> ExactResult<ExactLambda> {
        let Self { direction, from_center, file_axis, radius_squared, half, slope, lambda_min, .. } = self;
        let parallel = &to_dyadic(PARALLEL)?.squared() * &half.times_power_of_two(1);
        if (&slope.squared() - &parallel).sign() == Ordering::Less {
            return Ok(None);
        }
        let (numerator, denominator) = self.plane(is_bottom);
        if (&numerator - &(lambda_min * &denominator)).sign() == Ordering::Less {
            return Ok(None);
        }
        // `point` is the vector from the cap's centre to the ray's point, times the denominator.
        let to_cap = file_axis.times(&to_dyadic(if is_bottom { -0.5 } else { 0.5 })?);
        let point = from_center.minus(&to_cap).times(&denominator).plus(&direction.times(&numerator));
        let outside = &point.dot(&point) - &(radius_squared * &denominator.squared());
        Ok((outside.sign() != Ordering::Greater).then(|| ExactLambda::fraction(numerator, denominator)))
    }
}

/// Returns lambda and name of the closest part, or `None` if no part is hit. The parts come in the order side, top,
/// bottom. Of parts at the same lambda the first counts, because a cap does not replace what is at the same lambda
/// ([`crate::geometry::tie`]).
fn closest_part(parts: [Option<ExactLambda>; 3]) -> Option<(ExactLambda, CylinderPart)> {
    let names = [CylinderPart::Side, CylinderPart::Top, CylinderPart::Bottom];
    // Of equal elements, `min_by` returns the first.
    let hits = parts.into_iter().zip(names).filter_map(|(lambda, part)| Some((lambda?, part)));
    hits.min_by(|(left, _), (right, _)| left.compare(right))
}

/// Returns the exact lambda of the ray's hit with a part of the cylinder, which it must hit. The other parameters and
/// the error are those of [`closest_exactly`].
pub(crate) fn exact_lambda(
    record: &CylinderRecord,
    file_axis: Vec3,
    ray: &Ray,
    part: CylinderPart,
) -> ExactResult<ExactLambda> {
    let terms = ExactTerms::new(record, file_axis, ray)?;
    if part == CylinderPart::Side {
        return Ok(terms.side());
    }
    let (numerator, denominator) = terms.plane(part == CylinderPart::Bottom);
    Ok(Some(ExactLambda::fraction(numerator, denominator)))
}

#[cfg(test)]
mod tests;
