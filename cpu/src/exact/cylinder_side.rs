//! Intersects a ray with the side of a cylinder, with an error bound. This module also has the margins that side and
//! [caps](crate::exact::cap) use. [`crate::exact::cylinder`] combines side and caps.

use crate::exact::error_bound::{ErrorBound, Limits};
use crate::geometry::{cylinder::CylinderRecord, cylinder::CylinderView, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The constants of the error bound for cylinders. The error constant is 192: `docs/accuracy.md` derives that 132 is
/// enough, and the rest is a margin. The condition limit, 65,536, decides the accuracy. With it, the relative error of
/// lambda is proven to be at most 1.6e-10 on the side and 6.2e-10 on a cap. The largest error that `stress` finds is
/// 2.0e-11 (docs/accuracy).
pub const LIMITS: Limits = Limits { error_constant: 192.0, condition_limit: 65536.0 };

/// The quadratic of one ray and an infinite cylinder, with its error bound.
pub(super) struct Side<T> {
    pub bound: ErrorBound<T>,
    pub length_squared: T,
    a: T,
    pub h: T,
    /// A quarter of the quadratic's discriminant. If it is negative, the ray's line misses the infinite cylinder, and
    /// so it misses the caps too.
    pub discriminant: T,
    /// The distance of the ray's origin, along the axis, from the plane halfway between the caps. It is positive on the
    /// side of the top cap.
    along: T,
    /// The distance, along the axis, that the ray's point moves if lambda grows by one.
    slope: T,
}

/// What is certain about a point where the ray's line crosses the infinite cylinder. If no mask holds, nothing is
/// certain.
#[derive(Clone, Copy)]
pub(super) struct Crossing<T: Real> {
    pub lambda: T,
    /// The point certainly is between the caps' planes, and lambda certainly is in range.
    pub hits: T::Mask,
    /// `hits` holds, and the ray's origin certainly is between the caps' planes too. So the ray crosses no cap's plane
    /// before the point.
    pub straight: T::Mask,
    /// Lambda certainly is below the smallest lambda in range.
    pub behind: T::Mask,
    /// The point certainly is beyond the plane of the top cap.
    above: T::Mask,
    /// The point certainly is beyond the plane of the bottom cap.
    below: T::Mask,
}

impl<T: Real> Crossing<T> {
    /// Whether the ray certainly does not hit the side at this point.
    #[inline(always)]
    pub fn fails(&self) -> T::Mask {
        self.behind | self.above | self.below
    }

    /// Whether a ray that enters the infinite cylinder at this point and leaves it at `exit` certainly hits no part of
    /// the cylinder. Then it has left before the smallest lambda, or both points are beyond the same cap.
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

    /// Whether the quadratic's coefficient `a` is accurate enough. If a ray is nearly parallel to the axis, the terms
    /// of `a` cancel, and its relative error may exceed that of an accepted lambda.
    #[inline(always)]
    fn is_steep_enough(&self) -> T::Mask {
        let condition = LIMITS.condition_limit::<T>();
        self.length_squared.less_equal(self.a * T::of(64.0 * condition * condition))
    }

    /// Whether the lambda `numerator / a` certainly is below the smallest lambda in range. `root` is the square root of
    /// the discriminant.
    #[inline(always)]
    pub fn is_behind(&self, numerator: T, root: T) -> T::Mask {
        self.is_steep_enough() & self.bound.is_too_small(self.a, numerator, root)
    }

    /// Returns the crossing at the lambda `numerator / a`. `root` is the square root of the discriminant.
    #[inline(always)]
    pub fn crossing(&self, record: &CylinderRecord<T>, ray: &Ray<T>, numerator: T, root: T) -> Crossing<T> {
        let steep_enough = self.is_steep_enough();
        let crossing = self.bound.root(self.a, numerator, root);
        // The plain formula computes the point first, and then its distance along the axis. The margin covers the
        // difference of the two results.
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

/// Returns `|center|_1 + radius + half_height`, an upper bound of the cylinder's coordinates, in scene units. Here
/// `|v|_1` is the sum of the magnitudes of a vector's components. The result is constant for all rays.
#[inline(always)]
pub(super) fn extent<T: Real>(record: &CylinderRecord<T>) -> T {
    // Underflow changes a length by far less than 2^-300.
    const UNDERFLOW: f64 = f64::from_bits((1023 - 300) << 52);
    magnitude(record.center) + record.radius + record.half_height + T::of(UNDERFLOW)
}

/// Returns a bound of the distance, in scene units, by which rounding moves the ray's point at an accepted lambda.
#[inline(always)]
pub(super) fn margin<T: Rounding>(record: &CylinderRecord<T>, ray: &Ray<T>, lambda: T) -> T {
    let along = lambda * magnitude(ray.direction) * T::of(2.0 * LIMITS.lambda_error::<T>());
    along + extent(record) * T::of(64.0 * T::UNIT_ROUNDOFF)
}

/// Returns an upper bound of the vector's length: the sum of its components' magnitudes, which is at most 1.74 times
/// the length.
#[inline(always)]
pub(super) fn magnitude<T: Real>(vector: Vec3<T>) -> T {
    vector.x.abs() + vector.y.abs() + vector.z.abs()
}
