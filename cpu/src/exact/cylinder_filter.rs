//! The two parts of a cylinder, side and cap, each intersected with an error bound. [`crate::exact::cylinder`] combines
//! them, and decides when a cap is tested and which of the two first.
//!
//! A hit on a cap follows the rule of [`crate::geometry::cap`], and the programs decide by this file. There are three
//! results: a ray certainly hits a cap, certainly misses it, or the decision is uncertain. [`Plane`] serves one ray and
//! lanes. [`filtered_cap`] calls it for one ray. If the compensated formulas are uncertain too, `Inputs::cap` of
//! `exact/cylinder_exact.rs` decides without rounding. The reference has a literal copy of the rule in `cap` of
//! `reference/nearest.rs`, and WGSL has one in `cylinder_cap` of `cylinder.wgsl`.

use crate::exact::error_bound::{BoundConstants, Decision, ErrorBound, HEADROOM, Outcome};
use crate::geometry::{
    cap::PARALLEL, cylinder::CylinderPart, cylinder::CylinderRecord, cylinder::CylinderView, ray::LAMBDA_MIN, ray::Ray,
};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The constants of the error bound for cylinders. The error constant is 192. `tests/stability/src/proof/exact.rs`
/// proves that 121 is enough for the discriminant of [`CylinderRecord::quadratic`], and 138 for the numerator of a
/// root. The condition limit, 65,536, decides the accuracy. With it, the relative error of lambda is proven to be at
/// most 1.7e-10 on the side and 6.0e-10 on a cap. docs/accuracy has the largest error that `stress` finds.
pub const CYLINDER_BOUND: BoundConstants = BoundConstants { error_constant: 192.0, condition_limit: 65536.0 };

/// A ray is steep enough for the side of a cylinder if `|d|^2` is at most this multiple of `k^2 |d'|^2`, where `k` is
/// the condition limit and `d'` the part of the direction `d` across the axis.
pub const STEEPNESS: f64 = 4.0;

/// The share of `|d|^2 (|O - C|^2 + r^2)` in the size of the discriminant of a long cylinder, 2^-44. It covers errors
/// of second order, and the error of the size itself if the ray starts farther away along the axis than 2^46 radii.
pub const SHARE_OF_WHOLE: f64 = f64::from_bits((1023 - 44) << 52);
/// Covers underflow in the square of the size of a long cylinder, 2^-350. A size above it has no product below 2^-1022.
pub const LEAST_SIZE: f64 = f64::from_bits((1023 - 350) << 52);

/// Covers underflow in lengths, 2^-300: it is added to each bound of coordinates.
pub const LEAST_EXTENT: f64 = f64::from_bits((1023 - 300) << 52);

/// Whether a cylinder is long: rays may run nearly along its axis from one side to the other.
#[inline(always)]
pub fn is_long<T: Real>(record: &CylinderRecord<T>) -> T::Mask {
    (record.radius * T::of(8.0)).less(record.half_height)
}

/// Whether the rays from `view` certainly start inside the infinite cylinder. The error of `c` is part of that of the
/// discriminant.
#[inline(always)]
pub(crate) fn is_inside<T: Rounding>(view: &CylinderView<T>) -> T::Mask {
    ErrorBound::of_size(CYLINDER_BOUND, view.squares * T::of(HEADROOM)).misses(view.c)
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
    /// Returns the point where the line leaves the infinite cylinder if `leaves` holds, and where it enters otherwise.
    fn crossing(&self, leaves: bool) -> Crossing<T>;
}

/// A way to compute the plane of a cap. It is a trait and no closure; see [`crate::simd::Kernel::call`].
pub trait CapFormulas<T: Rounding> {
    /// Returns the plane of the cap around `center`.
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, is_top: T::Mask) -> Plane<T>;
}

