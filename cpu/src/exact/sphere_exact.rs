//! Intersects ray and sphere without rounding, for rays that no other step can decide.
//!
//! The coefficients of the quadratic are sums of products of the inputs. So the coefficients, the discriminant and the
//! result of every comparison are exact. Only for the root itself they are rounded, to 106 bits each.

use crate::exact::exact_lambda::{ExactLambda, Quadratic};
use crate::geometry::{ray::HALF_STEP, ray::LAMBDA_MIN, ray::Ray, sphere::SphereRecord};
use crate::math::{dyadic::Dyadic, dyadic::exact, vec3::Vec3};

/// A vector of three exact numbers.
pub struct Exact3([Dyadic; 3]);

impl Exact3 {
    /// Returns the vector without rounding, or `None` if a component is infinite or NaN.
    pub fn new(vector: Vec3) -> Option<Self> {
        let [x, y, z] = vector.to_array().map(Dyadic::new);
        Some(Self([x?, y?, z?]))
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

/// Returns the smallest lambda of a hit that counts, without rounding. See [`HALF_STEP`].
pub fn least_lambda() -> Dyadic {
    &exact(LAMBDA_MIN) - &exact(HALF_STEP)
}

/// Returns the exact lambda at which the ray hits the sphere, or `Some(None)` if it misses. The result is `None` if an
/// input is not finite.
pub fn lambda(record: &SphereRecord, ray: &Ray) -> Option<Option<ExactLambda>> {
    let direction = Exact3::new(ray.direction)?;
    let r_c = Exact3::new(record.center)?.minus(&Exact3::new(ray.origin)?);
    let c = &r_c.dot(&r_c) - &Dyadic::new(record.radius)?.squared();
    let quadratic = Quadratic::with_roots(direction.dot(&direction), direction.dot(&r_c), c);
    let least = least_lambda();
    Some(quadratic.and_then(|quadratic| quadratic.smallest_root(|root| root.is_at_least(&least))))
}

/// Returns [`lambda`], rounded.
pub fn intersect(record: &SphereRecord, ray: &Ray) -> Option<Option<f64>> {
    Some(lambda(record, ray)?.map(|lambda| lambda.rounded()))
}
