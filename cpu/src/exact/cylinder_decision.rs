//! Decides which part of a cylinder a ray hits, from what is certain about the side and the caps. This is the second
//! file of the answer that [`crate::exact::cylinder`] begins. The formulas of the side and of the caps are
//! [plain](crate::exact::cylinder_plain) or [compensated](crate::exact::cylinder_compensated).
//!
//! The cylinder is convex, so the ray's line crosses its surface only where it enters and where it leaves. If the ray
//! enters through the side, no cap is nearer. If it leaves through the side, only the cap that faces the ray can be
//! nearer. The other cap counts only if nothing else is hit. So no lambdas of two parts are compared. For rays that
//! start inside, or go inward from the surface, the exit through the side mostly decides alone.
//!
//! The file goes from the whole to its parts: [`decide`] for one ray, then what it asks of a [`Crossing`] of the side,
//! then what it asks of a [`CapPlane`]. Two decisions have margins: whether a point of the side is between the caps,
//! and whether a point of a cap's plane is on the disc. Each margin covers the error of lambda, converted to a length,
//! and the rounding of the points. Two other decisions have bounds of their own: whether a cap's plane is parallel to
//! the ray, and whether it is too near. Lanes ask the same questions without branches, in `exact/cylinder_lanes.rs`.

use crate::exact::error_bound::{BoundConstants, Decision, ErrorBound, HEADROOM, Outcome, in_scale};
use crate::geometry::{
    cap::PARALLEL, cylinder::CylinderPart, cylinder::CylinderRecord, cylinder::CylinderView, ray::LAMBDA_MIN, ray::Ray,
};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The lambda and the part of a hit, or `None` for a miss.
pub(super) type CylinderHit<T> = Option<(T, CylinderPart)>;

/// Returns the closest hit or a miss, if these formulas of the side and of the caps decide it.
#[inline(always)]
pub(super) fn decide<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    side: &impl SideFormulas<T>,
    caps: &impl CapFormulas<T>,
) -> Decision<CylinderHit<T>> {
    if !in_scale(ray.direction.dot(ray.direction)) {
        return Decision::Uncertain;
    }
    let SideFacts { misses, is_accurate, inside } = side.facts();
    if misses {
        return Decision::Certain(None);
    }
    let leaving = if !is_accurate {
        Decision::Uncertain
    } else if side.enters_behind() {
        let exit = side.crossing(true);
        if exit.straight {
            return Decision::Certain(Some((exit.lambda, CylinderPart::Side)));
        }
        if exit.behind {
            return Decision::Certain(None);
        }
        hit_at(&exit)
    } else {
        let entry = side.crossing(false);
        if entry.hits {
            return Decision::Certain(Some((entry.lambda, CylinderPart::Side)));
        }
        if entry.fails() {
            let exit = side.crossing(true);
            if entry.passes_by(&exit) {
                return Decision::Certain(None);
            }
            hit_at(&exit)
        } else {
            Decision::Uncertain
        }
    };
    // The caps can decide alone if the ray certainly starts inside the infinite cylinder.
    if matches!(leaving, Decision::Uncertain) && !inside {
        return Decision::Uncertain;
    }
    with_caps(record, ray, caps, leaving)
}

/// Returns the hit with the side at this crossing, or a certain miss there.
#[inline(always)]
fn hit_at<T: Rounding<Mask = bool>>(crossing: &Crossing<T>) -> Decision<CylinderHit<T>> {
    match (crossing.hits, crossing.fails()) {
        (false, false) => Decision::Uncertain,
        (hits, _) => Decision::Certain(hits.then_some((crossing.lambda, CylinderPart::Side))),
    }
}

