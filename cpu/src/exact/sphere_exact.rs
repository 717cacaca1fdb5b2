//! Intersects ray and sphere without rounding, for rays that no other step can decide.
//!
//! The coefficients of the quadratic are sums of products of the inputs. So the coefficients, the discriminant and the
//! result of every comparison are exact. Only for the root itself they are rounded, to 106 bits each.

use crate::exact::exact_lambda::{ExactLambda, Quadratic};
use crate::geometry::{ray::HALF_STEP, ray::LAMBDA_MIN, ray::Ray, sphere::SphereRecord};
use crate::math::{dyadic::Dyadic, vec3::Vec3};

/// The error of a conversion: a number of the ray or of the object is infinite or NaN, so it has no exact value.
#[derive(Debug)]
pub struct NotFinite;

/// What exact arithmetic finds, or `None`.
pub(crate) type Exactly<R> = Result<Option<R>, NotFinite>;

/// A vector of three exact numbers.
pub struct Exact3([Dyadic; 3]);

impl Exact3 {
    /// Returns the vector without rounding.
    pub(crate) fn new(vector: Vec3) -> Result<Self, NotFinite> {
        let [x, y, z] = vector.to_array().map(exact);
        Ok(Self([x?, y?, z?]))
    }

    /// Returns the dot product.
    pub(crate) fn dot(&self, other: &Self) -> Dyadic {
        let [x, y, z] = [0, 1, 2].map(|index| &self.0[index] * &other.0[index]);
        &(&x + &y) + &z
    }

    /// Returns the difference.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|index| &self.0[index] - &other.0[index]))
    }

    /// Returns the sum.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|index| &self.0[index] + &other.0[index]))
    }

    /// Returns the product with a number.
    pub(crate) fn times(&self, factor: &Dyadic) -> Self {
        Self([0, 1, 2].map(|index| &self.0[index] * factor))
    }
}

/// Returns `value` as a dyadic number, without rounding.
pub(crate) fn exact(value: f64) -> Result<Dyadic, NotFinite> {
    Dyadic::new(value).ok_or(NotFinite)
}

/// Returns the smallest lambda of a hit that counts, without rounding. See [`HALF_STEP`].
pub(crate) fn least_lambda() -> Result<Dyadic, NotFinite> {
    Ok(&exact(LAMBDA_MIN)? - &exact(HALF_STEP)?)
}

/// Returns the exact lambda at which the ray hits the sphere, or `None` if it misses. The error says that an input is
/// not finite.
pub(crate) fn lambda(record: &SphereRecord, ray: &Ray) -> Exactly<ExactLambda> {
    let direction = Exact3::new(ray.direction)?;
    let r_c = Exact3::new(record.center)?.minus(&Exact3::new(ray.origin)?);
    let c = &r_c.dot(&r_c) - &exact(record.radius)?.squared();
    let least = least_lambda()?;
    let quadratic = Quadratic::with_roots(direction.dot(&direction), direction.dot(&r_c), c);
    Ok(quadratic.and_then(|quadratic| quadratic.smallest_root(|root| root.is_at_least(&least))))
}

/// Returns the rounded lambda at which the ray hits the sphere, or `None` if it misses. The error says that an input is
/// not finite.
pub(crate) fn intersect(record: &SphereRecord, ray: &Ray) -> Exactly<f64> {
    Ok(lambda(record, ray)?.map(|lambda| lambda.rounded()))
}
