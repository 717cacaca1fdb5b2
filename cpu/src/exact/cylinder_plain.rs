//! The plain formulas of a cylinder's side and caps, with bounds of their rounding errors. They give the
//! facts by which `decide` in `exact/cylinder_decision.rs` decides first. [`crate::geometry::cylinder`] has the
//! quadratic, and [`crate::exact::error_bound`] the bound.

use crate::exact::cylinder_decision::{
    CYLINDER_BOUND, CapFormulas, CapPlane, Crossing, SideFacts, SideFormulas, is_inside,
};
use crate::exact::error_bound::{ErrorBound, HEADROOM, Outcome};
use crate::geometry::{cylinder::CylinderRecord, cylinder::CylinderView, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// A ray runs enough across the axis for the side of a cylinder if `|d|^2` is at most this multiple of `k^2 |d'|^2`,
/// where `k` is the condition limit and `d'` the part of the direction `d` across the axis.
pub const SHARE_ACROSS_AXIS: f64 = 4.0;

/// The share of `|d|^2 (|O - C|^2 + r^2)` in the size of the discriminant of a long cylinder, 2^-44. It covers errors
/// of second order, and the error of the size itself if the ray starts farther away along the axis than 2^46 radii.
pub const SHARE_OF_WHOLE: f64 = f64::from_bits((1023 - 44) << 52);
/// Covers underflow in the square of the size of a long cylinder, 2^-350. A size above it has no product below 2^-1022.
pub const LEAST_SIZE: f64 = f64::from_bits((1023 - 350) << 52);

/// Whether a cylinder is long: rays may run nearly along its axis from one side to the other.
#[inline(always)]
pub fn is_long<T: Real>(record: &CylinderRecord<T>) -> T::Mask {
    (record.radius * T::of(8.0)).less(record.half_height)
}

/// Returns the size of the terms that cancel in the discriminant, times [`HEADROOM`]. The size is
/// `|d|^2 (|O - C|^2 + r^2)`. For a [long](is_long) cylinder it is `|d'| S (|d| S + |d'| |O - C|)`, or up to twice as
/// much, with `S^2 = |(O - C)'|^2 + r^2`, where the prime marks the parts across the axis. This is smaller if the ray
/// runs nearly along the axis.
#[inline(always)]
fn size<T: Rounding>(record: &CylinderRecord<T>, view: &CylinderView<T>, a: T, length_squared: T, is_long: bool) -> T {
    let whole = length_squared * (view.squares * T::of(HEADROOM));
    if !is_long {
        return whole;
    }
    let across = view.c + record.radius_squared + record.radius_squared;
    let product = a * (across * (length_squared * across + a * view.squares));
    (product + product).sqrt() * T::of(HEADROOM) + whole * T::of(SHARE_OF_WHOLE) + T::of(LEAST_SIZE * HEADROOM)
}

/// The side by the plain formulas: the quadratic `a lambda^2 + b lambda + c` of a ray and an infinite cylinder, with
/// the bound of its rounding errors.
pub struct PlainSide<'a, T: Real> {
    record: &'a CylinderRecord<T>,
    ray: &'a Ray<T>,
    bound: ErrorBound<T>,
    inside: T::Mask,
    a: T,
    /// Whether the relative error of `a` is smaller than that of an accepted lambda.
    a_is_accurate: T::Mask,
    /// Half of the linear coefficient, `b/2`.
    half_b: T,
    /// `(b/2)^2 - a c`, and its square root.
    discriminant: T,
    sqrt_d: T,
    /// `start_along` and `slope` of [`Crossing::new`].
    along_and_slope: [T; 2],
}