/// Returns the closest hit with a cap or with the side. The ray certainly does not hit the side where its line enters
/// the infinite cylinder. `leaving` is the hit with the side where the line leaves, or a certain miss there. It may be
/// uncertain if the ray certainly starts inside the infinite cylinder. Then only a hit with a cap is certain, as for
/// rays that run nearly along the axis.
#[inline(always)]
pub(super) fn with_caps<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    caps: &impl CapFormulas<T>,
    leaving: Decision<CylinderHit<T>>,
) -> Decision<CylinderHit<T>> {
    // Here `facing_center` is the centre of the cap that faces the ray. A branch that chooses it would be mispredicted,
    // and a selection would become a branch. So it is computed by the formula of `record.top` and `record.bottom`.
    let slope = ray.direction.dot(record.axis);
    let to_other = record.axis * record.half_height.flipped_by(slope);
    let (facing_center, other_center) = (record.center - to_other, record.center + to_other);
    let part = |is_top: bool| if is_top { CylinderPart::Top } else { CylinderPart::Bottom };
    let down = slope.less(T::of(0.0));
    match filtered_cap(record, ray, &caps.plane(record, ray, facing_center, down), part(down)) {
        Decision::Certain(None) => {}
        decision => return decision,
    }
    if let Decision::Certain(Some(_)) = leaving {
        return leaving;
    }
    match filtered_cap(record, ray, &caps.plane(record, ray, other_center, !down), part(!down)) {
        Decision::Certain(None) => leaving,
        decision => decision,
    }
}

/// Intersects the ray with the cap in `plane`. Returns `Certain(Some((lambda, part)))` if the ray certainly hits the
/// cap, and `Certain(None)` if it certainly misses the cap. The result is `Uncertain` if rounding may have changed this
/// decision, or if lambda may be inaccurate. `part` is the name of this cap, top or bottom.
#[inline(always)]
fn filtered_cap<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    plane: &CapPlane<T>,
    part: CylinderPart,
) -> Decision<Option<(T, CylinderPart)>> {
    if plane.fails {
        return Decision::Certain(None);
    }
    let disc = plane.disc(record, ray);
    match (disc.hits, disc.fails) {
        (true, _) => Decision::Certain(Some((disc.lambda, part))),
        (_, true) => Decision::Certain(None),
        _ => Decision::Uncertain,
    }
}

/// What is certain about a ray and an infinite cylinder before a crossing is computed.
#[derive(Clone, Copy)]
pub struct SideFacts<T: Real> {
    /// The ray's line misses the infinite cylinder, and so it misses the caps too.
    pub(super) misses: T::Mask,
    /// The crossings can be accurate. Elsewhere no crossing is certain.
    pub(super) is_accurate: T::Mask,
    /// The ray starts inside the infinite cylinder.
    pub(super) inside: T::Mask,
}

/// A way to compute where a ray crosses an infinite cylinder.
pub trait SideFormulas<T: Rounding> {
    /// Returns what is certain before a crossing is computed.
    fn facts(&self) -> SideFacts<T>;
    /// Whether lambda certainly is below the least lambda where the line enters. This is cheaper than the crossing.
    fn enters_behind(&self) -> bool
    where
        T: Rounding<Mask = bool>;
    /// Returns the point where the line leaves the infinite cylinder if `at_exit` holds, and where it enters otherwise.
    fn crossing(&self, at_exit: bool) -> Crossing<T>;
}

/// A way to compute the plane of a cap. It is a trait and no closure; see [`crate::simd::Kernel::call`].
pub trait CapFormulas<T: Rounding> {
    /// Returns the plane of the cap around `center`.
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, is_top: T::Mask) -> CapPlane<T>;
}

/// Whether the rays from `view` certainly start inside the infinite cylinder. The error of `c` is part of that of the
/// discriminant.
#[inline(always)]
pub(crate) fn is_inside<T: Rounding>(view: &CylinderView<T>) -> T::Mask {
    ErrorBound::of_size(CYLINDER_BOUND, view.squares * T::of(HEADROOM)).misses(view.c)
}

