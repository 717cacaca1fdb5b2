//! Exact intersection of ray and closed cylinder. [`crate::geometry::cylinder`] has the plain formulas.
//!
//! The quadratic has an error bound. Two decisions have margins: whether a point of the side is between the caps, and
//! whether a point of a cap's plane is on the disc. Each margin covers the error of lambda, converted to a length, and
//! the rounding of the points. Two other decisions have bounds of their own: whether a cap's plane is parallel to the
//! ray, and whether it is too near. No lambdas of two parts are compared, because their order follows from the shape
//! (`exact/cylinder_decision.rs`).
//!
//! [`filtered`] serves one ray. [`SideLanes`] intersects several rays or cylinders at once, without a branch.

use crate::counters::{Counter, add};
use crate::exact::cylinder_compensated::{CompensatedCaps, CompensatedSide};
use crate::exact::cylinder_decision::{Hit, decide, with_caps};
use crate::exact::cylinder_filter::{
    CapFormulas, Crossing, PlainCaps, PlainSide, SideFacts, SideFormulas, is_inside, is_long,
};
use crate::exact::{cylinder_exact, error_bound::Decision, error_bound::in_scale, exact_vector::NotFinite};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};
use crate::simd::{SimdF64, fused::run_fused};

/// Returns lambda and part of the ray's closest hit with the side, the top cap or the bottom cap, or `None` if the ray
/// misses all three. Of parts at the same lambda, the first in this order counts. [`CylinderRecord::intersect`] follows
/// this rule with rounding errors, but here rounding never changes a decision. `axis` is the axis of the scene file,
/// and its length is the cylinder's height. `record` must be made from this axis, and the length must be finite.
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
pub fn intersect(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    debug_assert!(is_made_from(record, *axis));
    match filtered(record, ray) {
        Decision::Certain(hit) => hit,
        Decision::Uncertain => compensated_or_precise(record, axis, ray),
    }
}

/// Whether the record is that of a cylinder with this axis, or the axis has no direction in `f64`.
fn is_made_from(record: &CylinderRecord, axis: Vec3) -> bool {
    let (unit, height) = axis.unit_and_length();
    (unit, height / 2.0) == (record.axis, record.half_height) || !unit.is_finite()
}

/// Computes the plain formulas in the arithmetic `T`. Returns `Certain(Some((lambda, part)))` for a hit,
/// `Certain(None)` for a miss, and `Uncertain` if rounding may have changed a decision.
#[inline(always)]
pub fn filtered<T: Rounding<Mask = bool>>(record: &CylinderRecord<T>, ray: &Ray<T>) -> Decision<Hit<T>> {
    decide(record, ray, &PlainSide::new(record, &record.seen_from(ray.origin), ray, is_long(record)), &PlainCaps)
}

/// Intersects a ray for which [`filtered`] is uncertain. The [compensated](crate::exact::cylinder_compensated) formulas
/// are tried first. If they are uncertain too, [`precise`] gives the result. `axis` is the axis of the scene file.
#[cold]
#[inline(never)]
pub fn compensated_or_precise(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    match compensated(record, axis, ray) {
        Decision::Certain(hit) => {
            add(Counter::Compensated, 1);
            hit
        }
        Decision::Uncertain => precise(record, axis, ray),
    }
}

/// Returns the hit by the [compensated](crate::exact::cylinder_compensated) formulas, if rounding certainly has not
/// changed it.
pub fn compensated(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Decision<Hit<f64>> {
    run_fused!(|record: &CylinderRecord, axis: &Vec3, ray: &Ray| -> Decision<Hit<f64>> {
        let caps = CompensatedCaps(*axis);
        // If a cylinder is not long, most uncertain rays from inside are uncertain only because of a cap.
        if !is_long(record) && is_inside(&record.seen_from(ray.origin)) && in_scale(ray.direction.dot(ray.direction)) {
            let decision = with_caps(record, ray, &caps, Decision::Uncertain);
            if decision != Decision::Uncertain {
                return decision;
            }
        }
        decide(record, ray, &CompensatedSide::new(record, *axis, ray), &caps)
    })
}

/// Intersects a ray by dyadic arithmetic. This takes some thousand operations, and few rays need it. `axis` is the axis
/// of the scene file.
#[cold]
#[inline(never)]
pub fn precise(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    add(Counter::Fallbacks, 1);
    cylinder_exact::intersect(record, *axis, ray).unwrap_or_else(|NotFinite| record.intersect(ray))
}

/// The hits of several rays or cylinders at once, one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct CylinderHits<T: Real> {
    /// The lambda of the hit, or infinity if the ray misses the cylinder. It has no meaning in a lane that is not
    /// `certain`.
    pub lambda: T,
    /// The lanes whose hit is on the top cap, if there is a hit.
    pub top: T::Mask,
    /// The lanes whose hit is on the bottom cap, if there is a hit.
    pub bottom: T::Mask,
    /// The lanes whose result is certain. The other lanes need the next step: the compensated formulas, or after them
    /// [`precise`].
    pub certain: T::Mask,
}

