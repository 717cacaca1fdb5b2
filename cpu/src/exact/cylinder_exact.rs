//! Intersects ray and closed cylinder without rounding, for rays that no other step can decide.
//!
//! Let `O + lambda d` be the ray, `C` the cylinder's centre, `V` the axis of the scene file, and `q = O - C`. The
//! formulas are multiplied by `V.V`, so that they need no unit vector:
//!
//! - the side is `a lambda^2 - 2 h lambda + c = 0` with `a = |d x V|^2`, `h = -(q x V).(d x V)` and
//!   `c = |q x V|^2 - r^2 V.V`;
//! - a point `P` is between the caps if `|(P - C).V| <= V.V / 2`;
//! - the plane of the top cap is `(P - C).V = V.V / 2`.

use std::cmp::Ordering;

use crate::exact::{
    sphere_exact::Exact3, sphere_exact::NotFinite, sphere_exact::Quadratic, sphere_exact::exact,
    sphere_exact::least_lambda,
};
use crate::geometry::{cap::PARALLEL, cylinder::CylinderPart, ray::LAMBDA_MIN, ray::Ray};
use crate::math::{dyadic::Dyadic, dyadic::power_of_two, vec3::Vec3};

/// The inputs of the formulas of side and caps as exact numbers: a ray, a cylinder, and the products that both formulas
/// use.
struct Inputs {
    /// `d`: the ray's direction.
    direction: Exact3,
    /// `q`: the vector from the cylinder's centre to the ray's origin.
    r_c: Exact3,
    /// `V`: the axis of the scene file, which is as long as the cylinder is high.
    axis: Exact3,
    radius_squared: Dyadic,
    /// Half of `V.V`.
    half: Dyadic,
    /// `d.V`.
    slope: Dyadic,
    /// `q.V`.
    height: Dyadic,
    /// [`least_lambda`].
    least: Dyadic,
}

/// The lambda of a cap as a fraction. The denominator is positive.
struct Fraction {
    numerator: Dyadic,
    denominator: Dyadic,
}

/// Returns lambda and part of the ray's hit with the cylinder, or `None` if it misses. `axis` is the axis of the scene
/// file, and its length is the cylinder's height. The error says that an input is not finite.
pub fn intersect(center: Vec3, radius: f64, axis: Vec3, ray: &Ray) -> Result<Option<(f64, CylinderPart)>, NotFinite> {
    let (direction, axis) = (Exact3::new(ray.direction)?, Exact3::new(axis)?);
    let r_c = Exact3::new(ray.origin)?.minus(&Exact3::new(center)?);
    let (half, slope, height) = (axis.dot(&axis).scaled(-1), direction.dot(&axis), r_c.dot(&axis));
    let (radius_squared, least) = (exact(radius)?.squared(), least_lambda()?);
    let inputs = Inputs { direction, r_c, axis, radius_squared, half, slope, height, least };
    let side = inputs.side();
    let caps = [inputs.cap(false)?, inputs.cap(true)?];
    Ok(closest_part(side, caps))
}

impl Inputs {
    /// Returns the side's quadratic, and whether the hit is at its larger root. The result is `None` if the ray misses
    /// the side.
    fn side(&self) -> Option<(Quadratic, bool)> {
        let length_squared = self.half.scaled(1);
        let flat = |product: Dyadic, along: Dyadic| &(&product * &length_squared) - &along;
        let a = flat(self.direction.dot(&self.direction), self.slope.squared());
        let h = flat(self.r_c.dot(&self.direction), &self.height * &self.slope);
        let c = flat(&self.r_c.dot(&self.r_c) - &self.radius_squared, self.height.squared());
        let quadratic = Quadratic::with_roots(a, -&h, c)?;
        let larger = [false, true].into_iter().find(|&larger| self.side_counts(&quadratic, larger))?;
        Some((quadratic, larger))
    }

    /// Whether a root is in range, and its point is between the caps' planes. The root is the larger one if `larger` is
    /// set.
    fn side_counts(&self, quadratic: &Quadratic, larger: bool) -> bool {
        let Self { half, slope, height, least, .. } = self;
        quadratic.is_linear_form_positive(&-least, &Dyadic::one(), larger)
            && quadratic.is_linear_form_positive(&(half - height), &-slope, larger)
            && quadratic.is_linear_form_positive(&(half + height), slope, larger)
    }

    /// Returns a cap's lambda, or `None` if the ray misses the cap. The rule is that of [`crate::geometry::cap`].
    fn cap(&self, is_bottom: bool) -> Result<Option<Fraction>, NotFinite> {
        let Self { direction, r_c, axis, radius_squared, half, slope, height, least } = self;
        let parallel = &exact(PARALLEL)?.squared() * &half.scaled(1);
        if (&slope.squared() - &parallel).sign() == Ordering::Less {
            return Ok(None);
        }
        let signed_half = if is_bottom { -half } else { half.clone() };
        let numerator = &signed_half - height;
        let (numerator, denominator) = match slope.sign() {
            Ordering::Less => (-&numerator, -slope),
            _ => (numerator, slope.clone()),
        };
        if (&numerator - &(least * &denominator)).sign() == Ordering::Less {
            return Ok(None);
        }
        // `point` is the vector from the cap's centre to the ray's point, times the denominator.
        let to_cap = axis.times(&exact(if is_bottom { -0.5 } else { 0.5 })?);
        let point = r_c.minus(&to_cap).times(&denominator).plus(&direction.times(&numerator));
        let outside = &point.dot(&point) - &(radius_squared * &denominator.squared());
        Ok((outside.sign() != Ordering::Greater).then_some(Fraction { numerator, denominator }))
    }
}

/// Returns lambda and name of the closest part, or `None` if no part is hit. Of parts at the same lambda, the first in
/// the order side, top, bottom counts, because a cap does not replace what is at the same lambda
/// ([`crate::geometry::tie`]).
fn closest_part(side: Option<(Quadratic, bool)>, [top, bottom]: [Option<Fraction>; 2]) -> Option<(f64, CylinderPart)> {
    let before_side = |cap: &Fraction| {
        side.as_ref().is_none_or(|(quadratic, larger)| {
            // The cap is closer if `lambda_cap - lambda_side` is not at least 0.
            !quadratic.is_linear_form_positive(&cap.numerator, &-&cap.denominator, *larger)
        })
    };
    let top = top.filter(before_side);
    let bottom = bottom.filter(|bottom| before_side(bottom) && top.as_ref().is_none_or(|top| bottom.is_below(top)));
    match (side, top, bottom) {
        (_, _, Some(bottom)) => Some((bottom.value(), CylinderPart::Bottom)),
        (_, Some(top), None) => Some((top.value(), CylinderPart::Top)),
        (Some((quadratic, larger)), None, None) => Some((quadratic.root(larger).max(LAMBDA_MIN), CylinderPart::Side)),
        (None, None, None) => None,
    }
}

impl Fraction {
    fn is_below(&self, other: &Self) -> bool {
        let (left, right) = (&self.numerator * &other.denominator, &other.numerator * &self.denominator);
        (&left - &right).sign() == Ordering::Less
    }

    /// Returns the nearest `f64` or a neighbour of it, but at least [`LAMBDA_MIN`].
    fn value(&self) -> f64 {
        let (numerator, upper) = self.numerator.to_part_and_power();
        let (denominator, lower) = self.denominator.to_part_and_power();
        power_of_two((numerator / denominator).high, upper - lower).max(LAMBDA_MIN)
    }
}