impl<'a, T: Rounding> PlainSide<'a, T> {
    /// Computes the quadratic. `view` has the cylinder's terms for the ray's origin.
    #[inline(always)]
    pub fn new(record: &'a CylinderRecord<T>, view: &CylinderView<T>, ray: &'a Ray<T>, is_long: bool) -> Self {
        let length_squared = ray.direction.dot(ray.direction);
        let (a, half_b, discriminant) = record.quadratic(view, ray.direction);
        let bound = ErrorBound::of_size(CYLINDER_BOUND, size(record, view, a, length_squared, is_long));
        let inside = is_inside(view);
        let along_and_slope = [view.along, ray.direction.dot(record.axis)];
        // If a ray is nearly parallel to the axis, the terms of `a` cancel.
        let condition = CYLINDER_BOUND.condition_limit;
        let a_is_accurate = length_squared.less_equal(a * T::of(SHARE_ACROSS_AXIS * condition * condition));
        let sqrt_d = discriminant.sqrt();
        Self { record, ray, bound, inside, a, a_is_accurate, half_b, discriminant, sqrt_d, along_and_slope }
    }
}

impl<T: Rounding> SideFormulas<T> for PlainSide<'_, T> {
    #[inline(always)]
    fn facts(&self) -> SideFacts<T> {
        let &Self { inside, a_is_accurate, discriminant, .. } = self;
        SideFacts { misses: self.bound.misses(discriminant), is_accurate: a_is_accurate, inside }
    }

    #[inline(always)]
    fn enters_behind(&self) -> bool
    where
        T: Rounding<Mask = bool>,
    {
        self.a_is_accurate & self.bound.is_too_small(self.a, -self.half_b - self.sqrt_d, self.sqrt_d)
    }

    #[inline(always)]
    fn crossing(&self, at_exit: bool) -> Crossing<T> {
        let &Self { record, ray, a, half_b, sqrt_d, .. } = self;
        let numerator = if at_exit { -half_b + sqrt_d } else { -half_b - sqrt_d };
        let Outcome { lambda, hits, fails } = self.bound.root(a, numerator, sqrt_d);
        let error_bound = lambda * T::of(2.0 * CYLINDER_BOUND.lambda_error());
        let [accurate, behind] = [hits, fails].map(|mask| self.a_is_accurate & mask);
        Crossing::new(record, ray, self.along_and_slope, (lambda, error_bound), accurate, behind)
    }
}

/// Planes by the plain formula.
pub struct PlainCaps;

impl<T: Rounding> CapFormulas<T> for PlainCaps {
    #[inline(always)]
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, _: T::Mask) -> CapPlane<T> {
        CapPlane::new(record, ray, center)
    }
}

impl<T: Rounding> CapPlane<T> {
    /// Returns the plane of the cap around `center`.
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>) -> Self {
        let to_center = center - ray.origin;
        Self::at(record, ray, center, (to_center.dot(record.axis), Self::size(record, to_center)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::uniform::Uniform;

    #[test]
    fn the_size_of_a_long_cylinder_is_once_to_twice_that_of_its_terms() {
        let mut draws = Uniform::new(5);
        for _ in 0..20_000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (center, axis, origin, off) = (vector(), vector(), vector() * 3.0, vector());
            // The ray runs along the axis, across it, or anywhere between.
            let direction = axis + off * 10.0_f64.powf(draws.draw(-6.0, 3.0));
            let record = CylinderRecord::new(center, 10.0_f64.powf(draws.draw(-3.0, 0.5)), axis);
            let view = record.seen_from(origin);
            let across = direction.perpendicular_to(record.axis).length();
            let a = across * across;
            let of = |is_long| size(&record, &view, a, direction.dot(direction), is_long) / HEADROOM;
            // `size` is `|d'| S (|d| S + |d'| |O - C|)`, and a share of `whole`, `|d|^2 (|O - C|^2 + r^2)`, is added.
            let (radius, from_center) = (record.radius, origin - center);
            let s = from_center.perpendicular_to(record.axis).length().hypot(radius);
            let size = across * s * (direction.length() * s + across * from_center.length());
            let whole = direction.length().powi(2) * from_center.length().hypot(radius).powi(2);
            let (least, most) = (0.999 * size + whole * SHARE_OF_WHOLE, 2.001 * size + whole * SHARE_OF_WHOLE * 1.001);
            assert!(of(true) >= least && of(true) <= most, "{} is not {least} to {most}: {record:?}", of(true));
            assert!((of(false) / whole - 1.0).abs() < 1e-12, "{} is not {whole}: {record:?}", of(false));
        }
    }
}
