//! Intersects a ray with one object by the specification (section 9), and decides which of two hits is nearer.

use std::cmp::Ordering;

use crate::geometry::{cylinder::CylinderPart, ray::Ray};
use crate::math::vec3::Vec3;

/// Whether a hit at `lambda` counts (specification, section 8.2). NaN never counts.
pub(super) fn in_range(lambda: f64) -> bool {
    lambda >= 1e-3
}

/// Whether a hit replaces the nearest hit so far, if `order` is the order of the two lambdas. At the same lambda a
/// sphere and the side of a cylinder replace the nearest hit, and a cap does not (specification, section 8.2).
pub(super) fn is_nearer(is_on_cap: bool, order: Option<Ordering>) -> bool {
    order == Some(Ordering::Less) || order == Some(Ordering::Equal) && !is_on_cap
}

/// Returns the lambda of the hit with a sphere by the plain formula, or `None` if the ray misses it.
pub(super) fn sphere(center: Vec3, radius: f64, &Ray { origin, direction }: &Ray) -> Option<f64> {
    let r_c = center - origin;
    let a = direction.dot(direction);
    let b = -2.0 * direction.dot(r_c);
    let c = r_c.dot(r_c) - radius * radius;
    roots(a, b, c)?.into_iter().find(|&lambda| in_range(lambda))
}

/// Returns lambda and part of the hit with a cylinder by the plain formulas, or `None` if the ray misses it. The side
/// is tested first, then the upper cap, then the lower cap.
pub(super) fn cylinder(center: Vec3, radius: f64, axis: Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    let (axis, height) = axis.unit_and_length();
    let mut nearest = side(center, radius, (axis, height), ray).map(|lambda| (lambda, CylinderPart::Side));
    for (normal, part) in [(axis, CylinderPart::Top), (-axis, CylinderPart::Bottom)] {
        if let Some(lambda) = cap(center + normal * (height / 2.0), normal, radius, ray)
            && nearest.is_none_or(|(nearest, _)| is_nearer(true, lambda.partial_cmp(&nearest)))
        {
            nearest = Some((lambda, part));
        }
    }
    nearest
}

/// Returns the least lambda above the limit at which the ray hits the side of the cylinder.
fn side(center: Vec3, radius: f64, (axis, height): (Vec3, f64), &Ray { origin, direction }: &Ray) -> Option<f64> {
    let perpendicular = |vector: Vec3| vector - axis * vector.dot(axis);
    let r_c = perpendicular(origin - center);
    let d = perpendicular(direction);
    let a = d.dot(d);
    let b = 2.0 * r_c.dot(d);
    let c = r_c.dot(r_c) - radius * radius;
    roots(a, b, c)?.into_iter().find(|&lambda| {
        let along = (origin + direction * lambda - center).dot(axis);
        in_range(lambda) && along.abs() <= height / 2.0
    })
}

/// Returns the lambda of the hit with one of the two caps, or `None` if the ray misses it. `normal` is the normal of
/// this cap, which points out of the cylinder.
fn cap(center: Vec3, normal: Vec3, radius: f64, &Ray { origin, direction }: &Ray) -> Option<f64> {
    let normal_component = direction.dot(normal);
    if normal_component.abs() < 1e-8 {
        return None;
    }
    let lambda = (center - origin).dot(normal) / normal_component;
    let point = origin + direction * lambda;
    (in_range(lambda) && (point - center).length() <= radius).then_some(lambda)
}

/// Returns the roots of `a x^2 + b x + c`, the smaller one first, or `None` if there is no real root.
fn roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some([-discriminant.sqrt(), discriminant.sqrt()].map(|root| (-b + root) / (2.0 * a)))
}
