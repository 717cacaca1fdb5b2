//! Decides which of two hits of a ray is closer: the one with the smaller exact lambda.
//!
//! The computed lambdas have errors, so they decide only if they are further apart than their errors
//! ([`is_certainly_closer`]). If they are not, [`compare`] takes these steps:
//! 1. Identical surfaces tie. Two caps perpendicular to the same coordinate axis are ordered by the coordinates of
//!    their planes. Rays inside a cylinder that stands on another one often meet two such caps.
//! 2. Both lambdas are computed by the [compensated](crate::exact::compensated_roots) formulas, with a bound of their
//!    errors that is mostly a thousandth of the one of all accepted lambdas.
//! 3. The exact lambdas are compared in dyadic arithmetic, without a square root. Only this step recognises equal
//!    lambdas of other surfaces.
//!
//! A tie, of two equal lambdas, is decided by [`geometry::tie`](crate::geometry::tie).

use std::cmp::Ordering;

use crate::counters::{Counter, add};
use crate::exact::{
    cylinder_compensated, cylinder_exact, cylinder_parts::LIMITS, exact_lambda::ExactLambda, sphere_compensated,
    sphere_exact, sphere_exact::NotFinite,
};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::math::{double_double::DoubleDouble, error_free::two_sum, rounding::Rounding, vec3::Vec3};
use crate::simd::fused::run_fused;

/// A surface that a ray hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// A sphere.
    Sphere(SphereRecord),
    /// A cylinder with its axis in the scene file, and the part of it that is hit.
    Cylinder(CylinderRecord, Vec3, CylinderPart),
}

/// Whether the exact lambda of one hit certainly is smaller than that of another. Both are lambdas that the steps of
/// [`crate::exact`] accept in the arithmetic `T`, or infinite, which stands for no hit. Their relative errors are at
/// most a third of the [`lambda_error`](crate::exact::error_bound::Limits::lambda_error) of cylinders, which exceeds
/// that of spheres. The result is false if a number is NaN.
#[inline(always)]
pub fn is_certainly_closer<T: Rounding>(lambda: T, other: T) -> T::Mask {
    // The factor is 1 + 2^-29 or 1 + 2^-54, which `T` holds without an error.
    (lambda * (T::of(1.0) + T::of(LIMITS.lambda_error()))).less(other)
}

/// Compares the exact lambdas of a ray's hits on two surfaces, which it must hit. The result is `None` if the exact
/// lambdas are needed, and a number is not finite.
pub(crate) fn compare(ray: &Ray, surfaces: [&Surface; 2]) -> Option<Ordering> {
    add(Counter::NearHits, 1);
    if surfaces[0] == surfaces[1] {
        return Some(Ordering::Equal);
    }
    if let [Some((axis, left)), Some((other_axis, right))] = surfaces.map(Surface::straight_plane)
        && axis == other_axis
        && let Some(order) = (left - right).high.partial_cmp(&0.0)
    {
        return Some(if ray.direction.to_array()[axis] < 0.0 { order.reverse() } else { order });
    }
    if let [Some(left), Some(right)] = surfaces.map(|surface| surface.bounds(ray)) {
        if left[1] < right[0] {
            return Some(Ordering::Less);
        }
        if right[1] < left[0] {
            return Some(Ordering::Greater);
        }
    }
    add(Counter::NearHitsExactly, 1);
    exactly(ray, surfaces)
}

/// Compares in dyadic arithmetic only, with the result of [`compare`].
pub(crate) fn exactly(ray: &Ray, surfaces: [&Surface; 2]) -> Option<Ordering> {
    let [left, right] = surfaces.map(|surface| surface.exact_lambda(ray).ok().flatten());
    Some(left?.compare(&right?))
}

