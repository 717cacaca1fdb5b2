//! Intersects ray and cylinder by the [compensated formulas](crate::exact::compensated_roots), for the side and for the
//! planes of the caps. They serve rays that run nearly along the axis, start near a wide side or cap, or come from far
//! away.
//!
//! The plain formula subtracts the parts along the axis from the direction and from the vector to the ray's origin, and
//! its errors are relative to the whole vectors. The cross product with the axis `V` of the scene file has the part
//! across the axis at once. Its components are differences of two products, which Kahan's algorithm computes with a
//! relative error of 2 u (Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate
//! computation of 2 x 2 determinants", Math. Comp. 82, 2013). So the errors are relative to the parts across the axis.
//! The equation is multiplied by `V.V`, as in `exact/cylinder.rs`: with `q = (O - C) x V` and `p = d x V` it has
//! `a = p.p`, `h = -q.p` and `c = q.q - r^2 V.V`. By Lagrange's identity the discriminant equals
//! `V.V (a r^2 - ((O - C).p)^2)`, whose terms do not grow with the distance along the axis.

use crate::exact::compensated_roots::{
    Discriminant, Quadratic, Roots, certainly_in_range_and_finite, difference_of_squares,
};
use crate::exact::cylinder_decision::{CapFormulas, CapPlane, Crossing, SideFacts, SideFormulas, is_inside, magnitude};
use crate::exact::error_bound::in_scale;
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray};
use crate::math::error_free::{accurate_cross, cross_with_error, dot_with_error, two_product, vector_difference};
use crate::math::{rounding::Rounding, vec3::Vec3};

/// Covers the errors of a cap's lambda and of its point that are not those of the distance and of the slope, in units
/// of `u lambda |d|`.
pub const ROUNDINGS_OF_CAP: f64 = 16.0;
/// The share of `|O - C|^2` in the terms of `h`, 2^-90. It covers errors of second order in `(O - C) x V`, if the ray
/// starts farther away along the axis than 2^40 radii.
pub const SHARE_IN_H: f64 = f64::from_bits((1023 - 90) << 52);
/// The share of `|O - C|^2` in the terms of `c`.
pub const SHARE_IN_C: f64 = 4.0;
/// The share of `a |O - C|^2` in the terms of the discriminant by Lagrange's identity, 2^-52. It covers the square of
/// the error of `(O - C).p`.
pub const SHARE_IN_D: f64 = f64::EPSILON;

/// The quadratic of a ray and the side of a cylinder.
pub struct SideTerms<T: Rounding> {
    /// The coefficients.
    pub quadratic: Quadratic<T>,
    /// The discriminant by Lagrange's identity.
    pub far: Discriminant<T>,
    /// `O - C`, rounded.
    from_center: Vec3<T>,
    /// The numbers are [in scale](in_scale), so none of their products underflows or overflows.
    in_scale: T::Mask,
}

impl<T: Rounding> SideTerms<T> {
    /// Returns the quadratic. `file_axis` is the axis of the scene file.
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, file_axis: Vec3<T>, ray: &Ray<T>) -> Self {
        let (from_center, error) = vector_difference(ray.origin, record.center);
        let (q, rest) = cross_with_error((from_center, error), file_axis);
        let p = accurate_cross(ray.direction, file_axis);
        let (file_axis_squared, distance_squared) = (file_axis.dot(file_axis), from_center.dot(from_center));
        let a = p.dot(p);
        let (c, squares) = difference_of_squares((q, rest), radius_term(record.radius, file_axis));
        let q = q + rest;
        let whole = distance_squared * file_axis_squared;
        let size_of_h = (a * (squares + whole * T::of(SHARE_IN_H))).sqrt();
        let aside = from_center.dot(p) + error.dot(p);
        let (of_radius, of_distance) = (a * record.radius_squared, a * distance_squared);
        let size = of_radius + (aside.abs() * of_distance.sqrt() + of_distance * T::of(SHARE_IN_D));
        Self {
            quadratic: Quadratic { a, h: -q.dot(p), c, size_of_c: squares + whole * T::of(SHARE_IN_C), size_of_h },
            far: Discriminant {
                value: file_axis_squared * (of_radius - aside * aside),
                size: file_axis_squared * size,
            },
            from_center,
            in_scale: in_scale(file_axis_squared) & in_scale(a) & in_scale(squares),
        }
    }
}

