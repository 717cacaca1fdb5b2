//! The rule of a hit on a cylinder's cap (specification, section 9.3), by the plain formula.
//!
//! Lambda is `(center - origin) . axis / (direction . axis)`. The ray hits the cap if the magnitude of that divisor is
//! at least 1e-8, lambda is at least 1e-3, and the point is at most the radius from `center`. The programs decide by
//! the exact twin, `exact/cap.rs`; they use this form only for numbers that are not finite. The reference has its
//! literal copy in `cap` of `reference/nearest.rs`, and WGSL in `cylinder_cap` of `cylinder.wgsl`.

use crate::{geometry::ray::Ray, geometry::ray::in_range, math::real::Real, math::vec3::Vec3};

/// A plane is not hit if the product of its normal and the ray's direction has a smaller magnitude than this.
pub const PARALLEL: f64 = 1e-8;

/// Where the ray hits the cap of this radius around `center`. The axis has length one.
#[inline(always)]
pub fn intersect<T: Real<Mask = bool>>(center: Vec3<T>, axis: Vec3<T>, radius: T, ray: &Ray<T>) -> Option<T> {
    // The bottom cap's normal is -axis: negating numerator and denominator leaves the quotient's bits.
    let slope = ray.direction.dot(axis);
    let lambda = (center - ray.origin).dot(axis) / slope;
    let is_on_disc = || (ray.at(lambda) - center).length().less_equal(radius);
    (!slope.abs().less(T::of(PARALLEL)) && in_range(lambda) && is_on_disc()).then_some(lambda)
}
