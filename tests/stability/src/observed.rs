//! Exact intersections that count what the certificate does, while a whole picture is rendered with them.

use std::cell::Cell;

use cpu::internals::exact;
use cpu::internals::exact::error_bound::Decision;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::reference::intersect::{Exact, Intersect, Precision};
use cpu::{Ray, Vec3};

/// What a render's intersections came to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Rays tried on objects.
    pub tests: u64,
    /// Of these, in doubt after the plain formulas.
    pub doubtful: u64,
    /// Tests that met something.
    pub hits: u64,
    /// Of these, whose lambda has the textbook's bits.
    pub same_bits: u64,
    /// Tests where textbook and truth disagree on hit, miss or part, or take different roots.
    pub other_decision: u64,
}

impl Counts {
    const NONE: Self = Self { tests: 0, doubtful: 0, hits: 0, same_bits: 0, other_decision: 0 };

    /// These and those.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        Self {
            tests: self.tests + other.tests,
            doubtful: self.doubtful + other.doubtful,
            hits: self.hits + other.hits,
            same_bits: self.same_bits + other.same_bits,
            other_decision: self.other_decision + other.other_decision,
        }
    }

    fn record<A>(&mut self, textbook: Option<f64>, truth: Option<f64>, same_part: bool, verdict: &Decision<A>) {
        self.tests += 1;
        self.doubtful += u64::from(matches!(verdict, Decision::Uncertain));
        self.hits += u64::from(truth.is_some());
        match (textbook, truth) {
            (Some(lambda), Some(truth)) => {
                self.same_bits += u64::from(lambda == truth);
                // Two roots of one surface differ by more than this, unless the ray is all but tangent.
                self.other_decision += u64::from(!same_part || (lambda - truth).abs() > 1e-3 * truth);
            }
            (None, None) => {}
            _ => self.other_decision += 1,
        }
    }
}

/// Counts of spheres and cylinders.
pub type Both = [Counts; 2];

thread_local! {
    static COUNTS: Cell<Both> = const { Cell::new([Counts::NONE; 2]) };
}

/// The counts since the last call on this thread.
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

/// [`Exact`], observed.
#[derive(Clone, Copy, Debug)]
pub enum Observed {}

impl Intersect for Observed {
    const PRECISION: Precision = Precision::Exact;

    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        let truth = Exact::sphere(record, ray);
        let verdict = exact::sphere::filtered(record, ray);
        update(0, |counts| counts.record(record.intersect(ray), truth, true, &verdict));
        truth
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        let (textbook, truth) = (record.intersect(ray), Exact::cylinder(record, axis, ray));
        let verdict = exact::cylinder::filtered(record, ray);
        let same_part = textbook.map(|(_, part)| part) == truth.map(|(_, part)| part);
        let lambda = |hit: (f64, CylinderPart)| hit.0;
        update(1, |counts| counts.record(textbook.map(lambda), truth.map(lambda), same_part, &verdict));
        truth
    }
}
