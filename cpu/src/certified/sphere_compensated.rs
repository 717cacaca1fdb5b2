//! Ray against sphere where the textbook's root is the small difference of two large numbers: a ray that starts near a
//! sphere much larger than its distance from it, as most rays do above a ground.
//!
//! That root, `(h - sqrt(D)) / a` where `h > 0`, equals `c / (h + sqrt(D))`, in which the sum loses nothing. What
//! still cancels is `c = |C - O|^2 - r^2`, whose products and sums are taken with their rounding errors (Ogita, Rump and
//! Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005). The bounds are derived in `docs/accuracy.md`.

use super::certificate::{OVERFLOW, UNDERFLOW, in_scale};
use super::exact_sums::{Fused, two_product, two_sum};
use super::sphere::{LIMITS, Lanes};
use crate::ray::Ray;
use crate::sphere::SphereRecord;
use crate::vec3::Vec3;

/// The largest condition number of the root's denominator that is accepted.
const CONDITION: f64 = 4096.0;
/// Times `u (|C - O|^2 + r^2)`, what `c` must exceed for its own error to be of no account.
const LEAST_C: f64 = 64.0;

/// The lambda of rays that start outside and go inward, or inside and outward, in the lanes where it is certain and in
/// range; of no meaning in the others.
#[inline(always)]
#[must_use]
pub fn judge<T: Fused>(record: &SphereRecord<T>, ray: &Ray<T>) -> Lanes<T> {
    let a = ray.direction.dot(ray.direction);
    let (h, discriminant) = record.quadratic(ray, a);
    let root = discriminant.sqrt();
    let (c, squares) = difference_of_squares(record, ray.origin);
    let denominator = h.abs() + root;
    let lambda = c.abs() / denominator;
    let size = a * squares;
    let accurate = (size + T::of(UNDERFLOW)).less(root * denominator * T::of(CONDITION)) & size.less(T::of(OVERFLOW));
    let c_counts = (squares * T::of(LEAST_C * T::UNIT_ROUNDOFF) + T::of(UNDERFLOW)).less(c.abs());
    // Of two roots with one sign the smaller; of two with different signs the positive one is the difference.
    let ahead = T::of(0.0).less(h * c);
    Lanes { lambda, certain: in_scale(a) & accurate & c_counts & ahead & LIMITS.in_range(lambda) }
}

/// `|C - O|^2 - r^2`, nearly as if rounded once, and the sum of the two.
#[inline(always)]
fn difference_of_squares<T: Fused>(record: &SphereRecord<T>, origin: Vec3<T>) -> (T, T) {
    let (x, x_rest) = two_sum(record.center.x, -origin.x);
    let (y, y_rest) = two_sum(record.center.y, -origin.y);
    let (z, z_rest) = two_sum(record.center.z, -origin.z);
    let (xx, xx_rest) = two_product(x, x);
    let (yy, yy_rest) = two_product(y, y);
    let (zz, zz_rest) = two_product(z, z);
    let (rr, rr_rest) = two_product(record.radius, record.radius);
    let (sum, first_rest) = two_sum(xx, yy);
    let (sum, second_rest) = two_sum(sum, zz);
    let (difference, third_rest) = two_sum(sum, -rr);
    let across = x.fused(x_rest, y.fused(y_rest, z * z_rest));
    let rest =
        (first_rest + second_rest + third_rest) + ((xx_rest + yy_rest) + (zz_rest - rr_rest)) + (across + across);
    (difference + rest, sum + rr)
}
