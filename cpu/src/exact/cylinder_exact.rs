//! Ray against closed cylinder without rounding, for rays that nothing else can decide.
//!
//! With `V` the file's axis and `q = O - C`, everything is multiplied by `V.V` so that no unit vector is needed: the
//! side is `a lambda^2 - 2 h lambda + c = 0` with `a = |d x V|^2`, `h = -(q x V).(d x V)`, `c = |q x V|^2 - r^2 V.V`, a
//! point `P` is between the bases when `|(P - C).V| <= V.V / 2`, and the upper base's plane is `(P - C).V = V.V / 2`.

use std::cmp::Ordering;

use crate::exact::dyadic::{Dyadic, power_of_two};
use crate::exact::sphere_exact::{Exact3, NotFinite, Quadratic, exact};
use crate::geometry::cylinder::{CylinderPart, PARALLEL};
use crate::geometry::ray::{LAMBDA_MIN, Ray};
use crate::math::vec3::Vec3;

/// What side and bases share.
struct Setting {
    direction: Exact3,
    /// From the centre to the ray's origin.
    r_c: Exact3,
    axis: Exact3,
    radius_squared: Dyadic,
    /// Half of `V.V`.
    half: Dyadic,
    /// `d.V`.
    slope: Dyadic,
    /// `q.V`.
    height: Dyadic,
    /// [`LAMBDA_MIN`].
    least: Dyadic,
}

/// A base's lambda as a fraction; the denominator is positive.
struct Fraction {
    numerator: Dyadic,
    denominator: Dyadic,
}

/// Where the ray meets the cylinder.
pub fn intersect(center: Vec3, radius: f64, axis: Vec3, ray: &Ray) -> Result<Option<(f64, CylinderPart)>, NotFinite> {
    let (direction, axis) = (Exact3::new(ray.direction)?, Exact3::new(axis)?);
    let r_c = Exact3::new(ray.origin)?.minus(&Exact3::new(center)?);
    let (half, slope, height) = (axis.dot(&axis).scaled(-1), direction.dot(&axis), r_c.dot(&axis));
    let (radius_squared, least) = (exact(radius)?.squared(), exact(LAMBDA_MIN)?);
    let setting = Setting { direction, r_c, axis, radius_squared, half, slope, height, least };
    let side = setting.side();
    let (top, bottom) = (setting.base(false)?, setting.base(true)?);
    Ok(setting.nearest(side, top, bottom))
}

impl Setting {
    /// The side's quadratic, and whether the larger of its roots counts.
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

    /// Whether a root is in range and its point between the bases.
    fn side_counts(&self, quadratic: &Quadratic, larger: bool) -> bool {
        let Self { half, slope, height, least, .. } = self;
        quadratic.is_linear_form_positive(&-least, &Dyadic::one(), larger)
            && quadratic.is_linear_form_positive(&(half - height), &-slope, larger)
            && quadratic.is_linear_form_positive(&(half + height), slope, larger)
    }

    /// A base's lambda, if it counts.
    fn base(&self, lower: bool) -> Result<Option<Fraction>, NotFinite> {
        let Self { direction, r_c, axis, radius_squared, half, slope, height, least } = self;
        let parallel = &exact(PARALLEL)?.squared() * &half.scaled(1);
        if (&slope.squared() - &parallel).sign() == Ordering::Less {
            return Ok(None);
        }
        let signed_half = if lower { -half } else { half.clone() };
        let numerator = &signed_half - height;
        let (numerator, denominator) = match slope.sign() {
            Ordering::Less => (-&numerator, -slope),
            _ => (numerator, slope.clone()),
        };
        if (&numerator - &(least * &denominator)).sign() == Ordering::Less {
            return Ok(None);
        }
        // From the base's centre to the point, times the denominator.
        let reach = axis.times(&exact(if lower { -0.5 } else { 0.5 })?);
        let point = r_c.minus(&reach).times(&denominator).plus(&direction.times(&numerator));
        let outside = &point.dot(&point) - &(radius_squared * &denominator.squared());
        Ok((outside.sign() != Ordering::Greater).then_some(Fraction { numerator, denominator }))
    }

    /// The nearest surface; of equals the later.
    fn nearest(
        &self,
        side: Option<(Quadratic, bool)>,
        top: Option<Fraction>,
        bottom: Option<Fraction>,
    ) -> Option<(f64, CylinderPart)> {
        let side_is_nearer = |base: &Fraction| {
            side.as_ref().is_some_and(|(quadratic, larger)| {
                // lambda_base > lambda_side exactly when not (lambda_side - lambda_base >= 0).
                !quadratic.is_linear_form_positive(&-&base.numerator, &base.denominator, *larger)
            })
        };
        let top = top.filter(|top| !side_is_nearer(top));
        let bottom = bottom.filter(|bottom| !side_is_nearer(bottom)).filter(|bottom| {
            top.as_ref().is_none_or(|top| {
                let (upper, lower) = (&top.numerator * &bottom.denominator, &bottom.numerator * &top.denominator);
                (&lower - &upper).sign() != Ordering::Greater
            })
        });
        match (side, top, bottom) {
            (_, _, Some(bottom)) => Some((bottom.value(), CylinderPart::Bottom)),
            (_, Some(top), None) => Some((top.value(), CylinderPart::Top)),
            (Some((quadratic, larger)), None, None) => {
                Some((quadratic.root(larger).max(LAMBDA_MIN), CylinderPart::Side))
            }
            (None, None, None) => None,
        }
    }
}

impl Fraction {
    /// The nearest f64, or a neighbour.
    fn value(&self) -> f64 {
        let (numerator, upper) = self.numerator.to_part_and_power();
        let (denominator, lower) = self.denominator.to_part_and_power();
        power_of_two((numerator / denominator).high, upper - lower).max(LAMBDA_MIN)
    }
}
