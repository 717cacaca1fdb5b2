//! The side of a cylinder and the planes of its bases, each with its error bound; [`crate::exact::cylinder`] puts them
//! together.

use crate::exact::error_bound::{ErrorBound, Limits, Outcome};
use crate::geometry::cylinder::{CylinderRecord, CylinderView, PARALLEL};
use crate::geometry::ray::{LAMBDA_MIN, Ray};
use crate::math::real::Real;
use crate::math::rounding::Rounding;
use crate::math::vec3::Vec3;

/// Counted in `docs/accuracy.md`: the noise is at most 132. With this condition lambdas are right to 1.6e-10 on the
/// side and 6.2e-10 on a base (measured: 1.4e-11).
pub const LIMITS: Limits = Limits { noise: 192.0, condition: 65536.0 };

/// The endless cylinder's quadratic, and its error bound.
pub(super) struct Side<T> {
    pub bound: ErrorBound<T>,
    pub length_squared: T,
    a: T,
    pub h: T,
    /// A line that misses the endless cylinder meets no base either.
    pub discriminant: T,
    /// How far the ray's origin is along the axis from the plane halfway between the bases.
    along: T,
    /// By how much a point of the ray advances along the axis when lambda grows by one.
    slope: T,
}

/// Where a line crosses the endless cylinder: what is certain of it. Where none holds it is in doubt.
#[derive(Clone, Copy)]
pub(super) struct Crossing<T: Real> {
    pub lambda: T,
    /// Between the bases, and it counts.
    pub hits: T::Mask,
    /// So is the whole way there from the ray's origin, which so crosses no base's plane.
    pub straight: T::Mask,
    /// At a lambda too small.
    pub behind: T::Mask,
    /// Beyond the upper base.
    above: T::Mask,
    /// Beyond the lower base.
    below: T::Mask,
}

impl<T: Real> Crossing<T> {
    /// The side is certainly not hit there.
    #[inline(always)]
    pub fn fails(&self) -> T::Mask {
        self.behind | self.above | self.below
    }

    /// Whether a line that enters the endless cylinder here and leaves it at `exit` certainly meets no part of the
    /// cylinder: it has left already, or is beyond one base all the way.
    #[inline(always)]
    pub fn passes_by(&self, exit: &Self) -> T::Mask {
        exit.behind | (self.above & exit.above) | (self.below & exit.below)
    }
}

impl<T: Rounding> Side<T> {
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, view: &CylinderView<T>, direction: Vec3<T>) -> Self {
        let length_squared = direction.dot(direction);
        let (a, h, discriminant) = record.quadratic(view, direction);
        let bound = ErrorBound::new(LIMITS, length_squared, view.squares);
        let slope = direction.dot(record.axis);
        Self { bound, length_squared, a, h, discriminant, along: view.along, slope }
    }

    /// Nearly along the axis `a` itself cancels: beyond this limit its error exceeds that of an accepted lambda.
    #[inline(always)]
    fn is_steep_enough(&self) -> T::Mask {
        let condition = LIMITS.condition::<T>();
        self.length_squared.less_equal(self.a * T::of(64.0 * condition * condition))
    }

    /// Whether the line certainly crosses the endless cylinder there at a lambda too small.
    #[inline(always)]
    pub fn is_behind(&self, numerator: T, root: T) -> T::Mask {
        self.is_steep_enough() & self.bound.is_too_small(self.a, numerator, root)
    }

    /// Whether the side is hit where the line crosses the endless cylinder.
    #[inline(always)]
    pub fn crossing(&self, record: &CylinderRecord<T>, ray: &Ray<T>, numerator: T, root: T) -> Crossing<T> {
        let steep_enough = self.is_steep_enough();
        let crossing = self.bound.root(self.a, numerator, root);
        // Not by the point itself, as in the plain formula: the margin covers the difference.
        let along = self.along + crossing.lambda * self.slope;
        let margin = margin(record, ray, crossing.lambda);
        let accurate = steep_enough & crossing.hits;
        let (within, beyond) = (record.half_height - margin, record.half_height + margin);
        let hits = accurate & along.abs().less(within);
        Crossing {
            lambda: crossing.lambda,
            hits,
            straight: hits & self.along.abs().less(within),
            behind: steep_enough & crossing.fails,
            above: accurate & beyond.less(along),
            below: accurate & beyond.less(-along),
        }
    }
}