/// What is certain about a point where the ray's line crosses the infinite cylinder. If no mask holds, nothing is
/// certain.
#[derive(Clone, Copy)]
pub struct Crossing<T: Real> {
    pub(super) lambda: T,
    /// Twice the bound of the error of lambda, or more.
    pub(super) error_bound: T,
    /// The point certainly is between the caps' planes, and lambda certainly is in range.
    pub hits: T::Mask,
    /// `hits` holds, and the ray's origin certainly is between the caps' planes too. So the ray crosses no cap's plane
    /// before the point.
    pub straight: T::Mask,
    /// Lambda certainly is below the smallest lambda in range.
    pub behind: T::Mask,
    /// The point certainly is beyond the plane of the top cap.
    pub(super) above: T::Mask,
    /// The point certainly is beyond the plane of the bottom cap.
    pub(super) below: T::Mask,
}

impl<T: Rounding> Crossing<T> {
    /// Returns the crossing at `lambda`. `error_bound` is twice the bound of its error, or more. `accurate` and
    /// `behind` tell whether lambda certainly is in range and accurate, or certainly below the smallest lambda.
    /// `start_along` is the distance along the axis from the middle of the cylinder to the ray's origin. `slope` is how
    /// far the ray's point moves along the axis when lambda grows by one.
    #[inline(always)]
    pub(super) fn new(
        record: &CylinderRecord<T>,
        ray: &Ray<T>,
        [start_along, slope]: [T; 2],
        (lambda, error_bound): (T, T),
        accurate: T::Mask,
        behind: T::Mask,
    ) -> Self {
        // The plain formula computes the point first, and then its distance along the axis. The margin covers the
        // difference of the two results.
        let along = start_along + lambda * slope;
        let margin = margin_of_point(record, ray, error_bound);
        let (within, beyond) = (record.half_height - margin, record.half_height + margin);
        let hits = accurate & along.abs().less(within);
        Self {
            lambda,
            error_bound,
            hits,
            straight: hits & start_along.abs().less(within),
            behind,
            above: accurate & beyond.less(along),
            below: accurate & beyond.less(-along),
        }
    }

    /// Whether the ray certainly does not hit the side at this point.
    #[inline(always)]
    pub(crate) fn fails(&self) -> T::Mask {
        self.behind | self.above | self.below
    }

    /// Whether a ray that enters the infinite cylinder at this point and leaves it at `exit` certainly hits no part of
    /// the cylinder. Then it has left before the smallest lambda, or both points are beyond the same cap.
    #[inline(always)]
    pub(crate) fn passes_by(&self, exit: &Self) -> T::Mask {
        exit.behind | (self.above & exit.above) | (self.below & exit.below)
    }
}

/// The plane of a cap and one ray, with what is certain before lambda is computed.
pub struct CapPlane<T: Rounding> {
    pub(super) center: Vec3<T>,
    /// The distance from the ray's origin to the plane, measured along the axis. It is positive if the plane lies in
    /// the direction of the axis.
    pub to_plane: T,
    /// The dot product of the ray's direction and the axis.
    pub(super) slope: T,
    /// The plane is certainly not hit. It is parallel to the ray, it is behind the ray's origin, or lambda is below
    /// [`LAMBDA_MIN`].
    pub fails: T::Mask,
    /// The ray is certainly not parallel to the plane.
    pub(super) not_parallel: T::Mask,
    /// The distance and the slope give a lambda that is accurate enough to be accepted.
    pub accurate: T::Mask,
    /// Twice the bound of the relative error of an accepted lambda, or more.
    pub(super) error_bound: T,
}

impl<T: Rounding> CapPlane<T> {
    /// Returns the size of the terms that cancel in the distance of a cap's plane. It does not depend on the radius, so
    /// a wide floor is as certain as a narrow one. `to_center` is the vector from the ray's origin to the cap's centre.
    #[inline(always)]
    pub(super) fn size(record: &CylinderRecord<T>, to_center: Vec3<T>) -> T {
        reach_of_axis(record) + magnitude(to_center)
    }

