//! Intersects ray and sphere without rounding, for rays that no other step can decide.
//!
//! The coefficients of the quadratic are sums of products of the inputs. So the coefficients, the discriminant and the
//! result of every comparison are exact. Only for the root itself they are rounded, to 106 bits each.

use std::cmp::Ordering;

use crate::geometry::{ray::HALF_STEP, ray::LAMBDA_MIN, ray::Ray, sphere::SphereRecord};
use crate::math::dyadic::{Dyadic, power_of_two, sign_with_root};
use crate::math::{double_double::DoubleDouble, real::Real, vec3::Vec3};

/// The error of a conversion: a number of the ray or of the object is infinite or NaN, so it has no exact value.
#[derive(Debug)]
pub struct NotFinite;

/// A vector of three exact numbers.
pub struct Exact3([Dyadic; 3]);

impl Exact3 {
    pub fn new(vector: Vec3) -> Result<Self, NotFinite> {
        let [x, y, z] = vector.to_array().map(exact);
        Ok(Self([x?, y?, z?]))
    }

    pub fn dot(&self, other: &Self) -> Dyadic {
        let [x, y, z] = [0, 1, 2].map(|index| &self.0[index] * &other.0[index]);
        &(&x + &y) + &z
    }

    pub fn minus(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|index| &self.0[index] - &other.0[index]))
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|index| &self.0[index] + &other.0[index]))
    }

    pub fn times(&self, factor: &Dyadic) -> Self {
        Self([0, 1, 2].map(|index| &self.0[index] * factor))
    }
}

/// Returns `value` as a dyadic number, without rounding.
pub fn exact(value: f64) -> Result<Dyadic, NotFinite> {
    Dyadic::new(value).ok_or(NotFinite)
}

/// Returns the smallest lambda of a hit that counts, without rounding. See [`HALF_STEP`].
pub fn least_lambda() -> Result<Dyadic, NotFinite> {
    Ok(&exact(LAMBDA_MIN)? - &exact(HALF_STEP)?)
}

/// The equation `a lambda^2 - 2 h lambda + c = 0` with real roots: `a > 0`, and the discriminant `h^2 - a c` is at
/// least 0.
pub struct Quadratic {
    pub a: Dyadic,
    pub h: Dyadic,
    pub c: Dyadic,
    pub discriminant: Dyadic,
}

impl Quadratic {
    /// Returns the equation with these coefficients. The result is `None` if it has no real root, so that the ray's
    /// line misses the surface. It is also `None` if `a` is not positive, so that the direction is null.
    pub fn with_roots(a: Dyadic, h: Dyadic, c: Dyadic) -> Option<Self> {
        let discriminant = &h.squared() - &(&a * &c);
        let real = a.sign() == Ordering::Greater && discriminant.sign() != Ordering::Less;
        real.then_some(Self { a, h, c, discriminant })
    }

    /// Whether `x + y lambda >= 0`, where lambda is the larger root if `larger` is set, and else the smaller root.
    pub fn is_linear_form_positive(&self, x: &Dyadic, y: &Dyadic, larger: bool) -> bool {
        // The form is multiplied by `a`, which is positive. The result is `a x + y h -+ y sqrt(D)`.
        let root = if larger { y.clone() } else { -y };
        sign_with_root(&(&(&self.a * x) + &(y * &self.h)), &root, &self.discriminant) != Ordering::Less
    }

    /// Returns the `f64` nearest to a root, or a neighbour of it. The root is the larger one if `larger` is set.
    pub fn root(&self, larger: bool) -> f64 {
        // f64 must not overflow. So h and sqrt(D) are scaled by a common power of two, and a and c by powers of their
        // own. A zero has no order, so it does not change the common power. If h and D are both zero, the root is zero
        // with any power.
        let root_order = self.discriminant.order().map(|order| (order + 1).div_euclid(2));
        let scale = self.h.order().max(root_order).unwrap_or(0);
        let h = self.h.scaled(-scale).to_double_double();
        let root = self.discriminant.scaled(-2 * scale).to_double_double().sqrt();
        let (sum, root_is_added) = if h.less(DoubleDouble::of(0.0)) { (h - root, false) } else { (h + root, true) };
        // The numerator of one root does not cancel. The other root follows from the product of both, c / a.
        let (quotient, power) = if root_is_added == larger {
            let (a, order) = self.a.to_part_and_power();
            (sum / a, scale - order)
        } else {
            let (c, order) = self.c.to_part_and_power();
            (c / sum, order - scale)
        };
        power_of_two(quotient.high, power)
    }
}

/// Returns the lambda at which the ray hits the sphere, or `None` if it misses. The error says that an input is not
/// finite.
pub fn intersect(record: &SphereRecord, ray: &Ray) -> Result<Option<f64>, NotFinite> {
    let direction = Exact3::new(ray.direction)?;
    let r_c = Exact3::new(record.center)?.minus(&Exact3::new(ray.origin)?);
    let c = &r_c.dot(&r_c) - &exact(record.radius)?.squared();
    let Some(quadratic) = Quadratic::with_roots(direction.dot(&direction), direction.dot(&r_c), c) else {
        return Ok(None);
    };
    let (least, one) = (-&least_lambda()?, Dyadic::one());
    let root = [false, true].into_iter().find(|&larger| quadratic.is_linear_form_positive(&least, &one, larger));
    Ok(root.map(|larger| quadratic.root(larger).max(LAMBDA_MIN)))
}