/// What is certain about a point where the ray's line crosses the infinite cylinder. If no mask holds, nothing is
/// certain.
#[derive(Clone, Copy)]
pub struct Crossing<T: Real> {
    pub(super) lambda: T,
    /// Twice the bound of the error of lambda, or more.
    pub(super) error: T,
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
    /// Returns the crossing at `lambda`. `error` is twice the bound of its error, or more. `accurate` and `behind` tell
    /// whether lambda certainly is in range and accurate, or certainly below the smallest lambda. `start` and `slope`
    /// are those of [`PlainSide`].
    #[inline(always)]
    pub(super) fn new(
        record: &CylinderRecord<T>,
        ray: &Ray<T>,
        [start, slope]: [T; 2],
        (lambda, error): (T, T),
        accurate: T::Mask,
        behind: T::Mask,
    ) -> Self {
        // The plain formula computes the point first, and then its distance along the axis. The margin covers the
        // difference of the two results.
        let along = start + lambda * slope;
        let margin = margin(record, ray, error);
        let (within, beyond) = (record.half_height - margin, record.half_height + margin);
        let hits = accurate & along.abs().less(within);
        Self {
            lambda,
            error,
            hits,
            straight: hits & start.abs().less(within),
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

/// Returns the size of the terms that cancel in the discriminant, times [`HEADROOM`]. The size is
/// `|d|^2 (|O - C|^2 + r^2)`. For a [long](is_long) cylinder it is `|d'| S (|d| S + |d'| |O - C|)`, or up to twice as
/// much, with `S^2 = |(O - C)'|^2 + r^2`, where the prime marks the parts across the axis. This is smaller if the ray
/// runs nearly along the axis.
#[inline(always)]
fn size<T: Rounding>(record: &CylinderRecord<T>, view: &CylinderView<T>, a: T, length_squared: T, is_long: bool) -> T {
    let whole = length_squared * (view.squares * T::of(HEADROOM));
    if !is_long {
        return whole;
    }
    let across = view.c + record.radius_squared + record.radius_squared;
    let product = a * (across * (length_squared * across + a * view.squares));
    (product + product).sqrt() * T::of(HEADROOM) + whole * T::of(SHARE_OF_WHOLE) + T::of(LEAST_SIZE * HEADROOM)
}

/// The side by the plain formulas: the quadratic `a lambda^2 + 2 h lambda + c` of a ray and an infinite cylinder, with
/// the bound of its rounding errors.
pub struct PlainSide<'a, T: Real> {
    record: &'a CylinderRecord<T>,
    ray: &'a Ray<T>,
    bound: ErrorBound<T>,
    inside: T::Mask,
    a: T,
    /// Whether the relative error of `a` is smaller than that of an accepted lambda.
    a_is_accurate: T::Mask,
    h: T,
    /// `h^2 - a c`, and its square root.
    discriminant: T,
    root: T,
    /// Two distances along the axis. The first leads from the middle of the cylinder to the ray's origin. The second is
    /// the way of the ray's point if lambda grows by one.
    start_and_slope: [T; 2],
}

impl<'a, T: Rounding> PlainSide<'a, T> {
    /// Computes the quadratic. `view` has the cylinder's terms for the ray's origin.
    #[inline(always)]
    pub fn new(record: &'a CylinderRecord<T>, view: &CylinderView<T>, ray: &'a Ray<T>, is_long: bool) -> Self {
        let length_squared = ray.direction.dot(ray.direction);
        let (a, h, discriminant) = record.quadratic(view, ray.direction);
        let bound = ErrorBound::of_size(CYLINDER_BOUND, size(record, view, a, length_squared, is_long));
        let inside = is_inside(view);
        let start_and_slope = [view.along, ray.direction.dot(record.axis)];
        // If a ray is nearly parallel to the axis, the terms of `a` cancel.
        let condition = CYLINDER_BOUND.condition_limit;
        let a_is_accurate = length_squared.less_equal(a * T::of(STEEPNESS * condition * condition));
        let root = discriminant.sqrt();
        Self { record, ray, bound, inside, a, a_is_accurate, h, discriminant, root, start_and_slope }
    }
}

impl<T: Rounding> SideFormulas<T> for PlainSide<'_, T> {
    #[inline(always)]
    fn facts(&self) -> SideFacts<T> {
        let &Self { inside, a_is_accurate, discriminant, .. } = self;
        SideFacts { misses: self.bound.misses(discriminant), is_accurate: a_is_accurate, inside }
    }

    #[inline(always)]
    fn enters_behind(&self) -> bool
    where
        T: Rounding<Mask = bool>,
    {
        self.a_is_accurate & self.bound.is_too_small(self.a, -self.h - self.root, self.root)
    }

    #[inline(always)]
    fn crossing(&self, leaves: bool) -> Crossing<T> {
        let &Self { record, ray, a, h, root, .. } = self;
        let numerator = if leaves { -h + root } else { -h - root };
        let Outcome { lambda, hits, fails } = self.bound.root(a, numerator, root);
        let error = lambda * T::of(2.0 * CYLINDER_BOUND.lambda_error());
        let [accurate, behind] = [hits, fails].map(|mask| self.a_is_accurate & mask);
        Crossing::new(record, ray, self.start_and_slope, (lambda, error), accurate, behind)
    }
}

/// Returns `|center|_1 + half_height`, an upper bound of the coordinates of points on the axis, in scene units. Here
/// `|v|_1` is the sum of the magnitudes of a vector's components. The result is constant for all rays.
#[inline(always)]
fn extent_of_axis<T: Real>(record: &CylinderRecord<T>) -> T {
    magnitude(record.center) + record.half_height + T::of(LEAST_EXTENT)
}

/// Returns a bound of the distance, in scene units, by which rounding moves the ray's point. `error` is twice the bound
/// of the error of lambda, or more.
#[inline(always)]
pub(super) fn margin<T: Rounding>(record: &CylinderRecord<T>, ray: &Ray<T>, error: T) -> T {
    error * magnitude(ray.direction) + (extent_of_axis(record) + record.radius) * T::of(64.0 * T::UNIT_ROUNDOFF)
}

/// Returns an upper bound of the vector's length: the sum of its components' magnitudes, which is at most 1.74 times
/// the length.
#[inline(always)]
pub(super) fn magnitude<T: Real>(vector: Vec3<T>) -> T {
    vector.x.abs() + vector.y.abs() + vector.z.abs()
}

/// Intersects the ray with the cap in `plane`. Returns `Certain(Some((lambda, part)))` if the ray certainly hits the
/// cap, and `Certain(None)` if it certainly misses the cap. The result is `Uncertain` if rounding may have changed this
/// decision, or if lambda may be inaccurate. `part` is the name of this cap, top or bottom.
#[inline(always)]
pub(super) fn filtered_cap<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    plane: &Plane<T>,
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

/// The plane of a cap and one ray, with what is certain before lambda is computed.
pub struct Plane<T: Rounding> {
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
    pub(super) steep: T::Mask,
    /// The distance and the slope give a lambda that is accurate enough to be accepted.
    pub accurate: T::Mask,
    /// Twice the bound of the relative error of an accepted lambda, or more.
    pub(super) error: T,
}

impl<T: Rounding> Plane<T> {
    /// Returns the plane of the cap around `center`.
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>) -> Self {
        let to_center = center - ray.origin;
        Self::at(record, ray, center, (to_center.dot(record.axis), Self::size(record, to_center)))
    }

