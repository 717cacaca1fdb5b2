//! Exact intersections that count the filter's decisions while a whole picture is rendered.

use std::cell::RefCell;

use cpu::internals::exact;
use cpu::internals::exact::error_bound::Decision;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::reference::intersect::{Exact, Intersect};
use cpu::{Ray, Vec3};

use crate::record::Found;

/// Counts of the intersections in one picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Number of tests, which are intersections of one ray with one object.
    pub tests: u64,
    /// Number of tests for which the plain formulas are uncertain.
    pub uncertain: u64,
    /// Number of tests with a hit.
    pub hits: u64,
    /// Number of hits whose lambda has the bits of the plain formulas.
    pub same_bits: u64,
    /// Number of tests in which the plain formulas give a wrong hit, miss, part or root.
    pub other_decision: u64,
}

impl Counts {
    /// Returns the sum of these counts and `other`.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        Self {
            tests: self.tests + other.tests,
            uncertain: self.uncertain + other.uncertain,
            hits: self.hits + other.hits,
            same_bits: self.same_bits + other.same_bits,
            other_decision: self.other_decision + other.other_decision,
        }
    }

    /// Counts a test with the hits of the plain formulas and of the exact ones.
    fn record<A>(&mut self, plain: Found, truth: Found, decision: &Decision<A>) {
        self.tests += 1;
        self.uncertain += u64::from(matches!(decision, Decision::Uncertain));
        self.hits += u64::from(truth.is_some());
        match (plain, truth) {
            (Some((lambda, part)), Some((truth, right_part))) => {
                self.same_bits += u64::from(lambda == truth);
                // A relative difference above 10^-3 means that lambda is another root. The two roots of one surface are
                // nearer to each other only if the ray is nearly tangent.
                self.other_decision += u64::from(part != right_part || (lambda - truth).abs() > 1e-3 * truth);
            }
            (None, None) => {}
            _ => self.other_decision += 1,
        }
    }
}

thread_local! {
    static COUNTS: RefCell<Counts> = RefCell::default();
}

/// Returns the counts of this thread since the last call, and resets them to 0.
pub fn take_counts() -> Counts {
    COUNTS.take()
}

/// The [`Exact`] intersections, which also count the filter's decisions for [`take_counts`].
#[derive(Clone, Copy, Debug)]
pub enum Observed {}

impl Intersect for Observed {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        let (plain, truth) = (record.intersect(ray), Exact::sphere(record, ray));
        let [plain, found] = [plain, truth].map(|lambda| lambda.map(|lambda| (lambda, CylinderPart::Side)));
        COUNTS.with_borrow_mut(|counts| counts.record(plain, found, &exact::sphere::filtered(record, ray)));
        truth
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Found {
        let (plain, truth) = (record.intersect(ray), Exact::cylinder(record, axis, ray));
        COUNTS.with_borrow_mut(|counts| counts.record(plain, truth, &exact::cylinder::filtered(record, ray)));
        truth
    }
}
