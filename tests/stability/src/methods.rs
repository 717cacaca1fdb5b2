//! The implementations that are held against the oracle.
//!
//! Another one, such as a shader, joins by implementing [`Method`]: it gets cases and says what each ray meets.

mod formulas;
mod host;
pub mod projected;

use std::error::Error;
use std::time::Duration;

use cpu::Vec3;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::reference::intersect::{Exact, Plain};

use crate::case::Case;
use formulas::{InDouble, ProjectedSingle, Resolved, TextbookSingle};
use host::Host;

/// What an implementation says of a case in which the ray meets the object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Where.
    pub lambda: f64,
    /// What.
    pub part: CylinderPart,
    /// The point, as the implementation rounds it.
    pub point: Vec3,
    /// Whether it finds the ray outside.
    pub front: bool,
}

/// Why an implementation has no answers: a device's fault, say. Formulas in Rust always have some.
pub type Failure = Box<dyn Error>;

/// Makes every test once at each call, and gives the time that this took.
pub type Stopwatch<'a> = Box<dyn FnMut() -> Result<Duration, Failure> + 'a>;

/// An implementation of both intersections.
pub trait Method {
    /// Its name in tables.
    fn name(&self) -> &'static str;

    /// Its unit roundoff.
    fn unit_roundoff(&self) -> f64 {
        f64::EPSILON / 2.0
    }

    /// What it says of each case. One call for all, so that a device can take them in one go. All are spheres, or all
    /// are cylinders.
    ///
    /// # Errors
    /// Whatever keeps it from calculating.
    fn answer(&self, cases: &[Case]) -> Result<Vec<Option<Answer>>, Failure>;

    /// Gets ready to test every ray on its object, again and again, to be timed.
    ///
    /// # Errors
    /// Whatever keeps it from calculating.
    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure>;
}

/// All that Rust calculates, in the order of the table's rows.
#[must_use]
pub fn all() -> Vec<Box<dyn Method>> {
    vec![
        Box::new(Host::<InDouble<Plain>>::new(TEXTBOOK)),
        Box::new(Host::<InDouble<Exact>>::new(CERTIFIED)),
        Box::new(Host::<TextbookSingle>::new(TEXTBOOK_SINGLE)),
        Box::new(Host::<ProjectedSingle>::new(PROJECTED)),
    ]
}

/// Double-double for every ray and exact arithmetic where that leaves a doubt: what certified intersections would be
/// without their first step. Gives the truth rounded, so that only its cost is of interest.
#[must_use]
pub fn resolved() -> Box<dyn Method> {
    Box::new(Host::<InDouble<Resolved>>::new(RESOLVED))
}

/// The name of what the specification writes down.
pub const TEXTBOOK: &str = "textbook f64";
/// The name of what the renderer uses.
pub const CERTIFIED: &str = "certified f64";
/// The name of what the specification writes down, in single precision.
pub const TEXTBOOK_SINGLE: &str = "textbook f32";
/// The name of what a shader without double precision should use.
pub const PROJECTED: &str = "projected f32";
/// The name of [`resolved`].
pub const RESOLVED: &str = "double-double, exact";
