//! Exact intersections that count the filter's decisions while a whole picture is rendered.

use std::cell::Cell;

use cpu::internals::exact;
use cpu::internals::exact::error_bound::Decision;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::reference::intersect::{Exact, Intersect};
use cpu::{Ray, Vec3};

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
    const NONE: Self = Self { tests: 0, uncertain: 0, hits: 0, same_bits: 0, other_decision: 0 };

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

    fn record<A>(&mut self, plain: Option<f64>, truth: Option<f64>, same_part: bool, decision: &Decision<A>) {
        self.tests += 1;
        self.uncertain += u64::from(matches!(decision, Decision::Uncertain));
        self.hits += u64::from(truth.is_some());
        match (plain, truth) {
            (Some(lambda), Some(truth)) => {
                self.same_bits += u64::from(lambda == truth);
                // A relative difference above 10^-3 means that lambda is another root. The two roots of one surface are
                // nearer to each other only if the ray is nearly tangent.
                self.other_decision += u64::from(!same_part || (lambda - truth).abs() > 1e-3 * truth);
            }
            (None, None) => {}
            _ => self.other_decision += 1,
        }
    }
}

/// The counts for spheres (first) and for cylinders (second).
pub type Both = [Counts; 2];

thread_local! {
    static COUNTS: Cell<Both> = const { Cell::new([Counts::NONE; 2]) };
}

/// Returns the counts of this thread since the last call, and resets them to 0.
pub fn take_counts() -> Both {
    COUNTS.take()
}

fn update(kind: usize, change: impl FnOnce(&mut Counts)) {
    COUNTS.with(|cell| {
        let mut both = cell.get();
        change(&mut both[kind]);
        cell.set(both);
    });
}

/// The [`Exact`] intersections, which also count the filter's decisions for [`take_counts`].
#[derive(Clone, Copy, Debug)]
pub enum Observed {}

impl Intersect for Observed {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        let truth = Exact::sphere(record, ray);
        let decision = exact::sphere::filtered(record, ray);
        update(0, |counts| counts.record(record.intersect(ray), truth, true, &decision));
        truth
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        let (plain, truth) = (record.intersect(ray), Exact::cylinder(record, axis, ray));
        let decision = exact::cylinder::filtered(record, ray);
        let same_part = plain.map(|(_, part)| part) == truth.map(|(_, part)| part);
        let lambda = |hit: (f64, CylinderPart)| hit.0;
        update(1, |counts| counts.record(plain.map(lambda), truth.map(lambda), same_part, &decision));
        truth
    }
}
