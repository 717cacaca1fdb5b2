//! The choice of the intersections with which the reference renders.

use std::cmp::Ordering;

use crate::exact::{self, order, order::Surface};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::math::vec3::Vec3;
use crate::reference::nearest;

/// The formulas with which the reference intersects a ray with one sphere or cylinder: [`Plain`] or [`Exact`]. Some
/// tests implement this trait too, to count intersections or to leave out a step of the exact formulas.
pub trait Intersect {
    /// Returns the lambda at which the ray hits the sphere, or `None`; see [`SphereRecord::intersect`].
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64>;

    /// Returns lambda and part of the ray's hit with the cylinder, or `None`; see [`CylinderRecord::intersect`].
    /// `file_axis` is the axis of the scene file.
    fn cylinder(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)>;

    /// Compares the lambdas of two hits, each given by the lambda and the surface that the ray hits. The result is
    /// `None` if it is not known.
    fn compare(_: &Ray, [(left, _), (right, _)]: [(f64, Surface); 2]) -> Option<Ordering> {
        left.partial_cmp(&right)
    }
}

/// The plain formulas as the specification has them, with their rounding errors.
#[derive(Clone, Copy, Debug)]
pub enum Plain {}

/// The exact intersections of the real renderer: the plain formulas with their error bounds, and more precise
/// formulas if these are uncertain.
#[derive(Clone, Copy, Debug)]
pub enum Exact {}

impl Intersect for Plain {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        nearest::sphere(record.center, record.radius, ray)
    }

    fn cylinder(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        nearest::cylinder(record.center, record.radius, *file_axis, ray)
    }
}

impl Intersect for Exact {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        exact::sphere::intersect(record, ray)
    }

    fn cylinder(record: &CylinderRecord, file_axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        exact::cylinder::intersect(record, file_axis, ray)
    }

    /// Lambdas that differ by more than a thousandth are compared as they are, because their errors are far smaller.
    /// All others are compared without rounding, unless a number is not finite.
    fn compare(ray: &Ray, [(left, of_left), (right, of_right)]: [(f64, Surface); 2]) -> Option<Ordering> {
        let rounded = left.partial_cmp(&right);
        if (left - right).abs() > left / 1000.0 {
            rounded
        } else {
            order::compare_exactly(ray, [&of_left, &of_right]).or(rounded)
        }
    }
}
