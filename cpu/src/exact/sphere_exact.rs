//! Intersects ray and sphere without rounding, for rays that no other step can decide.
//!
//! The coefficients of the quadratic are sums of products of the inputs. So the coefficients, the discriminant and the
//! result of every comparison are exact. Only for the root itself they are rounded, to 106 bits each.

use crate::exact::exact_lambda::{ExactLambda, ExactQuadratic};
use crate::exact::exact_vector::{Exact3, Exactly, exact_least_lambda, to_dyadic};
use crate::geometry::{ray::Ray, sphere::SphereRecord};

/// Returns the exact lambda at which the ray hits the sphere, or `None` if it misses. The error says that an input is
/// not finite.
pub(crate) fn lambda(record: &SphereRecord, ray: &Ray) -> Exactly<ExactLambda> {
    let direction = Exact3::new(ray.direction)?;
    let to_center = Exact3::new(record.center)?.minus(&Exact3::new(ray.origin)?);
    let c = &to_center.dot(&to_center) - &to_dyadic(record.radius)?.squared();
    let least = exact_least_lambda()?;
    let quadratic = ExactQuadratic::with_roots(direction.dot(&direction), direction.dot(&to_center), c);
    Ok(quadratic.and_then(|quadratic| quadratic.smallest_root(|root| root.is_at_least(&least))))
}

/// Returns the rounded lambda at which the ray hits the sphere, or `None` if it misses. The error says that an input is
/// not finite.
pub(crate) fn intersect(record: &SphereRecord, ray: &Ray) -> Exactly<f64> {
    Ok(lambda(record, ray)?.map(|lambda| lambda.rounded()))
}
