//! Decides which of two hits of a ray is closer: the one with the smaller exact lambda. This is the second file of the
//! answer that `accel/closest_hit.rs` begins.
//!
//! The computed lambdas have errors, so they decide only if they are further apart than their errors
//! ([`is_certainly_closer`]). If they are not, [`compare`] takes these steps:
//! 1. Identical surfaces tie, and so do two caps in one plane whose axes are along one coordinate axis, or equal or
//!    opposite if their centres differ in no coordinate in which the axis has a part. Other caps are compared in
//!    [double-double](DoubleDouble) arithmetic. Rays often meet two near caps: inside a cylinder that stands on another
//!    one, or on nested cylinders.
//! 2. Spheres around one centre, and sides around one axis (with one centre, or along a coordinate axis), are compared
//!    by their radii ([`compare_nested`]). Such shells may be so near to each other that only exact lambdas differ.
//! 3. Both lambdas are computed by the [compensated](crate::exact::compensated_roots) formulas, with a bound of their
//!    errors that is mostly a thousandth of the one of all accepted lambdas.
//! 4. The exact lambdas are compared in dyadic arithmetic, without a square root. Only this step recognises equal
//!    lambdas of other surfaces.
//!
//! A tie, of two equal lambdas, is decided by [`geometry::tie`](crate::geometry::tie).

use std::cmp::Ordering;

use crate::counters::{Counter, add};
use crate::exact::{
    cylinder, cylinder_compensated, cylinder_decision::CYLINDER_BOUND, cylinder_decision::magnitude,
    error_bound::UNDERFLOW, exact_lambda::ExactLambda, exact_vector::ExactResult, sphere, sphere_compensated,
};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::math::{double_double::DoubleDouble, error_free::two_sum, real::Real, rounding::Rounding, vec3::Vec3};
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
/// most a third of the [`lambda_error`](crate::exact::error_bound::BoundConstants::lambda_error) of cylinders, which
/// exceeds that of spheres. The result is false if a number is NaN.
#[inline(always)]
pub fn is_certainly_closer<T: Rounding>(lambda: T, other: T) -> T::Mask {
    // The factor is 1 + 2^-29 or 1 + 2^-54, which `T` holds without an error.
    (lambda * (T::of(1.0) + T::of(CYLINDER_BOUND.lambda_error()))).less(other)
}

/// Compares the exact lambdas of a ray's hits on two surfaces, which it must hit. `lambdas` are those that the steps of
/// [`crate::exact`] accept. The result is `None` if the exact lambdas are needed, and a number is not finite.
pub(crate) fn compare(ray: &Ray, surfaces: [&Surface; 2], lambdas: [f64; 2]) -> Option<Ordering> {
    add(Counter::NearHits, 1);
    if surfaces[0] == surfaces[1] {
        return Some(Ordering::Equal);
    }
    if let [Some(left), Some(right)] = surfaces.map(Surface::cap)
        && let Some(order) = compare_caps(ray, &left, &right)
    {
        return Some(order);
    }
    if let Some(order) = compare_nested(ray, surfaces, lambdas) {
        return Some(order);
    }
    if let [Some(left), Some(right)] = surfaces.map(|surface| surface.lambda_interval(ray)) {
        if left[1] < right[0] {
            return Some(Ordering::Less);
        }
        if right[1] < left[0] {
            return Some(Ordering::Greater);
        }
    }
    add(Counter::NearHitsExactly, 1);
    compare_exactly(ray, surfaces)
}

/// Compares in dyadic arithmetic only, with the result of [`compare`].
pub(crate) fn compare_exactly(ray: &Ray, surfaces: [&Surface; 2]) -> Option<Ordering> {
    let [left, right] = surfaces.map(|surface| surface.exact_lambda(ray).ok().flatten());
    Some(left?.compare(&right?))
}

/// A point, or a vector, of numbers with 106 bits.
type Wide3 = Vec3<DoubleDouble>;

/// A cap of a cylinder.
struct Cap {
    /// Twice the centre, without a rounding error. A coordinate has no meaning if its sum overflows.
    twice_center: Wide3,
    /// The cylinder's axis in the scene file.
    file_axis: Vec3,
}

