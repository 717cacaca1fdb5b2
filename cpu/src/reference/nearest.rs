//! Where a ray meets one object after the other, by the definition: the nearest hit so far counts.

use crate::geometry::cylinder::{CylinderPart, CylinderRecord};
use crate::geometry::ray::Ray;
use crate::geometry::sphere::SphereRecord;
use crate::input::scene::{Cylinder, Sphere};
use crate::math::vec3::Vec3;
use crate::reference::intersect::Intersect;

/// A ray's nearest hit so far.
pub(super) struct Nearest {
    pub lambda: f64,
    pub point: Vec3,
    /// The normal that leaves the object.
    pub outward: Vec3,
}

/// Whether `lambda` is in range and not farther than the nearest so far. Not a number is neither.
fn counts(lambda: f64, nearest: &Nearest) -> bool {
    lambda >= 1e-3 && lambda <= nearest.lambda
}

/// The certified intersection, with the normal (specification, section 9.1).
pub(super) fn meets_certified_sphere<P: Intersect>(sphere: &Sphere, ray: Ray, nearest: &mut Nearest) -> bool {
    let record = SphereRecord::new(sphere.center, sphere.radius);
    let Some(lambda) = P::sphere(&record, &ray).filter(|&lambda| counts(lambda, nearest)) else {
        return false;
    };
    let point = ray.origin + ray.direction * lambda;
    *nearest = Nearest { lambda, point, outward: (point - sphere.center) / sphere.radius };
    true
}

/// The certified intersection, with the normals (specification, sections 9.2 and 9.3).
pub(super) fn meets_certified_cylinder<P: Intersect>(cylinder: &Cylinder, ray: Ray, nearest: &mut Nearest) -> bool {
    let record = CylinderRecord::new(cylinder.center, cylinder.radius, cylinder.axis);
    let met = P::cylinder(&record, &cylinder.axis, &ray);
    let Some((lambda, part)) = met.filter(|&(lambda, _)| counts(lambda, nearest)) else {
        return false;
    };
    let (axis, _) = cylinder.axis.unit_and_length();
    let point = ray.origin + ray.direction * lambda;
    let outward = match part {
        CylinderPart::Side => (point - cylinder.center) - axis * (point - cylinder.center).dot(axis),
        CylinderPart::Top => axis,
        CylinderPart::Bottom => -axis,
    };
    *nearest = Nearest { lambda, point, outward };
    true
}

pub(super) fn meets_sphere(sphere: &Sphere, origin: Vec3, direction: Vec3, nearest: &mut Nearest) -> bool {
    let r_c = sphere.center - origin;
    let a = direction.dot(direction);
    let b = -2.0 * direction.dot(r_c);
    let c = r_c.dot(r_c) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return false;
    }
    for root in [-discriminant.sqrt(), discriminant.sqrt()] {
        let lambda = (-b + root) / (2.0 * a);
        if counts(lambda, nearest) {
            let point = origin + direction * lambda;
            *nearest = Nearest { lambda, point, outward: (point - sphere.center) / sphere.radius };
            return true;
        }
    }
    false
}

pub(super) fn meets_cylinder(cylinder: &Cylinder, origin: Vec3, direction: Vec3, nearest: &mut Nearest) -> bool {
    let (axis, height) = cylinder.axis.unit_and_length();
    let side = meets_side(cylinder, height, axis, origin, direction, nearest);
    let top = meets_base(cylinder, height, axis, origin, direction, nearest);
    let bottom = meets_base(cylinder, height, -axis, origin, direction, nearest);
    side || top || bottom
}

fn meets_side(
    cylinder: &Cylinder,
    height: f64,
    axis: Vec3,
    origin: Vec3,
    direction: Vec3,
    nearest: &mut Nearest,
) -> bool {
    let perpendicular = |vector: Vec3| vector - axis * vector.dot(axis);
    let r_c = perpendicular(origin - cylinder.center);
    let d = perpendicular(direction);
    let a = d.dot(d);
    let b = 2.0 * r_c.dot(d);
    let c = r_c.dot(r_c) - cylinder.radius * cylinder.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return false;
    }
    for root in [-discriminant.sqrt(), discriminant.sqrt()] {
        let lambda = (-b + root) / (2.0 * a);
        let point = origin + direction * lambda;
        let along = (point - cylinder.center).dot(axis);
        if lambda >= 1e-3 && along.abs() <= height / 2.0 {
            if !counts(lambda, nearest) {
                return false;
            }
            *nearest = Nearest { lambda, point, outward: (point - cylinder.center) - axis * along };
            return true;
        }
    }
    false
}

/// The base whose normal leaves the cylinder along `normal`.
fn meets_base(
    cylinder: &Cylinder,
    height: f64,
    normal: Vec3,
    origin: Vec3,
    direction: Vec3,
    nearest: &mut Nearest,
) -> bool {
    let base = cylinder.center + normal * (height / 2.0);
    let slope = direction.dot(normal);
    if slope.abs() < 1e-8 {
        return false;
    }
    let lambda = (base - origin).dot(normal) / slope;
    let point = origin + direction * lambda;
    if counts(lambda, nearest) && (point - base).length() <= cylinder.radius {
        *nearest = Nearest { lambda, point, outward: normal };
        return true;
    }
    false
}