/// The points where rays cross infinite cylinders.
pub struct CompensatedSide<'a, T: Rounding> {
    record: &'a CylinderRecord<T>,
    ray: &'a Ray<T>,
    terms: SideTerms<T>,
    /// What is certain about the two roots, if the numbers are in scale.
    roots: Roots<T>,
    facts: SideFacts<T>,
    /// The large root is where the line enters, and it is negative. Otherwise it is where the line leaves.
    backward: T::Mask,
}

impl<'a, T: Rounding> CompensatedSide<'a, T> {
    /// Computes the roots by the discriminant whose terms are smaller. `file_axis` is the axis of the scene file.
    #[inline(always)]
    pub fn new(record: &'a CylinderRecord<T>, file_axis: Vec3<T>, ray: &'a Ray<T>) -> Self {
        let terms = SideTerms::new(record, file_axis, ray);
        let (near, far) = (terms.quadratic.near(), &terms.far);
        let is_near = near.size.less(far.size);
        let [value, size] = [(near.value, far.value), (near.size, far.size)].map(|(a, b)| T::select(is_near, a, b));
        let roots = terms.quadratic.roots(Discriminant { value, size });
        let [misses, is_accurate] = [roots.misses, roots.accurate].map(|is_certain| terms.in_scale & is_certain);
        let [small_is_ahead, small_fails, large_fails] =
            [roots.small_is_ahead, roots.small_fails, roots.large_fails].map(|is_certain| is_accurate & is_certain);
        let roots = Roots { accurate: is_accurate, small_is_ahead, small_fails, large_fails, ..roots };
        let facts = SideFacts { misses, is_accurate, inside: is_inside(&record.seen_from(ray.origin)) };
        let backward = terms.quadratic.h.less(T::of(0.0));
        Self { record, ray, terms, roots, facts, backward }
    }
}

impl<T: Rounding> SideFormulas<T> for CompensatedSide<'_, T> {
    #[inline(always)]
    fn facts(&self) -> SideFacts<T> {
        self.facts
    }

    #[inline(always)]
    fn enters_behind(&self) -> bool
    where
        T: Rounding<Mask = bool>,
    {
        if self.backward { self.roots.large_fails } else { self.roots.small_fails }
    }

    #[inline(always)]
    fn crossing(&self, at_exit: bool) -> Crossing<T> {
        let &Self { record, ray, ref terms, ref roots, backward, .. } = self;
        let is_small = if at_exit { backward } else { !backward };
        let either = |yes: T::Mask, no: T::Mask| (is_small & yes) | (!is_small & no);
        let start = [terms.from_center.dot(record.axis), ray.direction.dot(record.axis)];
        let [small, large] = roots.magnitudes(&terms.quadratic);
        let [lambda, error_bound] = [(small.0, large.0), (small.1, large.1)].map(|(a, b)| T::select(is_small, a, b));
        let hits = either(roots.small_is_ahead, roots.accurate & !backward) & certainly_in_range_and_finite(lambda);
        Crossing::new(record, ray, start, (lambda, error_bound), hits, either(roots.small_fails, roots.large_fails))
    }
}

/// Returns `r^2 V.V`, rounded, and its rounding error, itself rounded.
#[inline(always)]
fn radius_term<T: Rounding>(radius: T, file_axis: Vec3<T>) -> (T, T) {
    let ((rr, rr_error), (sum, sum_error)) = (two_product(radius, radius), dot_with_error(file_axis, file_axis));
    let (product, error) = two_product(rr, sum);
    (product, error + (rr * sum_error + rr_error * sum))
}

/// The share of the size of the plain terms in the size of the distance of a plane, 2^-40. It covers the roundings of
/// rounding errors.
pub const SHARE_OF_SIZE: f64 = 1.0 / (1_u64 << 40) as f64;

