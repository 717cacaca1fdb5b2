//! Which intersections the reference renders with.

use crate::exact;
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::math::vec3::Vec3;

/// How the reference intersects: the choice as a value. [`Intersect`] is the same choice as a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// The plain formulas, with their rounding errors.
    Plain,
    /// The plain formulas with their error bounds, and more precise ones where these do not decide, as in the real
    /// renderer.
    Exact,
}

/// Intersections of a ray with one object. Tests have implementations that count intersections or leave
/// out a step.
pub trait Intersect {
    /// Whether the reference takes its own literal formulas or those of this type.
    const PRECISION: Precision;

    /// Where the ray hits the sphere; the contract of [`SphereRecord::intersect`].
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64>;

    /// Where the ray hits the cylinder that the file describes with `axis`; the contract of
    /// [`CylinderRecord::intersect`].
    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)>;
}

/// [`Precision::Plain`] as a type.
#[derive(Clone, Copy, Debug)]
pub enum Plain {}

/// [`Precision::Exact`] as a type.
#[derive(Clone, Copy, Debug)]
pub enum Exact {}

impl Intersect for Plain {
    const PRECISION: Precision = Precision::Plain;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        record.intersect(ray)
    }

    fn cylinder(record: &CylinderRecord, _: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        record.intersect(ray)
    }
}

impl Intersect for Exact {
    const PRECISION: Precision = Precision::Exact;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        exact::sphere::intersect(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        exact::cylinder::intersect(record, axis, ray)
    }
}