impl Cap {
    /// Whether both caps certainly are in one plane.
    fn is_in_plane_of(&self, other: &Self) -> bool {
        let (normal, apart) = (normal(self.file_axis), self.twice_center - other.twice_center);
        let is_zero = |component: DoubleDouble, factor: f64| component.high == 0.0 || factor == 0.0;
        let is_across = is_zero(apart.x, normal.x) && is_zero(apart.y, normal.y) && is_zero(apart.z, normal.z);
        is_across && normal == self::normal(other.file_axis)
    }
}

/// Bounds the error of the difference of two products of dot products, relative to the sizes of their terms: 2^-90.
/// Axes that a scene file may have, of 1e-161 and more, do not make the rounding errors of these products underflow.
pub const ERROR_OF_CAP_ORDER: f64 = f64::from_bits((1023 - 90) << 52);

/// Compares the lambdas of a ray's hits on two caps. The result is `None` if it is uncertain.
fn compare_caps(ray: &Ray, left: &Cap, right: &Cap) -> Option<Ordering> {
    if left.is_in_plane_of(right) {
        return Some(Ordering::Equal);
    }
    run_fused!(|ray: &Ray, left: &Cap, right: &Cap| -> Option<Ordering> {
        // A lambda is the quotient of the magnitudes of two dot products, the distance and the slope.
        let (origin, direction) =
            ((ray.origin + ray.origin).map(DoubleDouble::of), ray.direction.map(DoubleDouble::of));
        let (distance, size) = dot_magnitude(left.twice_center - origin, left.file_axis);
        let (slope, size_of_slope) = dot_magnitude(direction, left.file_axis);
        let (other_distance, other_size) = dot_magnitude(right.twice_center - origin, right.file_axis);
        let (other_slope, other_size_of_slope) = dot_magnitude(direction, right.file_axis);
        let difference = (distance * other_slope - other_distance * slope).high;
        let size = size * other_size_of_slope + other_size * size_of_slope;
        (difference.abs() > size * ERROR_OF_CAP_ORDER + UNDERFLOW).then(|| difference.total_cmp(&0.0))
    })
}

/// Returns the magnitude of the dot product of a vector and an axis, and the sum of the magnitudes of its terms.
#[inline(always)]
fn dot_magnitude(vector: Wide3, axis: Vec3) -> (DoubleDouble, f64) {
    let Vec3 { x, y, z } = vector.attenuate(axis.map(DoubleDouble::of));
    ((x + y + z).abs(), x.high.abs() + y.high.abs() + z.high.abs())
}

/// Compares the lambdas of a ray's hits on two spheres with one centre, or on the sides of two cylinders around one
/// axis. The result is `None` for other surfaces, and if it is uncertain whether the ray enters or leaves a surface.
///
/// The equations `a lambda^2 - 2 h lambda + c = 0` of both surfaces differ only in `c`, which is smaller for the larger
/// radius. A ray enters at the smaller root, which is below `h / a`, and leaves at the larger root, which is above. So
/// an entry is before each exit, and the larger radius has the earlier entry and the later exit.
fn compare_nested(ray: &Ray, surfaces: [&Surface; 2], lambdas: [f64; 2]) -> Option<Ordering> {
    let [left, right] = match surfaces {
        [Surface::Sphere(left), Surface::Sphere(right)] if left.center == right.center => [left.radius, right.radius],
        [
            &Surface::Cylinder(ref left, file_axis, CylinderPart::Side),
            &Surface::Cylinder(ref right, other_file_axis, CylinderPart::Side),
        ] if is_on_one_line((left.center, file_axis), (right.center, other_file_axis)) => [left.radius, right.radius],
        _ => return None,
    };
    let are_exits = [surfaces[0].is_left_at(lambdas[0], ray)?, surfaces[1].is_left_at(lambdas[1], ray)?];
    match are_exits {
        [false, true] => Some(Ordering::Less),
        [true, false] => Some(Ordering::Greater),
        [false, false] => right.partial_cmp(&left),
        [true, true] => left.partial_cmp(&right),
    }
}