impl Surface {
    /// Returns the coordinate axis to which a cap is perpendicular, and twice the coordinate of its plane along that
    /// axis, without a rounding error. The result is `None` for all other surfaces. It is NaN if the sum overflows.
    fn straight_plane(&self) -> Option<(usize, DoubleDouble)> {
        let &Self::Cylinder(CylinderRecord { center, .. }, axis, part) = self else { return None };
        let axis = axis.to_array();
        let mut components = (0..3).filter(|&component| axis[component] != 0.0);
        let (Some(along), None) = (components.next(), components.next()) else { return None };
        // A double is exact, but a half may underflow.
        let twice_to_cap = match part {
            CylinderPart::Side => return None,
            CylinderPart::Top => axis[along],
            CylinderPart::Bottom => -axis[along],
        };
        let (high, low) = two_sum(2.0 * center.to_array()[along], twice_to_cap);
        Some((along, DoubleDouble { high, low }))
    }

    /// Returns bounds of the lambda of the ray's hit by the compensated formulas, or `None` if they are uncertain.
    fn bounds(&self, ray: &Ray) -> Option<[f64; 2]> {
        let surface = self;
        let (lambda, error) = run_fused!(|surface: &Surface, ray: &Ray| -> Option<(f64, f64)> {
            match surface {
                Surface::Sphere(record) => sphere_compensated::lambda(record, ray),
                Surface::Cylinder(record, axis, part) => cylinder_compensated::lambda(record, *axis, ray, *part),
            }
        })?;
        Some([lambda - error, lambda + error])
    }

    fn exact_lambda(&self, ray: &Ray) -> Result<Option<ExactLambda>, NotFinite> {
        match self {
            Self::Sphere(record) => sphere_exact::lambda(record, ray),
            &Self::Cylinder(CylinderRecord { center, radius, .. }, axis, part) => {
                cylinder_exact::lambda(center, radius, axis, ray, part)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::uniform::Uniform;

    /// Returns the cap, at this height above `point`, of an upright cylinder. The cap faces a ray along `direction`.
    fn cap(point: Vec3, direction: Vec3, height: f64, length: f64) -> Surface {
        let (part, half) = match direction.y < 0.0 {
            true => (CylinderPart::Top, length / 2.0),
            false => (CylinderPart::Bottom, -length / 2.0),
        };
        let (center, axis) = (point + Vec3::new(0.0, height - half, 0.0), Vec3::new(0.0, length, 0.0));
        Surface::Cylinder(CylinderRecord::new(center, 2.0, axis), axis, part)
    }

    #[test]
    fn computed_lambdas_decide_only_beyond_their_errors() {
        let error = LIMITS.lambda_error();
        assert!(is_certainly_closer(1.0, 1.0 + 2.0 * error) && !is_certainly_closer(1.0, 1.0 + error / 2.0));
        assert!(is_certainly_closer(5.0, f64::INFINITY) && !is_certainly_closer(f64::INFINITY, f64::INFINITY));
        assert!(!is_certainly_closer(f64::NAN, 1.0) && !is_certainly_closer(1.0, f64::NAN));
    }

    #[test]
    fn every_step_has_the_order_of_the_exact_lambdas() {
        let mut draws = Uniform::new(48);
        let mut orders = [0; 3];
        for _ in 0..3000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (direction, aside, target) = (vector(), vector() * 0.3, vector());
            let ray = Ray { origin: target - direction * 7.0, direction };
            let gap = [0.0, 2e-16, 1e-14, 1e-11][draws.draw(0.0, 4.0) as usize] * draws.draw(-1.0, 1.0).signum();
            let center = target + Vec3::new(aside.x, 0.0, aside.z);
            let straight = [(0.0, 2.0), (gap, draws.draw(0.5, 4.0))];
            let straight = straight.map(|(height, length)| cap(center, direction, height, length));
            let shells = [2.0, 2.0 - gap].map(|radius| Surface::Sphere(SphereRecord::new(target + aside, radius)));
            for hits in [straight, shells] {
                let hits = hits.each_ref();
                let order = compare(&ray, hits);
                assert_eq!(order, exactly(&ray, hits), "{ray:?}, {hits:?}");
                assert_eq!(order.map(Ordering::reverse), compare(&ray, [hits[1], hits[0]]));
                orders[(order.expect("all numbers are finite") as i8 + 1) as usize] += 1;
            }
        }
        assert!(orders.iter().all(|&count| count > 300), "{orders:?}");
    }
}
