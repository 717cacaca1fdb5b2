//! Intersects a ray with one object by the specification (section 9), and decides which of two hits is nearer.

use std::cmp::Ordering;

use crate::exact::order::Surface;
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::input::scene::{Cylinder, Shape, Sphere};
use crate::math::vec3::Vec3;
use crate::reference::intersect::Intersect;

/// A hit of a ray on an object: where it is, and where the surface faces there. It does not say which object is hit;
/// the caller keeps that object's material.
#[derive(Clone, Copy)]
pub(super) struct Hit {
    pub lambda: f64,
    pub point: Vec3,
    /// The normal that points out of the object.
    pub outward: Vec3,
    /// The part of a cylinder that is hit. It is the side for a sphere.
    pub part: CylinderPart,
}

impl Hit {
    /// Returns lambda and surface of the hit, which is on an object with this shape.
    pub(crate) fn lambda_and_surface(&self, shape: &Shape) -> (f64, Surface) {
        let surface = match *shape {
            Shape::Sphere(Sphere { center, radius }) => Surface::Sphere(SphereRecord::new(center, radius)),
            Shape::Cylinder(Cylinder { center, radius, axis }) => {
                Surface::Cylinder(CylinderRecord::new(center, radius, axis), axis, self.part)
            }
        };
        (self.lambda, surface)
    }
}

/// Whether a hit at `lambda` counts (specification, section 8.2). NaN never counts.
fn in_range(lambda: f64) -> bool {
    lambda >= 1e-3
}

/// Whether a hit replaces the nearest hit so far, if `order` is the order of the two lambdas. At the same lambda a
/// sphere and the side of a cylinder replace the nearest hit, and a cap does not (specification, section 8.2).
pub(super) fn is_nearer(hit: &Hit, order: Option<Ordering>) -> bool {
    order == Some(Ordering::Less) || order == Some(Ordering::Equal) && hit.part == CylinderPart::Side
}

/// Returns the hit with a sphere at the lambda that `P` returns, or `None` if there is no hit (specification, section
/// 9.1).
pub(super) fn sphere_by<P: Intersect>(sphere: &Sphere, ray: &Ray) -> Option<Hit> {
    let lambda = P::sphere(&SphereRecord::new(sphere.center, sphere.radius), ray).filter(|&lambda| in_range(lambda))?;
    let point = ray.origin + ray.direction * lambda;
    Some(Hit { lambda, point, outward: (point - sphere.center) / sphere.radius, part: CylinderPart::Side })
}

/// Returns the hit with a cylinder at the lambda and on the part that `P` returns (specification, sections 9.2 and
/// 9.3). If there is no hit, the result is `None`.
pub(super) fn cylinder_by<P: Intersect>(cylinder: &Cylinder, ray: &Ray) -> Option<Hit> {
    let record = CylinderRecord::new(cylinder.center, cylinder.radius, cylinder.axis);
    let (lambda, part) = P::cylinder(&record, &cylinder.axis, ray).filter(|&(lambda, _)| in_range(lambda))?;
    let (axis, _) = cylinder.axis.unit_and_length();
    let point = ray.origin + ray.direction * lambda;
    let outward = match part {
        CylinderPart::Side => (point - cylinder.center) - axis * (point - cylinder.center).dot(axis),
        CylinderPart::Top => axis,
        CylinderPart::Bottom => -axis,
    };
    Some(Hit { lambda, point, outward, part })
}

/// Returns the hit with a sphere by the plain formula, or `None` if the ray misses it.
pub(super) fn sphere(sphere: &Sphere, &Ray { origin, direction }: &Ray) -> Option<Hit> {
    let r_c = sphere.center - origin;
    let a = direction.dot(direction);
    let b = -2.0 * direction.dot(r_c);
    let c = r_c.dot(r_c) - sphere.radius * sphere.radius;
    let lambda = roots(a, b, c)?.into_iter().find(|&lambda| in_range(lambda))?;
    let point = origin + direction * lambda;
    Some(Hit { lambda, point, outward: (point - sphere.center) / sphere.radius, part: CylinderPart::Side })
}

/// Returns the hit with a cylinder by the plain formulas, or `None` if the ray misses it. The side is tested first,
/// then the upper cap, then the lower cap.
pub(super) fn cylinder(cylinder: &Cylinder, ray: &Ray) -> Option<Hit> {
    let (axis, height) = cylinder.axis.unit_and_length();
    let caps = [
        cap(cylinder, height, (axis, CylinderPart::Top), ray),
        cap(cylinder, height, (-axis, CylinderPart::Bottom), ray),
    ];
    let mut nearest = side(cylinder, height, axis, ray);
    for cap in caps.into_iter().flatten() {
        if nearest.is_none_or(|nearest| is_nearer(&cap, cap.lambda.partial_cmp(&nearest.lambda))) {
            nearest = Some(cap);
        }
    }
    nearest
}

fn side(cylinder: &Cylinder, height: f64, axis: Vec3, &Ray { origin, direction }: &Ray) -> Option<Hit> {
    let perpendicular = |vector: Vec3| vector - axis * vector.dot(axis);
    let r_c = perpendicular(origin - cylinder.center);
    let d = perpendicular(direction);
    let a = d.dot(d);
    let b = 2.0 * r_c.dot(d);
    let c = r_c.dot(r_c) - cylinder.radius * cylinder.radius;
    roots(a, b, c)?.into_iter().find_map(|lambda| {
        let point = origin + direction * lambda;
        let along = (point - cylinder.center).dot(axis);
        let outward = (point - cylinder.center) - axis * along;
        (in_range(lambda) && along.abs() <= height / 2.0).then_some(Hit {
            lambda,
            point,
            outward,
            part: CylinderPart::Side,
        })
    })
}

/// Returns the hit with one of the two caps, or `None` if the ray misses it. `normal` is the normal of this cap, which
/// points out of the cylinder, and `part` is its name.
fn cap(
    cylinder: &Cylinder,
    height: f64,
    (normal, part): (Vec3, CylinderPart),
    &Ray { origin, direction }: &Ray,
) -> Option<Hit> {
    let center = cylinder.center + normal * (height / 2.0);
    let normal_component = direction.dot(normal);
    if normal_component.abs() < 1e-8 {
        return None;
    }
    let lambda = (center - origin).dot(normal) / normal_component;
    let point = origin + direction * lambda;
    let is_hit = in_range(lambda) && (point - center).length() <= cylinder.radius;
    is_hit.then_some(Hit { lambda, point, outward: normal, part })
}

/// Returns the roots of `a x^2 + b x + c`, the smaller one first, or `None` if there is no real root.
fn roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some([-discriminant.sqrt(), discriminant.sqrt()].map(|root| (-b + root) / (2.0 * a)))
}