/// Returns the plane of the cap around `center`. `file_axis` is the axis of the scene file, and `twice_to_cap` is the
/// axis or, for the bottom cap, its opposite.
#[inline(always)]
pub fn plane<T: Rounding>(
    record: &CylinderRecord<T>,
    file_axis: Vec3<T>,
    ray: &Ray<T>,
    center: Vec3<T>,
    twice_to_cap: Vec3<T>,
) -> CapPlane<T> {
    let (twice_to_center, error) = vector_difference(record.center + record.center, ray.origin + ray.origin);
    let (twice_to_cap_center, more) = vector_difference(twice_to_center, -twice_to_cap);
    let (error, two) = (error + more, T::of(2.0));
    let (sum, sum_error) = dot_with_error(twice_to_cap_center, file_axis);
    let to_plane = (sum + (sum_error + error.dot(file_axis))) / (record.half_height * (two + two));
    let size = to_plane.abs() + CapPlane::size(record, center - ray.origin) * T::of(SHARE_OF_SIZE);
    let plane = CapPlane::at(record, ray, center, (to_plane, size));
    // The errors of the distance and of the slope, twice each.
    let error_bound = size / to_plane.abs() * T::of(32.0 * T::UNIT_ROUNDOFF)
        + magnitude(ray.direction) / plane.slope.abs() * T::of(16.0 * T::UNIT_ROUNDOFF);
    let error_bound = error_bound + T::of(ROUNDINGS_OF_CAP * T::UNIT_ROUNDOFF);
    // The square of a short axis may underflow.
    let in_scale = in_scale(file_axis.dot(file_axis));
    CapPlane { error_bound, fails: plane.fails & in_scale, accurate: plane.accurate & in_scale, ..plane }
}

/// The caps by the compensated formula. This holds the axis of the scene file.
pub struct CompensatedCaps<T>(pub Vec3<T>);

impl<T: Rounding> CapFormulas<T> for CompensatedCaps<T> {
    #[inline(always)]
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, is_top: T::Mask) -> CapPlane<T> {
        plane(record, self.0, ray, center, Vec3::select(is_top, self.0, -self.0))
    }
}

/// Returns the lambda of the ray's hit on a part of the cylinder, with twice the bound of its error, or `None` if that
/// is uncertain. `file_axis` is the axis of the scene file.
#[inline(always)]
pub(crate) fn lambda(record: &CylinderRecord, file_axis: Vec3, ray: &Ray, part: CylinderPart) -> Option<(f64, f64)> {
    let (center, twice_to_cap) = match part {
        CylinderPart::Side => {
            let side = CompensatedSide::new(record, file_axis, ray);
            let (entry, exit) = (side.crossing(false), side.crossing(true));
            let crossing = if entry.hits { entry } else { exit };
            return (crossing.hits && (entry.hits || entry.fails())).then_some((crossing.lambda, crossing.error_bound));
        }
        CylinderPart::Top => (record.top, file_axis),
        CylinderPart::Bottom => (record.bottom, -file_axis),
    };
    let plane = plane(record, file_axis, ray, center, twice_to_cap);
    let lambda = plane.to_plane / plane.slope;
    plane.accurate.then_some((lambda, lambda * plane.error_bound))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{cylinder, error_bound::Decision};
    use crate::math::{double_double::DoubleDouble, real::Real};
    use crate::sampling::uniform::Uniform;

    /// Returns the lambda at which the ray meets the plane of the top cap, with 100 bits.
    fn lambda_of_top(center: Vec3, file_axis: Vec3, ray: &Ray) -> DoubleDouble {
        let wide = |vector: Vec3| vector.map(DoubleDouble::of);
        let two = |vector: Vec3| wide(vector + vector);
        let to_plane = (two(center) + wide(file_axis) - two(ray.origin)).dot(wide(file_axis));
        to_plane / two(ray.direction).dot(wide(file_axis))
    }

    #[test]
    fn the_lambda_of_a_cap_is_within_half_of_its_bound() {
        let (mut draws, mut certain, mut worst) = (Uniform::new(29), 0, 0.0_f64);
        for _ in 0..20_000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (center, file_axis, in_disc, off) = (vector() * 10.0, vector(), vector(), vector());
            let record = CylinderRecord::new(center, 1.0, file_axis);
            // The slope is from 1e-5 to 1, and the ray starts 0.01 to 100 directions before the cap.
            let slope = 10.0_f64.powf(draws.draw(-5.0, 0.0));
            let direction = off.perpendicular_to(record.axis).unit() + record.axis * slope;
            let target = record.top + in_disc.perpendicular_to(record.axis) * 0.5;
            let origin = target - direction * 10.0_f64.powf(draws.draw(-2.0, 2.0));
            let ray = Ray { origin, direction };
            let Some((lambda, error_bound)) = lambda(&record, file_axis, &ray, CylinderPart::Top) else { continue };
            let error = (lambda_of_top(center, file_axis, &ray) - DoubleDouble::of(lambda)).abs().high;
            assert!(error <= error_bound / 2.0, "{error:e} exceeds half of {error_bound:e}: {record:?}, {ray:?}");
            (certain, worst) = (certain + 1, worst.max(error / error_bound));
        }
        assert!(certain > 10_000 && worst > 0.01, "{certain}, {worst}");
    }

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
