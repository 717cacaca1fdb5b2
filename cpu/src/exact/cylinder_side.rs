//! The side of a cylinder with its error bound, and the margins that side and [caps](crate::exact::cap) share;
//! [`crate::exact::cylinder`] puts them together.

use crate::exact::error_bound::{ErrorBound, Limits};
use crate::geometry::{cylinder::CylinderRecord, cylinder::CylinderView, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// Counted in `docs/accuracy.md`: the error constant is at most 132. With this condition limit lambdas are right to
/// 1.6e-10 on the side and 6.2e-10 on a cap (measured: 1.4e-11).
pub const LIMITS: Limits = Limits { error_constant: 192.0, condition_limit: 65536.0 };

/// The infinite cylinder's quadratic, and its error bound.
pub(super) struct Side<T> {
    pub bound: ErrorBound<T>,
    pub length_squared: T,
    a: T,
    pub h: T,
    /// A line that misses the infinite cylinder hits no cap either.
    pub discriminant: T,
    /// How far the ray's origin is along the axis from the plane halfway between the caps.
    along: T,
    /// By how much a point of the ray advances along the axis when lambda grows by one.
    slope: T,
}

/// What is certain about a point where a line crosses the infinite cylinder. If no mask holds, the crossing is
/// uncertain.
#[derive(Clone, Copy)]
pub(super) struct Crossing<T: Real> {
    pub lambda: T,
    /// The point is between the caps, and lambda is in range.
    pub hits: T::Mask,
    /// `hits` holds, and the ray's origin is between the caps too: the ray crosses no cap's plane before the point.
    pub straight: T::Mask,
    /// Lambda is too small.
    pub behind: T::Mask,
    /// The point is beyond the top cap.
    above: T::Mask,
    /// The point is beyond the bottom cap.
    below: T::Mask,
}

impl<T: Real> Crossing<T> {
    /// Whether the side is certainly not hit there.
    #[inline(always)]
    pub fn fails(&self) -> T::Mask {
        self.behind | self.above | self.below
    }

    /// Whether a ray that enters the infinite cylinder here and leaves it at `exit` certainly hits no part of the
    /// cylinder: it has left already, or is beyond one cap all the way.
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

    /// Whether `a` is accurate enough. For a ray nearly along the axis `a` cancels, and its error exceeds that of an
    /// accepted lambda.
    #[inline(always)]
    fn is_steep_enough(&self) -> T::Mask {
        let condition = LIMITS.condition_limit::<T>();
        self.length_squared.less_equal(self.a * T::of(64.0 * condition * condition))
    }

    /// Whether the root `numerator / a` certainly is too small a lambda.
    #[inline(always)]
    pub fn is_behind(&self, numerator: T, root: T) -> T::Mask {
        self.is_steep_enough() & self.bound.is_too_small(self.a, numerator, root)
    }

    /// The crossing at the root `numerator / a`, where `root` is that of the discriminant.
    #[inline(always)]
    pub fn crossing(&self, record: &CylinderRecord<T>, ray: &Ray<T>, numerator: T, root: T) -> Crossing<T> {
        let steep_enough = self.is_steep_enough();
        let crossing = self.bound.root(self.a, numerator, root);
        // The plain formula computes the point first. The margin covers the difference.
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

/// The size of a cylinder's coordinates and of the cylinder, which is constant for all rays.
#[inline(always)]
pub(super) fn extent<T: Real>(record: &CylinderRecord<T>) -> T {
    // Underflow changes lengths by far less than 2^-300.
    const UNDERFLOW: f64 = f64::from_bits((1023 - 300) << 52);
    magnitude(record.center) + record.radius + record.half_height + T::of(UNDERFLOW)
}

/// How far rounding may have moved the point at an accepted lambda.
#[inline(always)]
pub(super) fn margin<T: Rounding>(record: &CylinderRecord<T>, ray: &Ray<T>, lambda: T) -> T {
    let along = lambda * magnitude(ray.direction) * T::of(2.0 * LIMITS.lambda_error::<T>());
    along + extent(record) * T::of(64.0 * T::UNIT_ROUNDOFF)
}

/// A number not smaller than the vector's length, and at most 1.74 times as large.
#[inline(always)]
pub(super) fn magnitude<T: Real>(vector: Vec3<T>) -> T {
    vector.x.abs() + vector.y.abs() + vector.z.abs()
}