/// The hits of several rays or cylinders as far as the side alone decides them. Most rays need no test of the caps.
pub struct SideLanes<T: Real> {
    entry: Crossing<T>,
    exit: Crossing<T>,
    /// The lanes whose ray certainly misses the cylinder.
    nothing: T::Mask,
    /// The lanes whose ray certainly starts between the caps' planes and hits the side from inside.
    through: T::Mask,
    /// The lanes whose ray certainly starts inside the infinite cylinder.
    inside: T::Mask,
    /// The lanes that the side alone does not decide.
    pub open: T::Mask,
}

impl<V: SimdF64> CylinderHits<V> {
    /// Returns the number of the part of each hit.
    #[inline(always)]
    pub(crate) fn part(&self) -> V {
        let over = V::select(self.top, CylinderPart::Top.number(), CylinderPart::Side.number());
        V::select(self.bottom, CylinderPart::Bottom.number(), over)
    }
}

impl<V: SimdF64> SideLanes<V> {
    /// Returns the hits of all lanes. The caps are tested only if a lane in `bits` is [open](Self::open), because for
    /// most groups of rays the side alone decides. So an open lane that is not in `bits` may stay uncertain.
    #[inline(always)]
    pub(crate) fn with_needed_caps(
        &self,
        record: &CylinderRecord<V>,
        ray: &Ray<V>,
        caps: &impl CapFormulas<V>,
        bits: u32,
    ) -> CylinderHits<V> {
        if V::bits(self.open) & bits != 0 { self.with_caps(record, ray, caps) } else { self.without_caps() }
    }
}

impl<T: Rounding> SideLanes<T> {
    /// Intersects the rays with the side, by its plain or its compensated formulas.
    #[inline(always)]
    pub fn new(side: &impl SideFormulas<T>) -> Self {
        let (entry, exit) = (side.crossing(false), side.crossing(true));
        let SideFacts { misses, inside, .. } = side.facts();
        let nothing = misses | (entry.fails() & entry.passes_by(&exit));
        let through = entry.behind & exit.straight & !nothing;
        Self { entry, exit, nothing, through, inside, open: !(nothing | entry.hits | through) }
    }

    /// The lanes in which it certainly is decided where the ray crosses the side. Caps may still be open.
    #[inline(always)]
    fn is_certain(&self) -> T::Mask {
        !self.open | (self.entry.fails() & (self.exit.hits | self.exit.fails()))
    }

    /// Returns the hits by the side alone. Lanes that are [open](Self::open) are not `certain`.
    #[inline(always)]
    pub(crate) fn without_caps(&self) -> CylinderHits<T> {
        let none = T::empty_mask();
        let lambda = T::select(self.through, self.exit.lambda, self.entry.lambda);
        CylinderHits {
            lambda: T::select(self.nothing, T::of(f64::INFINITY), lambda),
            top: none,
            bottom: none,
            certain: self.nothing | self.entry.hits | self.through,
        }
    }

    /// Intersects the rays with the caps too, and returns the hits.
    #[inline(always)]
    pub fn with_caps(&self, record: &CylinderRecord<T>, ray: &Ray<T>, caps: &impl CapFormulas<T>) -> CylinderHits<T> {
        let Self { entry, exit, nothing, through, inside, open } = *self;
        let down = ray.direction.dot(record.axis).less(T::of(0.0));
        let (near, far) =
            (Vec3::select(down, record.top, record.bottom), Vec3::select(down, record.bottom, record.top));
        let facing = caps.plane(record, ray, near, down).disc(record, ray);
        let other = caps.plane(record, ray, far, !down).disc(record, ray);
        let by_facing = open & facing.hits;
        let by_exit = through | (open & !facing.hits & exit.hits);
        let by_other = open & !facing.hits & !exit.hits & other.hits;
        let mut lambda = T::select(by_other, other.lambda, T::of(f64::INFINITY));
        lambda = T::select(by_exit, exit.lambda, lambda);
        lambda = T::select(by_facing, facing.lambda, lambda);
        lambda = T::select(entry.hits & !nothing, entry.lambda, lambda);
        let side_is_certain = self.is_certain();
        let by_cap = facing.hits | (facing.fails & other.hits);
        let by_side = facing.fails & (exit.hits | other.fails);
        CylinderHits {
            lambda,
            top: (by_facing & down) | (by_other & !down),
            bottom: (by_facing & !down) | (by_other & down),
            certain: !open | (by_cap & (side_is_certain | inside)) | (by_side & side_is_certain),
        }
    }
}

#[cfg(test)]
mod tests;
