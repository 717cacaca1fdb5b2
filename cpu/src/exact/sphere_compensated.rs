//! Intersects ray and sphere if the root of the plain formula is the small difference of two large numbers. Such a ray
//! starts near a sphere whose radius is much larger than the distance to its surface. Most rays above a dominant sphere
//! do so.
//!
//! For `h > 0` that root is `(h - sqrt(D)) / a`. It equals `c / (h + sqrt(D))`, in which the sum does not cancel. Only
//! `c = |C - O|^2 - r^2` still cancels. So its products and sums are computed together with their rounding errors
//! (Ogita, Rump and Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005). The bounds are derived in
//! `docs/accuracy.md`.

use crate::exact::{
    error_bound::OVERFLOW, error_bound::UNDERFLOW, error_bound::in_scale, sphere_filter::LIMITS,
    sphere_filter::SphereHits,
};
use crate::geometry::{ray::Ray, sphere::SphereRecord};
use crate::math::{error_free::two_product, error_free::two_sum, rounding::MulAdd, vec3::Vec3};

/// Limits the relative error of lambda to 4.9e-12. A root is accepted only if `a (|C - O|^2 + r^2) < CONDITION_LIMIT
/// sqrt(D) (|h| + sqrt(D))`, with the quadratic `a lambda^2 - 2 h lambda + c` and `D = h^2 - a c`.
pub const CONDITION_LIMIT: f64 = 4096.0;
/// The smallest magnitude of `c` for which the bound of lambda's error holds, in units of `u (|C - O|^2 + r^2)`. `u` is
/// the unit roundoff.
const LEAST_C: f64 = 64.0;

/// Returns the hits of rays that start outside the sphere and go towards its centre, or start inside and go away from
/// its centre. A lane with any other ray is not `certain`. The same holds for a lane whose lambda is uncertain or out
/// of range. The lambda of a lane that is not `certain` has no meaning.
#[inline(always)]
pub fn compensated<T: MulAdd>(record: &SphereRecord<T>, ray: &Ray<T>) -> SphereHits<T> {
    let a = ray.direction.dot(ray.direction);
    let (h, discriminant) = record.seen_from(ray.origin).quadratic(ray.direction, a);
    let root = discriminant.sqrt();
    let (c, squares) = difference_of_squares(record, ray.origin);
    let denominator = h.abs() + root;
    let lambda = c.abs() / denominator;
    let size = a * squares;
    let accurate =
        (size + T::of(UNDERFLOW)).less(root * denominator * T::of(CONDITION_LIMIT)) & size.less(T::of(OVERFLOW));
    let c_is_large = (squares * T::of(LEAST_C * T::UNIT_ROUNDOFF) + T::of(UNDERFLOW)).less(c.abs());
    // Lambda is the smaller root if both are positive, and the positive root if their signs differ.
    let ahead = T::of(0.0).less(h * c);
    SphereHits { lambda, certain: in_scale(a) & accurate & c_is_large & ahead & LIMITS.in_range(lambda) }
}

