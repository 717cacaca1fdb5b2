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

use crate::exact::exact_lambda::{ExactLambda, ExactQuadratic};
use crate::exact::exact_vector::{Exact3, Exactly, NotFinite, least_lambda, to_dyadic};
use crate::geometry::{cap::PARALLEL, cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray};
use crate::math::{dyadic::Dyadic, vec3::Vec3};

/// The inputs of the formulas of side and caps as exact numbers: a ray, a cylinder, and the products that both formulas
/// use.
struct Inputs {
    /// `d`: the ray's direction.
    direction: Exact3,
    /// `q`: the vector from the cylinder's centre to the ray's origin.
    from_center: Exact3,
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

/// Returns the rounded lambda and the part of the ray's hit with the cylinder, or `None` if it misses. `axis` is the
/// axis of the scene file, and its length is the cylinder's height. The error says that an input is not finite.
pub(crate) fn intersect(record: &CylinderRecord, axis: Vec3, ray: &Ray) -> Exactly<(f64, CylinderPart)> {
    let inputs = Inputs::new(record, axis, ray)?;
    let parts = [inputs.side(), inputs.cap(false)?, inputs.cap(true)?];
    Ok(closest_part(parts).map(|(lambda, part)| (lambda.rounded(), part)))
}

/// Returns the exact lambda of the ray's hit with a part of the cylinder, which it must hit. The other parameters and
/// the error are those of [`intersect`].
pub(crate) fn lambda(record: &CylinderRecord, axis: Vec3, ray: &Ray, part: CylinderPart) -> Exactly<ExactLambda> {
    let inputs = Inputs::new(record, axis, ray)?;
    if part == CylinderPart::Side {
        return Ok(inputs.side());
    }
    let (numerator, denominator) = inputs.plane(part == CylinderPart::Bottom);
    Ok(Some(ExactLambda::fraction(numerator, denominator)))
}

impl Inputs {
    fn new(&CylinderRecord { center, radius, .. }: &CylinderRecord, axis: Vec3, ray: &Ray) -> Result<Self, NotFinite> {
        let (direction, axis) = (Exact3::new(ray.direction)?, Exact3::new(axis)?);
        let from_center = Exact3::new(ray.origin)?.minus(&Exact3::new(center)?);
        let (half, slope, height) = (axis.dot(&axis).scaled(-1), direction.dot(&axis), from_center.dot(&axis));
        let (radius_squared, least) = (to_dyadic(radius)?.squared(), least_lambda()?);
        Ok(Self { direction, from_center, axis, radius_squared, half, slope, height, least })
    }

    /// Returns the side's lambda, or `None` if the ray misses the side.
    fn side(&self) -> Option<ExactLambda> {
        let length_squared = self.half.scaled(1);
        let flat = |product: Dyadic, along: Dyadic| &(&product * &length_squared) - &along;
        let a = flat(self.direction.dot(&self.direction), self.slope.squared());
        let h = flat(self.from_center.dot(&self.direction), &self.height * &self.slope);
        let c = flat(&self.from_center.dot(&self.from_center) - &self.radius_squared, self.height.squared());
        ExactQuadratic::with_roots(a, -&h, c)?.smallest_root(|root| self.side_counts(root))
    }

    /// Whether a root is in range, and its point is between the caps' planes.
    fn side_counts(&self, root: &ExactLambda) -> bool {
        let Self { half, slope, height, least, .. } = self;
        root.is_at_least(least)
            && root.is_linear_form_nonnegative(&(half - height), &-slope)
            && root.is_linear_form_nonnegative(&(half + height), slope)
    }

    /// Returns the lambda of a cap's plane as numerator and denominator. The denominator is not negative.
    fn plane(&self, is_bottom: bool) -> (Dyadic, Dyadic) {
        let Self { half, slope, height, .. } = self;
        let signed_half = if is_bottom { -half } else { half.clone() };
        let numerator = &signed_half - height;
        match slope.sign() {
            Ordering::Less => (-&numerator, -slope),
            _ => (numerator, slope.clone()),
        }
    }

    /// Returns a cap's lambda, or `None` if the ray misses the cap. The rule is that of [`crate::geometry::cap`].
    fn cap(&self, is_bottom: bool) -> Exactly<ExactLambda> {
        let Self { direction, from_center, axis, radius_squared, half, slope, least, .. } = self;
        let parallel = &to_dyadic(PARALLEL)?.squared() * &half.scaled(1);
        if (&slope.squared() - &parallel).sign() == Ordering::Less {
            return Ok(None);
        }
        let (numerator, denominator) = self.plane(is_bottom);
        if (&numerator - &(least * &denominator)).sign() == Ordering::Less {
            return Ok(None);
        }
        // `point` is the vector from the cap's centre to the ray's point, times the denominator.
        let to_cap = axis.times(&to_dyadic(if is_bottom { -0.5 } else { 0.5 })?);
        let point = from_center.minus(&to_cap).times(&denominator).plus(&direction.times(&numerator));
        let outside = &point.dot(&point) - &(radius_squared * &denominator.squared());
        Ok((outside.sign() != Ordering::Greater).then(|| ExactLambda::fraction(numerator, denominator)))
    }
}

/// Returns lambda and name of the closest part, or `None` if no part is hit. The parts come in the order side, top,
/// bottom. Of parts at the same lambda the first counts, because a cap does not replace what is at the same lambda
/// ([`crate::geometry::tie`]).
fn closest_part(parts: [Option<ExactLambda>; 3]) -> Option<(ExactLambda, CylinderPart)> {
    let names = [CylinderPart::Side, CylinderPart::Top, CylinderPart::Bottom];
    // Of equal elements, `min_by` returns the first.
    let hits = parts.into_iter().zip(names).filter_map(|(lambda, part)| Some((lambda?, part)));
    hits.min_by(|(left, _), (right, _)| left.compare(right))
}
