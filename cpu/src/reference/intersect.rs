//! Which intersections the reference renders with.

use crate::exact;
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::math::vec3::Vec3;

/// Intersections of a ray with one object. Tests have implementations that count intersections or leave
/// out a step.
pub trait Intersect {
    /// Whether the reference takes its own literal formulas instead of those of this type.
    const IS_LITERAL: bool = false;

    /// Where the ray hits the sphere; the contract of [`SphereRecord::intersect`].
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64>;

    /// Where the ray hits the cylinder that the file describes with `axis`; the contract of
    /// [`CylinderRecord::intersect`].
    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)>;
}

/// The plain formulas, with their rounding errors.
#[derive(Clone, Copy, Debug)]
pub enum Plain {}

/// The plain formulas with their error bounds, and more precise ones where these do not decide, as in the real
/// renderer.
#[derive(Clone, Copy, Debug)]
pub enum Exact {}

impl Intersect for Plain {
    const IS_LITERAL: bool = true;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        record.intersect(ray)
    }

    fn cylinder(record: &CylinderRecord, _: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        record.intersect(ray)
    }
}

impl Intersect for Exact {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        exact::sphere::intersect(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        exact::cylinder::intersect(record, axis, ray)
    }
}
