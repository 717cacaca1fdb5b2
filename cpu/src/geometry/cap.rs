//! The rule of a hit on a cylinder's cap (specification, section 9.3), by the plain formula.
//!
//! Lambda is `(center - origin) . axis / (direction . axis)`. The ray hits the cap if three conditions hold: the
//! magnitude of that divisor is at least 1e-8, lambda is at least 1e-3, and the point is at most the radius from
//! `center`. The programs use the exact counterpart of this rule, `exact/cylinder_decision.rs`. They call [`intersect`]
//! only for numbers that are not finite. The reference has a literal copy in `cap` of `reference/nearest.rs`, and WGSL
//! has one in `cylinder_cap` of `cylinder.wgsl`.
//!
//! `geometry/cylinder.rs` has the centres of both caps and their normals, and the order in which the caps follow the
//! side. A ray that starts inside a cylinder and certainly leaves it is told in `accel/inside.rs`.

use crate::{geometry::ray::Ray, geometry::ray::in_range, math::real::Real, math::vec3::Vec3};

/// If the dot product of a cap's normal and the ray's direction has a smaller magnitude than this, the cap is not hit.
pub const PARALLEL: f64 = 1e-8;

/// Returns the lambda at which the ray hits the cap of this radius around `center`, or `None` if it misses the cap. The
/// axis has length one.
#[inline(always)]
pub fn intersect<T: Real<Mask = bool>>(center: Vec3<T>, axis: Vec3<T>, radius: T, ray: &Ray<T>) -> Option<T> {
    // The normal of the bottom cap is -axis. With it, numerator and denominator are negated, and the quotient has the
    // same bits. So both caps use the axis.
    let slope = ray.direction.dot(axis);
    let lambda = (center - ray.origin).dot(axis) / slope;
    let is_on_disc = || (ray.at(lambda) - center).length().less_equal(radius);
    (!slope.abs().less(T::of(PARALLEL)) && in_range(lambda) && is_on_disc()).then_some(lambda)
}
