//! Vectors of exact numbers, and what the exact intersections of spheres and cylinders share.

use crate::geometry::{ray::HALF_STEP, ray::LAMBDA_MIN};
use crate::math::{dyadic::Dyadic, vec3::Vec3};

/// The error of a conversion: a number of the ray or of the object is infinite or NaN, so it has no exact value.
#[derive(Debug)]
pub struct NotFinite;

/// What exact arithmetic finds, or `None`.
pub(crate) type ExactResult<R> = Result<Option<R>, NotFinite>;

/// A vector of three exact numbers.
pub struct Exact3([Dyadic; 3]);

impl Exact3 {
    /// Returns the vector without rounding.
    pub(crate) fn new(vector: Vec3) -> Result<Self, NotFinite> {
        let [x, y, z] = vector.to_array().map(to_dyadic);
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
pub(crate) fn to_dyadic(value: f64) -> Result<Dyadic, NotFinite> {
    Dyadic::new(value).ok_or(NotFinite)
}

/// Returns the smallest lambda of a hit that counts, without rounding. See [`HALF_STEP`].
pub(crate) fn exact_least_lambda() -> Result<Dyadic, NotFinite> {
    Ok(&to_dyadic(LAMBDA_MIN)? - &to_dyadic(HALF_STEP)?)
}
