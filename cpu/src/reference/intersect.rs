//! Which intersections the reference renders with.

use crate::exact;
use crate::geometry::cylinder::{CylinderPart, CylinderRecord};
use crate::geometry::ray::Ray;
use crate::geometry::sphere::SphereRecord;
use crate::math::vec3::Vec3;

/// How the reference intersects: the choice as a value. [`Intersect`] is the same choice as a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// The textbook's formulas, with whatever rounding makes of them.
    Textbook,
    /// The same, checked, and repeated more precisely where they may be wrong: what the real renderer does.
    Certified,
}

/// Intersections of a ray with one object. Tests bring some of their own, which count or leave out a step.
pub trait Intersect {
    /// Whether the reference takes its own literal formulas or asks this type.
    const PRECISION: Precision;

    /// Where the ray meets the sphere; the contract of [`SphereRecord::intersect`].
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64>;

    /// Where the ray meets the cylinder that the file describes with `axis`; the contract of
    /// [`CylinderRecord::intersect`].
    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)>;
}

/// [`Precision::Textbook`] as a type.
#[derive(Clone, Copy, Debug)]
pub enum Textbook {}

/// [`Precision::Certified`] as a type.
#[derive(Clone, Copy, Debug)]
pub enum Certified {}

impl Intersect for Textbook {
    const PRECISION: Precision = Precision::Textbook;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        record.intersect(ray)
    }

    fn cylinder(record: &CylinderRecord, _: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        record.intersect(ray)
    }
}

impl Intersect for Certified {
    const PRECISION: Precision = Precision::Certified;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        exact::sphere::intersect(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        exact::cylinder::intersect(record, axis, ray)
    }
}
