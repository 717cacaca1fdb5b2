//! The quadratic of a ray and the side of a cylinder, and the planes of its caps, without the cancellation of the plain
//! formulas. The quadratic serves rays that run nearly along the axis, or start far away along it, such as those in a
//! tube. The planes serve rays that start near a wide cap and far from its centre, such as those on a floor.
//!
//! The plain formula subtracts the parts along the axis from the direction and from the vector to the ray's origin, and
//! its errors are relative to the whole vectors. The cross product with the axis `V` of the scene file has the part
//! across the axis at once. Its components are differences of two products, which Kahan's algorithm computes with a
//! relative error of 1.5 u (Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate
//! computation of 2 x 2 determinants", Math. Comp. 82, 2013). So the errors are relative to the parts across the axis.
//! The equation is multiplied by `V.V`, as in `exact/cylinder_exact.rs`. The bounds are derived in `docs/accuracy.md`.

use crate::exact::cylinder_parts::{LIMITS, Plane, Side};
use crate::exact::{error_bound::ErrorBound, error_bound::in_scale};
use crate::geometry::{cylinder::CylinderRecord, ray::Ray};
use crate::math::error_free::{cross, difference, two_product, two_sum};
use crate::math::{rounding::MulAdd, vec3::Vec3};

/// The share of `|O - C|^2` in the size of the squares, 2^-90. It covers the part of `O - C` that rounding loses, if
/// the ray starts farther away along the axis than 2^40 radii.
const SHARE_OF_DISTANCE: f64 = f64::from_bits((1023 - 90) << 52);

/// Returns the quadratic of the ray and the side. `axis` is the axis of the scene file.
#[inline(always)]
pub(super) fn side<T: MulAdd>(record: &CylinderRecord<T>, axis: Vec3<T>, ray: &Ray<T>) -> Side<T> {
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
const SHARE_OF_SIZE: f64 = 1.0 / (1_u64 << 40) as f64;

/// Returns the plane of the cap around `center`. `axis` is the axis of the scene file.
#[inline(always)]
pub(super) fn plane<T: MulAdd>(
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
    use crate::sampling::uniform::Uniform;

    #[test]
    fn what_is_certain_is_the_precise_answer() {
        let mut draws = Uniform::new(49);
        let mut decided = [0; 2];
        for number in 0..20_000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (center, axis, across, aside) = (vector(), vector(), vector(), vector() * 0.5);
            let (far, direction, length) = (vector(), vector(), 10.0_f64.powf(draws.draw(0.0, 13.0)));
            let is_tube = number % 2 == 0;
            let (radius, axis, origin, direction) = if is_tube {
                // The ray starts far away along the axis of a tube and goes towards a point in it, or it starts near
                // the side of a long tube.
                let off = across.perpendicular_to(axis.unit());
                let rim = off.unit() * (1.0 + draws.draw(-1.0, 1.0) * 10.0_f64.powf(draws.draw(-6.0, 0.0)));
                let along = axis * (length * draws.draw(-0.4, 0.4));
                match number % 4 {
                    0 => (1.0, axis, center - axis * length + off * 0.9, aside + axis * length - off * 0.9),
                    _ => (1.0, axis * length, center + along + rim, direction),
                }
            } else {
                // The ray starts above a wide floor, far from its centre.
                let from = far.perpendicular_to(axis.unit()) * length + axis * draws.draw(-0.4, 3.0);
                (2.0 * length, axis, center + from, direction)
            };
            let record = CylinderRecord::new(center, radius, axis);
            let ray = Ray { origin, direction };
            let Decision::Certain(hit) = cylinder::compensated(&record, &axis, &ray) else { continue };
            let precise = cylinder::precise(&record, &axis, &ray);
            assert_eq!(hit.map(|hit| hit.1), precise.map(|hit| hit.1), "{record:?}, {ray:?}");
            if let (Some((lambda, _)), Some((precise, _))) = (hit, precise) {
                assert!(
                    (lambda - precise).abs() <= 6.2e-10 * precise,
                    "{lambda:e} and {precise:e}: {record:?}, {ray:?}"
                );
                let plain = cylinder::filtered(&record, &ray);
                decided[usize::from(is_tube)] += usize::from(plain == Decision::Uncertain);
            }
        }
        assert!(decided.iter().all(|&count| count > 1000), "{decided:?}");
    }
}
