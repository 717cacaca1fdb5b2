//! The quadratic of a ray and the side of a cylinder, and the planes of its caps, without the cancellation of the plain
//! formulas. The quadratic serves rays that run nearly along the axis, or start far away along it, such as those in a
//! tube. The planes serve rays that start near a wide cap and far from its centre, such as those on a floor.
//!
//! The plain formula subtracts the parts along the axis from the direction and from the vector to the ray's origin, and
//! its errors are relative to the whole vectors. The cross product with the axis `V` of the scene file has the part
//! across the axis at once. Its components are differences of two products, which Kahan's algorithm computes with a
//! relative error of 2 u (Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate
//! computation of 2 x 2 determinants", Math. Comp. 82, 2013). So the errors are relative to the parts across the axis.
//! The equation is multiplied by `V.V`, as in `exact/cylinder_exact.rs`. The bounds are in `docs/accuracy.md`.

use crate::exact::cylinder_parts::{LIMITS, Plane, Side};
use crate::exact::{error_bound::ErrorBound, error_bound::in_scale};
use crate::geometry::{cylinder::CylinderRecord, ray::Ray};
use crate::math::error_free::{cross, difference, two_product, two_sum};
use crate::math::{rounding::MulAdd, vec3::Vec3};

/// The share of `|O - C|^2` in the size of the squares, 2^-90. It covers the part of `O - C` that rounding loses, if
/// the ray starts farther away along the axis than 2^40 radii.
pub const SHARE_OF_DISTANCE: f64 = f64::from_bits((1023 - 90) << 52);

/// Returns the quadratic of the ray and the side. `axis` is the axis of the scene file.
#[inline(always)]
pub fn side<T: MulAdd>(record: &CylinderRecord<T>, axis: Vec3<T>, ray: &Ray<T>) -> Side<T> {
    let (from_center, error) = difference(ray.origin, record.center);
    let r_c = cross(from_center, axis) + cross(error, axis);
    let direction = cross(ray.direction, axis);
    let axis_squared = axis.dot(axis);
    let (a, h, r_c_squared) = (direction.dot(direction), direction.dot(r_c), r_c.dot(r_c));
    let c = r_c_squared - record.radius_squared * axis_squared;
    let far = from_center.dot(from_center) * T::of(SHARE_OF_DISTANCE);
    let squares = r_c_squared + (record.radius_squared + far) * axis_squared;
    Side {
        bound: ErrorBound::new(LIMITS, a, squares),
        length_squared: ray.direction.dot(ray.direction),
        a,
        h,
        discriminant: h * h - a * c,
        // No product of numbers in scale underflows or overflows.
        a_is_accurate: in_scale(axis_squared) & in_scale(a) & in_scale(squares),
        along: from_center.dot(record.axis),
        slope: ray.direction.dot(record.axis),
    }
}

/// The share of the size of the plain terms in the size of the distance of a plane, 2^-40. It covers the roundings of
/// rounding errors.
pub const SHARE_OF_SIZE: f64 = 1.0 / (1_u64 << 40) as f64;

/// Returns the plane of the cap around `center`. `axis` is the axis of the scene file.
#[inline(always)]
pub fn plane<T: MulAdd>(
    record: &CylinderRecord<T>,
    axis: Vec3<T>,
    ray: &Ray<T>,
    center: Vec3<T>,
    is_top: bool,
) -> Plane<T> {
    let to_cap = if is_top { axis } else { -axis };
    let (from_middle, error) = difference(record.center + record.center, ray.origin + ray.origin);
    let (twice, more) = difference(from_middle, -to_cap);
    let (error, two) = (error + more, T::of(2.0));
    let (x, x_error) = two_product(twice.x, axis.x);
    let (y, y_error) = two_product(twice.y, axis.y);
    let (z, z_error) = two_product(twice.z, axis.z);
    let (sum, first) = two_sum(x, y);
    let (sum, second) = two_sum(sum, z);
    let rest = (first + second) + (x_error + y_error + z_error) + error.dot(axis);
    let to_plane = (sum + rest) / (record.half_height * (two + two));
    let size = to_plane.abs() + Plane::size(record, center - ray.origin) * T::of(SHARE_OF_SIZE);
    Plane::at(record, ray, center, (to_plane, size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{cylinder, error_bound::Decision};

    #[test]
    fn an_axis_out_of_scale_is_uncertain() {
        // The square of the radius underflows. Times the square of the height it would be as large as other terms.
        let (radius, axis) = (2.0_f64.powi(-538), Vec3::new(0.0, 2.0_f64.powi(510), 0.0));
        let record = CylinderRecord::new(Vec3::ZERO, radius, axis);
        let (origin, direction) = (Vec3::new(-8.0 * radius, 0.0, 0.5 * radius), Vec3::new(32.0 * radius, 1e-40, 0.0));
        let ray = Ray { origin, direction };
        assert_eq!(cylinder::compensated(&record, &axis, &ray), Decision::Uncertain);
        assert!(cylinder::precise(&record, &axis, &ray).is_some());
    }
}
