//! The choice of the intersections with which the reference renders.

use crate::exact;
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::math::vec3::Vec3;

/// The intersections of the reference, as a value. [`Intersect`] is the same choice as a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// The plain formulas, with their rounding errors.
    Plain,
    /// The exact intersections of the real renderer: the plain formulas with their error bounds, and more precise
    /// formulas if these are uncertain.
    Exact,
}

/// The intersections of a ray with one sphere or cylinder. Some tests implement it to count intersections, or to leave
/// out a step of them.
pub trait Intersect {
    /// If this is [`Precision::Plain`], the reference uses its own literal formulas. Otherwise it calls the functions
    /// of this type.
    const PRECISION: Precision;

    /// Returns the lambda at which the ray hits the sphere, or `None`, as [`SphereRecord::intersect`] does.
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64>;

    /// Returns lambda and part of the ray's hit with the cylinder, or `None`, as [`CylinderRecord::intersect`] does.
    /// `axis` is that of the scene file.
    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)>;
}

/// The choice [`Precision::Plain`] as a type, which has no values.
#[derive(Clone, Copy, Debug)]
pub enum Plain {}

/// The choice [`Precision::Exact`] as a type, which has no values.
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
