//! Formulas in Rust as types, so that the compiler inlines them into the loop whose time is measured.

use std::marker::PhantomData;

use cpu::internals::exact;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::real::Real;
use cpu::reference::intersect::Intersect;
use cpu::{Ray, Vec3};

use super::projected;

/// The intersections with spheres and with cylinders, in one number type.
pub trait Formulas {
    /// The number type in which the formulas calculate.
    type Number: Real<Mask = bool> + Into<f64>;
    /// Unit roundoff of the number type.
    const UNIT_ROUNDOFF: f64;

    /// Returns the lambda at which a ray hits a sphere, as [`SphereRecord::intersect`] does.
    fn sphere(record: &SphereRecord<Self::Number>, ray: &Ray<Self::Number>) -> Option<Self::Number>;

    /// Returns the lambda and the part at which a ray hits a cylinder, as [`CylinderRecord::intersect`] does. `axis` is
    /// the axis in the scene file.
    fn cylinder(
        record: &CylinderRecord<Self::Number>,
        axis: &Vec3<Self::Number>,
        ray: &Ray<Self::Number>,
    ) -> Option<(Self::Number, CylinderPart)>;
}

/// Intersections in f64 with which the reference can render.
pub struct InDouble<P>(PhantomData<P>);

impl<P: Intersect> Formulas for InDouble<P> {
    type Number = f64;
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        P::sphere(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        P::cylinder(record, axis, ray)
    }
}

/// The exact intersections without the filter in f64.
pub enum Resolved {}

impl Intersect for Resolved {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        exact::sphere::precise(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        exact::cylinder::precise(record, axis, ray)
    }
}

/// The plain formulas of the specification in f32.
pub enum PlainSingle {}

impl Formulas for PlainSingle {
    type Number = f32;
    const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

    fn sphere(record: &SphereRecord<f32>, ray: &Ray<f32>) -> Option<f32> {
        record.intersect(ray)
    }

    fn cylinder(record: &CylinderRecord<f32>, _: &Vec3<f32>, ray: &Ray<f32>) -> Option<(f32, CylinderPart)> {
        record.intersect(ray)
    }
}

/// The projected form of the intersections in f32.
pub enum ProjectedSingle {}

impl Formulas for ProjectedSingle {
    type Number = f32;
    const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

    fn sphere(record: &SphereRecord<f32>, ray: &Ray<f32>) -> Option<f32> {
        projected::sphere(record, ray)
    }

    fn cylinder(record: &CylinderRecord<f32>, _: &Vec3<f32>, ray: &Ray<f32>) -> Option<(f32, CylinderPart)> {
        projected::cylinder(record, ray)
    }
}
