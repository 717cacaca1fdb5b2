//! Ray against sphere, certified; see [`crate::sphere`] for the formulas and [`super::certificate`] for the bounds.

use super::certificate::{Certificate, Limits, Rounding, Verdict, in_scale};
use super::double_double::DoubleDouble;
use super::sphere_compensated::{self, Beside};
use super::sphere_exact;
use crate::counters::{Counter, add};
use crate::ray::Ray;
use crate::real::Real;
use crate::simd::{InstructionSet, Kernel, Simd};
use crate::sphere::{SphereRecord, SphereView};
use crate::vec3::Vec3;

/// Counted in `docs/accuracy.md`: the noise is at most 26. With this condition lambdas are right to 5.9e-12 (a
/// search reached 2.7e-12) and 99.6 % of an ordinary picture's keep the textbook's bits.
pub const LIMITS: Limits = Limits { noise: 32.0, condition: 12288.0 };

/// Where the ray meets the sphere: the contract of [`SphereRecord::intersect`], and right.
///
/// ```
/// use cpu::{Ray, Vec3, certified, sphere::SphereRecord};
///
/// // A grain of sand, 10 km away, touched at its rim; the textbook's discriminant is rounding noise there.
/// let sand = SphereRecord::new(Vec3::new(1e-4, 0.0, 1e4), 1e-4);
/// let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(0.0, 0.0, 1.0) };
/// assert_eq!(certified::sphere::intersect(&sand, &ray), Some(1e4));
/// ```
#[inline(always)]
#[must_use]
pub fn intersect(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    match judge(record, ray) {
        Verdict::Certain(answer) => answer,
        Verdict::Doubtful => reconsider(record, ray),
    }
}

/// What the textbook says in the arithmetic `T`, unless rounding may have changed it.
#[inline(always)]
#[must_use]
pub fn judge<T: Rounding<Mask = bool>>(record: &SphereRecord<T>, ray: &Ray<T>) -> Verdict<Option<T>> {
    let a = ray.direction.dot(ray.direction);
    let (h, discriminant) = record.quadratic(ray, a);
    let certificate = certificate(record, ray, a);
    if !in_scale(a) {
        return Verdict::Doubtful;
    }
    if certificate.misses(discriminant) {
        return Verdict::Certain(None);
    }
    let root = discriminant.sqrt();
    let near_fails = certificate.is_too_small(a, h - root, root);
    if !near_fails {
        let near = certificate.root(a, h - root, root);
        if near.hits {
            return Verdict::Certain(Some(near.lambda));
        }
    }
    let far = certificate.root(a, h + root, root);
    match (near_fails && far.hits, far.fails) {
        (true, _) => Verdict::Certain(Some(far.lambda)),
        // The larger root too near: the smaller too.
        (_, true) => Verdict::Certain(None),
        _ => Verdict::Doubtful,
    }
}

/// [`judge`], and where that is in doubt [`sphere_compensated::judge`]: what [`reconsider`] tries first, but asked the other
/// way round, for most rays near a large sphere are in doubt.
#[inline(always)]
#[must_use]
pub fn judge_large(record: &SphereRecord, ray: &Ray) -> Verdict<Option<f64>> {
    let Beside { lanes, textbook_doubts } = sphere_compensated::judge_beside(record, ray);
    if !(lanes.certain && textbook_doubts) {
        let textbook = judge(record, ray);
        if textbook != Verdict::Doubtful || !lanes.certain {
            return textbook;
        }
    }
    add(Counter::Compensated, 1);
    Verdict::Certain(Some(lanes.lambda))
}

/// The answers of several rays or spheres at once.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<T: Real> {
    /// What the textbook says; infinite where it finds no hit. Of no meaning in a lane that is not certain.
    pub lambda: T,
    /// Lanes whose answer is right. The others are for [`reconsider`].
    pub certain: T::Mask,
}

/// [`judge`] without a branch, for several lanes at once: the same bits in every lane. `a` is the direction's length
/// squared; that it is [in scale](in_scale) the caller sees to, once a ray.
#[inline(always)]
#[must_use]
pub fn judge_lanes<T: Rounding>(record: &SphereRecord<T>, ray: &Ray<T>, a: T) -> Lanes<T> {
    judge_seen(&record.seen_from(ray.origin), ray.direction, a)
}

/// The same for a sphere as it is seen from where the rays begin.
#[inline(always)]
#[must_use]
pub fn judge_seen<T: Rounding>(view: &SphereView<T>, direction: Vec3<T>, a: T) -> Lanes<T> {
    let (h, discriminant) = view.quadratic(direction, a);
    let certificate = Certificate::new(LIMITS, a, view.squares);
    let root = discriminant.sqrt();
    let (near, far) = (certificate.root(a, h - root, root), certificate.root(a, h + root, root));
    let misses = certificate.misses(discriminant) | far.fails;
    let lambda = T::select(near.hits, near.lambda, far.lambda);
    Lanes {
        lambda: T::select(misses, T::of(f64::INFINITY), lambda),
        certain: misses | near.hits | (near.fails & far.hits),
    }
}

#[inline(always)]
fn certificate<T: Rounding>(record: &SphereRecord<T>, ray: &Ray<T>, a: T) -> Certificate<T> {
    // The compiler finds this product again in the quadratic.
    let r_c = record.center - ray.origin;
    Certificate::new(LIMITS, a, r_c.dot(r_c) + record.radius_squared)
}

/// The answer of a ray that is in doubt.
#[cold]
#[inline(never)]
#[must_use]
pub fn reconsider(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    let lanes = InstructionSet::fused().run(Compensated { record, ray });
    if lanes.certain {
        add(Counter::Compensated, 1);
        return Some(lanes.lambda);
    }
    resolve(record, ray)
}

/// The answer in double-double or exact arithmetic, at the price of some hundred operations.
#[cold]
#[inline(never)]
#[must_use]
pub fn resolve(record: &SphereRecord, ray: &Ray) -> Option<f64> {
    add(Counter::Fallbacks, 1);
    match InstructionSet::fused().run(Precisely { record, ray }) {
        Verdict::Certain(answer) => answer.map(|lambda| lambda.high),
        Verdict::Doubtful => sphere_exact::intersect(record, ray).unwrap_or_else(|_| record.intersect(ray)),
    }
}

/// [`sphere_compensated::judge`].
struct Compensated<'a> {
    record: &'a SphereRecord,
    ray: &'a Ray,
}

impl Kernel for Compensated<'_> {
    type Output = Lanes<f64>;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> Lanes<f64> {
        sphere_compensated::judge(self.record, self.ray)
    }
}

/// [`judge`] in double-double arithmetic.
struct Precisely<'a> {
    record: &'a SphereRecord,
    ray: &'a Ray,
}

impl Kernel for Precisely<'_> {
    type Output = Verdict<Option<DoubleDouble>>;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> Self::Output {
        let Self { record, ray } = self;
        let record = SphereRecord::new(widened(record.center), DoubleDouble::of(record.radius));
        judge(&record, &Ray { origin: widened(ray.origin), direction: widened(ray.direction) })
    }
}

/// The same vector with room for more digits.
#[inline(always)]
pub(super) fn widened(vector: Vec3) -> Vec3<DoubleDouble> {
    Vec3::new(DoubleDouble::of(vector.x), DoubleDouble::of(vector.y), DoubleDouble::of(vector.z))
}

#[cfg(test)]
mod tests;
