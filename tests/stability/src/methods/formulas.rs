//! Formulas in Rust as types, so that a call of one is compiled into the loop that times it.

use std::marker::PhantomData;

use cpu::internals::exact;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::real::Real;
use cpu::reference::intersect::{Intersect, Precision};
use cpu::{Ray, Vec3};

use super::projected;

/// Both intersections over one number type.
pub trait Formulas {
    /// What they calculate in.
    type Number: Real<Mask = bool> + Into<f64>;
    /// Its unit roundoff.
    const UNIT_ROUNDOFF: f64;

    /// The contract of [`SphereRecord::intersect`].
    fn sphere(record: &SphereRecord<Self::Number>, ray: &Ray<Self::Number>) -> Option<Self::Number>;

    /// The contract of [`CylinderRecord::intersect`]; `axis` is the file's.
    fn cylinder(
        record: &CylinderRecord<Self::Number>,
        axis: &Vec3<Self::Number>,
        ray: &Ray<Self::Number>,
    ) -> Option<(Self::Number, CylinderPart)>;
}

/// What a renderer in f64 may use.
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

/// Exact intersections without their first step.
pub enum Resolved {}

impl Intersect for Resolved {
    const PRECISION: Precision = Precision::Exact;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        exact::sphere::precise(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        exact::cylinder::precise(record, axis, ray)
    }
}

/// The plain formulas in f32.
pub enum TextbookSingle {}

impl Formulas for TextbookSingle {
    type Number = f32;
    const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

    fn sphere(record: &SphereRecord<f32>, ray: &Ray<f32>) -> Option<f32> {
        record.intersect(ray)
    }

    fn cylinder(record: &CylinderRecord<f32>, _: &Vec3<f32>, ray: &Ray<f32>) -> Option<(f32, CylinderPart)> {
        record.intersect(ray)
    }
}

/// The projected form in f32.
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
