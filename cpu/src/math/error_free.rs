//! Sums and products with their rounding errors. A rounding error is itself a floating-point number. So result and
//! rounding error together are exact, short of overflow and underflow.

use crate::math::rounding::Rounding;
use crate::math::vec3::Vec3;

/// Returns the rounded `a + b` and its rounding error: the exact sum minus the rounded one (Knuth).
#[inline(always)]
pub(crate) fn two_sum<T: Rounding>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// Returns the rounded `a b` and its rounding error: the exact product minus the rounded one.
#[inline(always)]
pub fn two_product<T: Rounding>(a: T, b: T) -> (T, T) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

/// Returns `a - b`, rounded, and the rounding error.
#[inline(always)]
pub fn vector_difference<T: Rounding>(a: Vec3<T>, b: Vec3<T>) -> (Vec3<T>, Vec3<T>) {
    let (x, y, z) = (two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z));
    (Vec3::new(x.0, y.0, z.0), Vec3::new(x.1, y.1, z.1))
}

/// Returns the dot product, rounded, and its rounding error, itself rounded.
#[inline(always)]
pub(crate) fn dot_with_error<T: Rounding>(a: Vec3<T>, b: Vec3<T>) -> (T, T) {
    let ((x, x_error), (y, y_error)) = (two_product(a.x, b.x), two_product(a.y, b.y));
    let (z, z_error) = two_product(a.z, b.z);
    let (sum, first) = two_sum(x, y);
    let (sum, second) = two_sum(sum, z);
    (sum, (first + second) + (x_error + y_error + z_error))
}

/// Returns the cross product. The relative error of each component is at most 2 u.
#[inline(always)]
pub fn accurate_cross<T: Rounding>(a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    Vec3::new(
        difference_of_products(a.y, b.z, a.z, b.y),
        difference_of_products(a.z, b.x, a.x, b.z),
        difference_of_products(a.x, b.y, a.y, b.x),
    )
}

/// Returns the cross product of `a + a_error` and `b` as two vectors whose sum it is. The second vector consists of
/// rounding errors, and of the part of `a_error`.
#[inline(always)]
pub fn cross_with_error<T: Rounding>((a, a_error): (Vec3<T>, Vec3<T>), b: Vec3<T>) -> (Vec3<T>, Vec3<T>) {
    let more = accurate_cross(a_error, b);
    let x = difference_with_error([a.y, b.z, a.z, b.y], more.x);
    let y = difference_with_error([a.z, b.x, a.x, b.z], more.y);
    let z = difference_with_error([a.x, b.y, a.y, b.x], more.z);
    (Vec3::new(x.0, y.0, z.0), Vec3::new(x.1, y.1, z.1))
}

/// Returns `a b - c d + more` in two parts. `more` must be as small as a rounding error.
#[inline(always)]
fn difference_with_error<T: Rounding>([a, b, c, d]: [T; 4], more: T) -> (T, T) {
    let ((left, left_error), (right, right_error)) = (two_product(a, b), two_product(c, d));
    let (difference, error) = two_sum(left, -right);
    (difference, error + (left_error - right_error) + more)
}

/// Returns `a b - c d` by Kahan's algorithm.
#[inline(always)]
fn difference_of_products<T: Rounding>(a: T, b: T, c: T, d: T) -> T {
    let product = c * d;
    let error = (-c).mul_add(d, product);
    a.mul_add(b, -product) + error
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0));
        assert_eq!(two_sum(1.0, 1e16), (1e16, 1.0));
        let x = 1.0 + f64::EPSILON;
        assert_eq!(two_product(x, x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
        // With `e` for the epsilon, `(1 + e)^2 - 1` is `2 e + e^2`. The error `(0, 0, e)` of the first vector adds
        // `e` times `(-(1 + e), 1, 0)`.
        let (a, a_error) = (Vec3::new(x, 1.0, 0.0), Vec3::new(0.0, 0.0, f64::EPSILON));
        let rest = Vec3::new(-x, 1.0, f64::EPSILON) * f64::EPSILON;
        let product = cross_with_error((a, a_error), Vec3::new(1.0, x, 0.0));
        assert_eq!(product, (Vec3::new(0.0, 0.0, 2.0 * f64::EPSILON), rest));
    }
}