/// Returns `|C - O|^2 - r^2`, nearly as accurate as if it were rounded once, and `|C - O|^2 + r^2` with the usual
/// accuracy.
#[inline(always)]
fn difference_of_squares<T: MulAdd>(record: &SphereRecord<T>, origin: Vec3<T>) -> (T, T) {
    let (x, x_error) = two_sum(record.center.x, -origin.x);
    let (y, y_error) = two_sum(record.center.y, -origin.y);
    let (z, z_error) = two_sum(record.center.z, -origin.z);
    let (xx, xx_error) = two_product(x, x);
    let (yy, yy_error) = two_product(y, y);
    let (zz, zz_error) = two_product(z, z);
    let (rr, rr_error) = two_product(record.radius, record.radius);
    let (sum, first_error) = two_sum(xx, yy);
    let (sum, second_error) = two_sum(sum, zz);
    let (difference, third_error) = two_sum(sum, -rr);
    let across = x.mul_add(x_error, y.mul_add(y_error, z * z_error));
    let error = (first_error + second_error + third_error)
        + ((xx_error + yy_error) + (zz_error - rr_error))
        + (across + across);
    (difference + error, sum + rr)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::error_bound::Decision;
    use crate::exact::sphere;
    use crate::exact::sphere::precise;
    use crate::math::{double_double::DoubleDouble, real::Real};
    use crate::sampling::uniform::Uniform;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, LaneMask, Simd};

    /// Returns rays that start `10^-4` to `10^2` above or below the surface of spheres of radius 1 to `10^7`.
    fn cases(count: usize) -> Vec<(SphereRecord, Ray)> {
        let mut draws = Uniform::new(11);
        let mut cases = Vec::with_capacity(count);
        for number in 0..count {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (center, up, direction) = (vector() * 100.0, vector().unit(), vector());
            let radius = 10.0_f64.powf(draws.draw(0.0, 7.0));
            let height = 10.0_f64.powf(draws.draw(-4.0, 2.0)) * if number % 3 == 0 { -1.0 } else { 1.0 };
            let origin = center + up * (radius + height);
            cases.push((SphereRecord::new(center, radius), Ray { origin, direction }));
        }
        cases
    }

    #[test]
    fn what_is_certain_is_the_precise_answer() {
        let (mut certain, mut worst) = (0, 0.0_f64);
        for (record, ray) in cases(200_000) {
            let lanes = compensated(&record, &ray);
            if lanes.certain {
                let precise = precise(&record, &ray).expect("the ray hits the sphere");
                worst = worst.max(((lanes.lambda - precise) / precise).abs());
                certain += 1;
            }
        }
        assert!(certain > 80_000, "{certain}");
        // By the proof the relative error is at most (10.5 k + 4 sqrt(k) + 5) u, where k is the condition limit.
        assert!(worst < 4.9e-12, "{worst:e}");
    }

    #[test]
    fn a_c_of_rounding_errors_is_uncertain() {
        // The surface is so near that `c` consists of the squares of the roundings of `C - O`, which are left out. The
        // direction is so short that lambda is in range.
        let (center, radius) = (Vec3::new(1.0 / 3.0, 0.1, 0.0), 1e6);
        let record = SphereRecord::new(center, radius);
        for number in 0..1000 {
            let angle = 0.1 + f64::from(number) * 1e-3;
            let [x, y] = [radius * angle.cos(), radius * angle.sin()];
            let of = DoubleDouble::of;
            let [across, up] = [of(x) - of(center.x), of(y) - of(center.y)];
            let rest = of(radius) * of(radius) - across * across - up * up;
            let origin = Vec3::new(x, y, rest.abs().sqrt().high);
            let direction = (center - origin) * 1e-30;
            let lanes = compensated(&record, &Ray { origin, direction });
            assert!(!lanes.certain, "{origin:?}: {}", lanes.lambda);
        }
    }

    #[test]
    fn most_uncertain_rays_above_a_large_sphere_become_certain() {
        let (mut uncertain, mut certain) = (0, 0);
        for (record, ray) in cases(100_000) {
            if sphere::filtered(&record, &ray) == Decision::Uncertain {
                uncertain += 1;
                certain += u32::from(compensated(&record, &ray).certain);
            }
        }
        assert!(uncertain > 10_000 && certain * 10 > uncertain * 8, "{certain} of {uncertain}");
    }

    #[test]
    fn a_direction_out_of_scale_and_nan_are_uncertain() {
        let large = SphereRecord::new(Vec3::new(0.0, -1e4, 0.0), 1e4);
        let down = |length: f64| Ray { origin: Vec3::new(0.0, 1.0, 0.0), direction: Vec3::new(0.0, -length, 0.0) };
        assert!(compensated(&large, &down(1.0)).certain);
        for length in [0.0, 1e-60, 1e60, f64::INFINITY, f64::NAN] {
            assert!(!compensated(&large, &down(length)).certain, "{length}");
        }
        // One ray goes away from the sphere, and the other one starts on its surface.
        assert!(!compensated(&large, &down(-1.0)).certain);
        assert!(!compensated(&large, &Ray { origin: Vec3::ZERO, direction: Vec3::new(0.3, -1.0, 0.0) }).certain);
    }

    /// A kernel that intersects as many cases as there are lanes, and compares them with one case at a time.
    struct Together<'a>(&'a [(SphereRecord, Ray)]);

    impl Kernel for Together<'_> {
        type Output = usize;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> usize {
            use crate::simd::SimdF64 as _;
            let cases = &self.0[..S::F64::LANES];
            let mut values = [[0.0; 8]; 10];
            for (lane, (record, ray)) in cases.iter().enumerate() {
                let Ray { origin, direction } = ray;
                let all = [record.center.to_array(), origin.to_array(), direction.to_array()].concat();
                for (value, component) in values.iter_mut().zip(all.into_iter().chain([record.radius])) {
                    value[lane] = component;
                }
            }
            let at = |first: usize| {
                Vec3::new(
                    S::F64::load(&values[first]),
                    S::F64::load(&values[first + 1]),
                    S::F64::load(&values[first + 2]),
                )
            };
            let record = SphereRecord::new(at(0), S::F64::load(&values[9]));
            let lanes = compensated(&record, &Ray { origin: at(3), direction: at(6) });
            let mut lambdas = [0.0; 8];
            lanes.lambda.store(&mut lambdas);
            for (lane, (record, ray)) in cases.iter().enumerate() {
                let one = compensated(record, ray);
                assert_eq!(lanes.certain.bits() >> lane & 1 == 1, one.certain);
                assert!(!one.certain || lambdas[lane].to_bits() == one.lambda.to_bits());
            }
            S::F64::LANES
        }
    }

    #[test]
    fn lanes_are_as_each_alone_in_every_instruction_set() {
        let cases = cases(4000);
        for set in InstructionSet::available() {
            let mut at = 0;
            while at + 8 <= cases.len() {
                at += set.run(Together(&cases[at..]));
            }
        }
    }
}