/// A base's plane, and what is certain before its hit is computed.
pub(super) struct Plane<T: Real> {
    center: Vec3<T>,
    /// From the ray's origin to the plane along the axis.
    to_plane: T,
    /// The plane is certainly not hit: it is parallel to the ray, behind it, or too near.
    pub fails: T::Mask,
    /// The ray is certainly not parallel to it.
    steep: T::Mask,
    /// Lambda can be computed to the accuracy asked for.
    accurate: T::Mask,
}

impl<T: Rounding> Plane<T> {
    /// The plane of the base around `center`.
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>) -> Self {
        let condition = LIMITS.condition::<T>();
        let to_center = center - ray.origin;
        let (to_plane, slope) = (to_center.dot(record.axis), ray.direction.dot(record.axis));
        let (steepness, reach) = (slope.abs(), magnitude(ray.direction));
        let slope_error = reach * T::of(8.0 * T::UNIT_ROUNDOFF);
        let parallel = (steepness + slope_error).less(T::of(PARALLEL));
        let steep = (T::of(PARALLEL) + slope_error).less(steepness);
        // Positive in front of the ray.
        let distance = to_plane.flipped_by(slope);
        let size = extent(record) + magnitude(to_center);
        let distance_error = size * T::of(16.0 * T::UNIT_ROUNDOFF);
        let too_near = (distance + distance_error).less((steepness - slope_error) * T::of(LAMBDA_MIN));
        let accurate = size.less(distance * T::of(4.0 * condition)) & reach.less(steepness * T::of(8.0 * condition));
        Self { center, to_plane, fails: parallel | (steep & too_near), steep, accurate }
    }

    /// Whether the disc is hit.
    #[inline(always)]
    pub fn disc(&self, record: &CylinderRecord<T>, ray: &Ray<T>) -> Outcome<T> {
        let (lambda, _) = record.plane(ray, self.to_plane);
        let in_range = self.accurate & LIMITS.in_range(lambda);
        let from_center = (ray.at(lambda) - self.center).length();
        let margin = margin(record, ray, lambda);
        let (within, beyond) = (from_center.less(record.radius - margin), (record.radius + margin).less(from_center));
        Outcome { lambda, hits: self.steep & in_range & within, fails: self.fails | (self.steep & in_range & beyond) }
    }
}

/// The size of a cylinder's coordinates, and of itself. The same for all rays.
#[inline(always)]
#[must_use]
fn extent<T: Real>(record: &CylinderRecord<T>) -> T {
    // Underflow in lengths, of which this is the measure, is far below 2^-300.
    const UNDERFLOW: f64 = f64::from_bits((1023 - 300) << 52);
    magnitude(record.center) + record.radius + record.half_height + T::of(UNDERFLOW)
}

/// How far rounding may have moved the point at an accepted lambda.
#[inline(always)]
fn margin<T: Rounding>(record: &CylinderRecord<T>, ray: &Ray<T>, lambda: T) -> T {
    let along = lambda * magnitude(ray.direction) * T::of(2.0 * LIMITS.lambda_error::<T>());
    along + extent(record) * T::of(64.0 * T::UNIT_ROUNDOFF)
}

/// A number not smaller than the vector's length, and at most 1.74 times as large.
#[inline(always)]
fn magnitude<T: Real>(vector: Vec3<T>) -> T {
    vector.x.abs() + vector.y.abs() + vector.z.abs()
}
