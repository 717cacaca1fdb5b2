//! Intersections whose decisions are right and whose lambdas are accurate, at nearly the textbook's price.
//!
//! The textbook's formulas run first. A running certificate, a few multiplications, bounds what rounding may have
//! done to them; where it holds, the textbook's bits are the answer. Where it does not, a sphere is asked by a formula
//! in which the root that is short does not [cancel](sphere_compensated). Else, or where that is in doubt too, the
//! textbook's formulas and their certificate run again in [double-double](double_double) arithmetic, and where even these
//! are in doubt, every decision is taken in [exact](dyadic) arithmetic:
//!
//! | step | unit roundoff | taken by |
//! |---|---|---|
//! | textbook, f64 | 2^-53 | nearly all rays |
//! | compensated, f64 | 2^-53 | rays that start near a large sphere |
//! | double-double | 2^-102 | rays that graze, or meet a small or far object |
//! | exact | 0 | rays that are tangent, or pass through a rim, to the last bit |
//!
//! What is true is decided by the numbers of the scene file, taken as exact: the sphere `|C - O - d lambda| = r`; the
//! cylinder of height `|axis|` around the line through its centre along `axis`, which need not be a multiple of a
//! rounded unit vector. The bounds are derived in `docs/accuracy.md`, where they are also measured.
//!
//! A ray that is not finite has no exact meaning: it gets what the textbook says. So does a null direction, which
//! meets nothing, and the side of a cylinder that the ray is parallel to.

pub mod certificate;
pub mod cylinder;
mod cylinder_exact;
mod cylinder_lanes;
mod cylinder_surfaces;
pub mod double_double;
pub mod dyadic;
pub mod exact_sums;
mod limbs;
pub mod sphere;
pub mod sphere_compensated;
mod sphere_exact;

pub use certificate::{Rounding, Verdict};
pub use double_double::DoubleDouble;

use crate::cylinder::{CylinderRecord, Part};
use crate::ray::Ray;
use crate::sphere::SphereRecord;
use crate::vec3::Vec3;

/// How a renderer intersects: the choice as a value. [`Intersect`] is the same choice as a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// The textbook's formulas, with whatever rounding makes of them.
    Textbook,
    /// The same, checked, and repeated more precisely where they may be wrong.
    Certified,
}

/// How a renderer intersects: a type, so that the choice costs nothing at run time.
pub trait Intersect {
    /// The choice as a value.
    const PRECISION: Precision;

    /// Where the ray meets the sphere; the contract of [`SphereRecord::intersect`].
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64>;

    /// Where the ray meets the cylinder that the file describes with `axis`; the contract of
    /// [`CylinderRecord::intersect`].
    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, Part)>;

    /// What [`Intersect::sphere`] says, unless that takes more than the textbook's formulas.
    #[inline(always)]
    fn judge_sphere(record: &SphereRecord, ray: &Ray) -> Verdict<Option<f64>> {
        Verdict::Certain(Self::sphere(record, ray))
    }

    /// The same, with what [`Intersect::reconsider_sphere`] tries first: worth its code where rays are often in doubt.
    #[inline(always)]
    fn judge_large_sphere(record: &SphereRecord, ray: &Ray) -> Verdict<Option<f64>> {
        Self::judge_sphere(record, ray)
    }

    /// What [`Intersect::cylinder`] says, unless that takes more than the textbook's formulas.
    #[inline(always)]
    fn judge_cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Verdict<Option<(f64, Part)>> {
        Verdict::Certain(Self::cylinder(record, axis, ray))
    }

    /// What [`Intersect::sphere`] says where [`Intersect::judge_sphere`] is in doubt.
    fn reconsider_sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        Self::sphere(record, ray)
    }

    /// What [`Intersect::cylinder`] says where [`Intersect::judge_cylinder`] is in doubt.
    fn reconsider_cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, Part)> {
        Self::cylinder(record, axis, ray)
    }
}

/// [`Precision::Textbook`] as a type.
#[derive(Clone, Copy, Debug)]
pub enum Textbook {}

/// [`Precision::Certified`] as a type.
#[derive(Clone, Copy, Debug)]
pub enum Certified {}

impl Intersect for Textbook {
    const PRECISION: Precision = Precision::Textbook;

    #[inline(always)]
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        record.intersect(ray)
    }

    #[inline(always)]
    fn cylinder(record: &CylinderRecord, _: &Vec3, ray: &Ray) -> Option<(f64, Part)> {
        record.intersect(ray)
    }
}

impl Intersect for Certified {
    const PRECISION: Precision = Precision::Certified;

    #[inline(always)]
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        sphere::intersect(record, ray)
    }

    #[inline(always)]
    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, Part)> {
        cylinder::intersect(record, axis, ray)
    }

    #[inline(always)]
    fn judge_sphere(record: &SphereRecord, ray: &Ray) -> Verdict<Option<f64>> {
        sphere::judge(record, ray)
    }

    #[inline(always)]
    fn judge_large_sphere(record: &SphereRecord, ray: &Ray) -> Verdict<Option<f64>> {
        sphere::judge_large(record, ray)
    }

    #[inline(always)]
    fn judge_cylinder(record: &CylinderRecord, _: &Vec3, ray: &Ray) -> Verdict<Option<(f64, Part)>> {
        cylinder::judge(record, ray)
    }

    #[inline(always)]
    fn reconsider_sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        sphere::reconsider(record, ray)
    }

    #[inline(always)]
    fn reconsider_cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, Part)> {
        cylinder::resolve(record, axis, ray)
    }
}
