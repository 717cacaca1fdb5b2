//! The implementations that are compared with the oracle.
//!
//! To add an implementation, such as a shader, implement [`Method`]: it gets cases, and returns a hit or a miss for
//! each.

mod host;
pub mod projected;

use std::error::Error;
use std::time::Duration;

use cpu::Vec3;
use cpu::internals::exact;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;

use crate::case::Case;
use host::Host;

/// The hit that an implementation finds for a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The lambda of the hit.
    pub lambda: f64,
    /// The part of the cylinder that the ray hits; for a sphere always the side.
    pub part: CylinderPart,
    /// The hit point, as the implementation rounds it.
    pub point: Vec3,
    /// Whether the ray hits the surface from outside.
    pub front: bool,
}

/// The reason why an implementation has no answers, such as an error of a device. Formulas in Rust always have answers.
pub type Failure = Box<dyn Error>;

/// A function that intersects all cases once, and returns the time that this takes.
pub type Stopwatch<'a> = Box<dyn FnMut() -> Result<Duration, Failure> + 'a>;

/// An implementation of the intersections with spheres and with cylinders.
pub trait Method {
    /// Returns the name of the implementation in tables.
    fn name(&self) -> &'static str;

    /// Returns the unit roundoff of the implementation's numbers.
    fn unit_roundoff(&self) -> f64;

    /// Returns the hit of each case, or `None` for a miss. A call gets all cases, so that a device can compute them
    /// together. The objects must be all spheres or all cylinders.
    ///
    /// # Errors
    /// The reason why the implementation cannot compute.
    fn answer(&self, cases: &[Case]) -> Result<Vec<Option<Answer>>, Failure>;

    /// Prepares the cases, and returns a function that measures the time of their intersections.
    ///
    /// # Errors
    /// The reason why the implementation cannot compute.
    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure>;
}

/// Returns all implementations in Rust, in the order of the table's rows.
#[must_use]
pub fn all() -> Vec<Box<dyn Method>> {
    vec![
        Box::new(Host::new(PLAIN, DOUBLE, SphereRecord::<f64>::intersect, |record: &CylinderRecord, _, ray| {
            record.intersect(ray)
        })),
        Box::new(Host::new(EXACT, DOUBLE, exact::sphere::intersect, exact::cylinder::intersect)),
        Box::new(Host::new(
            PLAIN_SINGLE,
            SINGLE,
            SphereRecord::<f32>::intersect,
            |record: &CylinderRecord<f32>, _, ray| record.intersect(ray),
        )),
        Box::new(Host::new(PROJECTED, SINGLE, projected::sphere::<f32>, |record: &CylinderRecord<f32>, _, ray| {
            projected::cylinder(record, ray)
        })),
    ]
}

/// Unit roundoff of `f64`.
const DOUBLE: f64 = f64::EPSILON / 2.0;
/// Unit roundoff of `f32`.
const SINGLE: f64 = f32::EPSILON as f64 / 2.0;

/// Name of the specification's plain formulas in f64.
pub const PLAIN: &str = "plain f64";
/// Name of the exact intersections, which the renderer uses.
pub const EXACT: &str = "exact f64";
/// Name of the plain formulas in f32.
pub const PLAIN_SINGLE: &str = "plain f32";
/// Name of the projected form in f32, which is made for shaders without double precision.
pub const PROJECTED: &str = "projected f32";