    /// Returns the size of the terms that cancel in the distance of a cap's plane. It does not depend on the radius, so
    /// a wide floor is as certain as a narrow one. `to_center` is the vector from the ray's origin to the cap's centre.
    #[inline(always)]
    pub(super) fn size(record: &CylinderRecord<T>, to_center: Vec3<T>) -> T {
        extent_of_axis(record) + magnitude(to_center)
    }

    /// Returns the plane of the cap around `center`, for its distance from the ray's origin. The error of the distance
    /// must be at most 16 u times `size`.
    #[inline(always)]
    pub(super) fn at(record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, (to_plane, size): (T, T)) -> Self {
        let condition = CYLINDER_BOUND.condition_limit;
        let slope = ray.direction.dot(record.axis);
        let (steepness, size_of_direction) = (slope.abs(), magnitude(ray.direction));
        let slope_error = size_of_direction * T::of(8.0 * T::UNIT_ROUNDOFF);
        let parallel = (steepness + slope_error).less(T::of(PARALLEL));
        let steep = (T::of(PARALLEL) + slope_error).less(steepness);
        // The distance is positive if the plane is in front of the ray.
        let distance = to_plane.flipped_by(slope);
        let distance_error = size * T::of(16.0 * T::UNIT_ROUNDOFF);
        let too_near = (distance + distance_error).less((steepness - slope_error) * T::of(LAMBDA_MIN));
        let accurate =
            size.less(distance * T::of(4.0 * condition)) & size_of_direction.less(steepness * T::of(8.0 * condition));
        let error = T::of(2.0 * CYLINDER_BOUND.lambda_error());
        Self { center, to_plane, slope, fails: parallel | (steep & too_near), steep, accurate, error }
    }

    /// Returns lambda, and whether the ray certainly hits the cap or certainly misses it.
    #[inline(always)]
    pub fn disc(&self, record: &CylinderRecord<T>, ray: &Ray<T>) -> Outcome<T> {
        let lambda = self.to_plane / self.slope;
        let in_range = self.accurate & CYLINDER_BOUND.in_range(lambda);
        let from_center = (ray.at(lambda) - self.center).length();
        let margin = margin(record, ray, lambda * self.error);
        let (within, beyond) = (from_center.less(record.radius - margin), (record.radius + margin).less(from_center));
        Outcome { lambda, hits: self.steep & in_range & within, fails: self.fails | (self.steep & in_range & beyond) }
    }
}

/// Planes by the plain formula.
pub struct PlainCaps;

impl<T: Rounding> CapFormulas<T> for PlainCaps {
    #[inline(always)]
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, _: T::Mask) -> Plane<T> {
        Plane::new(record, ray, center)
    }
}
