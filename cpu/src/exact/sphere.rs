//! Ray against sphere, certified; one step after the other: the plain formula where its
//! [bound](crate::exact::sphere_filter) allows, the [compensated](sphere_compensated) one, double-double, exact
//! arithmetic.

use crate::counters::{Counter, add};
use crate::exact::double_double::DoubleDouble;
use crate::exact::error_bound::Decision;
use crate::exact::sphere_compensated;
use crate::exact::sphere_exact;
pub use crate::exact::sphere_filter::{SphereHits, filtered, filtered_from};
use crate::geometry::ray::Ray;
use crate::geometry::sphere::SphereRecord;
use crate::math::real::Real;
use crate::simd::instruction_set::InstructionSet;
use crate::simd::{Kernel, Simd};

/// Where the ray meets the sphere: the contract of [`SphereRecord::intersect`], and right.
///
/// ```
/// use cpu::intersect::{self, SphereRecord};
/// use cpu::{Ray, Vec3};
///
/// // A grain of sand, 10 km away, touched at its rim; the textbook's discriminant is rounding noise there.
/// let sand = SphereRecord::new(Vec3::new(1e-4, 0.0, 1e4), 1e-4);
/// let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(0.0, 0.0, 1.0) };
/// assert_eq!(intersect::sphere(&sand, &ray), Some(1e4));
/// ```
#[inline(always)]
#[must_use]
pub fn intersect(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    match filtered(record, ray) {
        Decision::Certain(answer) => answer,
        Decision::Uncertain => compensated_or_precise(record, ray),
    }
}

/// [`filtered`], and where that is in doubt [`sphere_compensated::compensated`], without the call that
/// [`compensated_or_precise`] is: for a large sphere, near which most rays are in doubt.
#[inline(always)]
#[must_use]
pub fn filtered_or_compensated(record: &SphereRecord, ray: &Ray) -> Decision<Option<f64>> {
    let decision = filtered(record, ray);
    if decision != Decision::Uncertain {
        return decision;
    }
    let lanes = sphere_compensated::compensated(record, ray);
    if !lanes.certain {
        return Decision::Uncertain;
    }
    add(Counter::Compensated, 1);
    Decision::Certain(Some(lanes.lambda))
}

/// The answer of a ray that is in doubt.
#[cold]
#[inline(never)]
#[must_use]
pub fn compensated_or_precise(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    let lanes = InstructionSet::fused().run(Compensated { record, ray });
    if lanes.certain {
        add(Counter::Compensated, 1);
        return Some(lanes.lambda);
    }
    precise(record, ray)
}

/// The answer in double-double or exact arithmetic, at the price of some hundred operations.
#[cold]
#[inline(never)]
#[must_use]
pub fn precise(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    add(Counter::Fallbacks, 1);
    match InstructionSet::fused().run(Precisely { record, ray }) {
        Decision::Certain(answer) => answer.map(|lambda| lambda.high),
        Decision::Uncertain => sphere_exact::intersect(record, ray).unwrap_or_else(|_| record.intersect(ray)),
    }
}

/// [`sphere_compensated::compensated`].
struct Compensated<'a> {
    record: &'a SphereRecord,
    ray: &'a Ray,
}

impl Kernel for Compensated<'_> {
    type Output = SphereHits<f64>;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> SphereHits<f64> {
        sphere_compensated::compensated(self.record, self.ray)
    }
}

/// [`filtered`] in double-double arithmetic.
struct Precisely<'a> {
    record: &'a SphereRecord,
    ray: &'a Ray,
}

impl Kernel for Precisely<'_> {
    type Output = Decision<Option<DoubleDouble>>;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> Self::Output {
        let Self { record, ray } = self;
        let of = DoubleDouble::of;
        filtered(&SphereRecord::new(record.center.map(of), of(record.radius)), &ray.lanes())
    }
}

#[cfg(test)]
mod tests;