    /// Returns the plane of the cap around `center`, for its distance from the ray's origin. The error of the distance
    /// must be at most 16 u times `size`.
    #[inline(always)]
    pub(super) fn at(record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, (to_plane, size): (T, T)) -> Self {
        let condition = CYLINDER_BOUND.condition_limit;
        let slope = ray.direction.dot(record.axis);
        let (slope_magnitude, size_of_direction) = (slope.abs(), magnitude(ray.direction));
        let slope_error = size_of_direction * T::of(8.0 * T::UNIT_ROUNDOFF);
        let parallel = (slope_magnitude + slope_error).less(T::of(PARALLEL));
        let not_parallel = (T::of(PARALLEL) + slope_error).less(slope_magnitude);
        // The distance is positive if the plane is in front of the ray.
        let distance = to_plane.flipped_by(slope);
        let distance_error = size * T::of(16.0 * T::UNIT_ROUNDOFF);
        let too_near = (distance + distance_error).less((slope_magnitude - slope_error) * T::of(LAMBDA_MIN));
        let accurate = size.less(distance * T::of(4.0 * condition))
            & size_of_direction.less(slope_magnitude * T::of(8.0 * condition));
        let error_bound = T::of(2.0 * CYLINDER_BOUND.lambda_error());
        Self {
            center,
            to_plane,
            slope,
            fails: parallel | (not_parallel & too_near),
            not_parallel,
            accurate,
            error_bound,
        }
    }

    /// Returns lambda, and whether the ray certainly hits the cap or certainly misses it.
    #[inline(always)]
    pub fn disc(&self, record: &CylinderRecord<T>, ray: &Ray<T>) -> Outcome<T> {
        let lambda = self.to_plane / self.slope;
        let in_range = self.accurate & CYLINDER_BOUND.certainly_in_range(lambda);
        let distance_from_center = (ray.at(lambda) - self.center).length();
        let margin = margin_of_point(record, ray, lambda * self.error_bound);
        let (within, beyond) =
            (distance_from_center.less(record.radius - margin), (record.radius + margin).less(distance_from_center));
        Outcome {
            lambda,
            hits: self.not_parallel & in_range & within,
            fails: self.fails | (self.not_parallel & in_range & beyond),
        }
    }
}

/// Returns `|center|_1 + half_height`, an upper bound of the coordinates of points on the axis, in scene units. Here
/// `|v|_1` is the sum of the magnitudes of a vector's components. The result is constant for all rays.
#[inline(always)]
fn reach_of_axis<T: Real>(record: &CylinderRecord<T>) -> T {
    magnitude(record.center) + record.half_height + T::of(LEAST_REACH)
}

/// Returns a bound of the distance, in scene units, by which rounding moves the ray's point. `error_bound` is twice the
/// bound of the error of lambda, or more.
#[inline(always)]
fn margin_of_point<T: Rounding>(record: &CylinderRecord<T>, ray: &Ray<T>, error_bound: T) -> T {
    error_bound * magnitude(ray.direction) + (reach_of_axis(record) + record.radius) * T::of(64.0 * T::UNIT_ROUNDOFF)
}

/// Returns an upper bound of the vector's length: the sum of its components' magnitudes, which is at most 1.74 times
/// the length.
#[inline(always)]
pub(super) fn magnitude<T: Real>(vector: Vec3<T>) -> T {
    vector.x.abs() + vector.y.abs() + vector.z.abs()
}

/// The constants of the error bound for cylinders. The error constant is 192. `tests/stability/src/proof/exact.rs`
/// proves that 121 is enough for the discriminant of [`CylinderRecord::quadratic`], and 138 for the numerator of a
/// root. The condition limit, 65,536, decides the accuracy. With it, the relative error of lambda is proven to be at
/// most 1.7e-10 on the side and 6.0e-10 on a cap. docs/accuracy has the largest error that `stress` finds.
pub const CYLINDER_BOUND: BoundConstants = BoundConstants { error_constant: 192.0, condition_limit: 65536.0 };

/// Covers underflow in lengths, 2^-300: it is added to each bound of coordinates.
pub const LEAST_REACH: f64 = f64::from_bits((1023 - 300) << 52);