/// Whether two axes, each through a point, certainly lie on one line.
fn is_on_one_line((point, axis): (Vec3, Vec3), (other, other_axis): (Vec3, Vec3)) -> bool {
    let (along, apart) = (normal(axis), point - other);
    let is_coordinate_axis = along.to_array().into_iter().filter(|&component| component != 0.0).count() == 1;
    let is_zero = |apart: f64, along: f64| apart == 0.0 || (is_coordinate_axis && along != 0.0);
    let is_through_both = is_zero(apart.x, along.x) && is_zero(apart.y, along.y) && is_zero(apart.z, along.z);
    is_through_both && along == normal(other_axis)
}

/// Returns a vector along an axis. It is the same for two axes if they lie along the same coordinate axis, or if one is
/// the other or its opposite.
fn normal(axis: Vec3) -> Vec3 {
    let mut components = axis.to_array().into_iter().filter(|&component| component != 0.0);
    match (components.next(), components.next()) {
        (_, None) => axis.map(|component| if component == 0.0 { 0.0 } else { 1.0 }),
        (first, _) => axis * first.map_or(1.0, f64::signum),
    }
}

impl Surface {
    /// Whether the ray certainly leaves the surface, a sphere or a side, at `lambda`, where it hits it. The result is
    /// `None` if it may touch the surface.
    ///
    /// The direction's part along the outward normal decides. Its error is that of lambda, which is below
    /// a third of `lambda_error`, and some 20 roundings, each relative to the sizes of the vectors.
    fn is_left_at(&self, lambda: f64, ray: &Ray) -> Option<bool> {
        let (center, axis) = match self {
            Self::Sphere(record) => (record.center, Vec3::ZERO),
            Self::Cylinder(record, ..) => (record.center, record.axis),
        };
        let (from_center, way) = (ray.origin - center, ray.direction * lambda);
        let outward = (from_center + way).perpendicular_to(axis).dot(ray.direction);
        let size = magnitude(ray.direction) * (magnitude(from_center) + magnitude(way));
        let is_certain = size * CYLINDER_BOUND.lambda_error() + UNDERFLOW < outward.abs();
        (is_certain && size < f64::INFINITY).then_some(outward > 0.0)
    }

    /// Returns the cap, or `None` for all other surfaces.
    fn cap(&self) -> Option<Cap> {
        let &Self::Cylinder(CylinderRecord { center, .. }, file_axis, part) = self else { return None };
        let to_cap = match part {
            CylinderPart::Side => return None,
            CylinderPart::Top => file_axis,
            CylinderPart::Bottom => -file_axis,
        };
        // A double is exact, but a half may underflow.
        let sum = |center: f64, to_cap: f64| {
            let (high, low) = two_sum(center + center, to_cap);
            DoubleDouble { high, low }
        };
        let twice_center = Vec3::new(sum(center.x, to_cap.x), sum(center.y, to_cap.y), sum(center.z, to_cap.z));
        Some(Cap { twice_center, file_axis })
    }

    /// Returns bounds of the lambda of the ray's hit by the compensated formulas, or `None` if they are uncertain.
    fn lambda_interval(&self, ray: &Ray) -> Option<[f64; 2]> {
        let surface = self;
        let (lambda, error_bound) = run_fused!(|surface: &Surface, ray: &Ray| -> Option<(f64, f64)> {
            match surface {
                Surface::Sphere(record) => sphere_compensated::lambda(record, ray),
                Surface::Cylinder(record, file_axis, part) => {
                    cylinder_compensated::lambda(record, *file_axis, ray, *part)
                }
            }
        })?;
        Some([lambda - error_bound, lambda + error_bound])
    }

    /// Returns the exact lambda of the surface.
    fn exact_lambda(&self, ray: &Ray) -> ExactResult<ExactLambda> {
        match self {
            Self::Sphere(record) => sphere::exact_lambda(record, ray),
            Self::Cylinder(record, file_axis, part) => cylinder::exact_lambda(record, *file_axis, ray, *part),
        }
    }
}

#[cfg(test)]
mod tests;
