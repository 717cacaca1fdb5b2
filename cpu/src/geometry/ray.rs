//! Rays, and the point where a ray hits a surface.

use crate::math::{real::Real, vec3::Vec3, vec3::broadcast};

/// The smallest lambda of a hit that counts, in lengths of the ray's direction (specification, section 8.2).
pub const LAMBDA_MIN: f64 = 1e-3;

/// Half of the distance between [`LAMBDA_MIN`] and the `f64` below it, 2^-63. A hit counts if its exact lambda, rounded
/// to `f64`, is at least [`LAMBDA_MIN`]. So the limit of exact lambdas is `LAMBDA_MIN - HALF_STEP`, which itself
/// counts, because it is rounded to `LAMBDA_MIN`, the number whose last bit is even.
pub const HALF_STEP: f64 = (LAMBDA_MIN - LAMBDA_MIN.next_down()) / 2.0;

/// A half-line from `origin` along `direction`, which need not have length one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Ray<T = f64> {
    /// The point where the ray starts, in scene units.
    pub origin: Vec3<T>,
    /// The direction of the ray, in scene units. The length of this vector is the unit of lambda.
    pub direction: Vec3<T>,
}

broadcast!(Ray: origin, direction;);

impl<T: Real> Ray<T> {
    /// Returns the point `origin + direction lambda`.
    #[inline(always)]
    pub fn at(&self, lambda: T) -> Vec3<T> {
        self.origin + self.direction * lambda
    }
}

/// Whether a hit at the computed `lambda` counts: `lambda`, which is rounded, is at least [`LAMBDA_MIN`]. NaN never
/// counts.
#[inline(always)]
pub fn in_range<T: Real>(lambda: T) -> T::Mask {
    T::of(LAMBDA_MIN).less_equal(lambda)
}

/// Returns whether a ray along `direction` comes from outside, and the normal on the side that the ray comes from
/// (specification, section 8.3). `outward` is the normal that points out of the object.
#[inline(always)]
pub fn front_and_normal<T: Real>(direction: Vec3<T>, outward: Vec3<T>) -> (T::Mask, Vec3<T>) {
    let front = direction.dot(outward).less(T::of(0.0));
    (front, Vec3::select(front, outward, -outward))
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec3 = Vec3::new(0.0, 1.0, 0.0);

    #[test]
    fn a_ray_advances_by_lengths_of_its_direction() {
        let ray = Ray { origin: Vec3::ONE, direction: UP * 2.0 };
        assert_eq!(ray.at(3.0), Vec3::new(1.0, 7.0, 1.0));
    }

    #[test]
    fn hits_start_at_a_thousandth() {
        assert_eq!(HALF_STEP, 2.0_f64.powi(-63));
        assert!(in_range(1e-3) && in_range(f64::INFINITY));
        assert!(!in_range(1e-3_f64.next_down()) && !in_range(-1.0_f64) && !in_range(f64::NAN));
    }

    #[test]
    fn the_normal_faces_the_ray() {
        assert_eq!([-UP, UP].map(|direction| front_and_normal(direction, UP)), [(true, UP), (false, -UP)]);
        let (front, _) = front_and_normal(Vec3::new(1.0, 0.0, 0.0), UP);
        assert!(!front, "perpendicular counts as inside, as the statement's 'otherwise' says");
    }
}
