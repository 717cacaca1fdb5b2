//! Measures the errors of an implementation in a regime, and how often it is wrong.

use cpu::internals::exact::error_bound::Decision;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::{Ray, Vec3};

use crate::case::Case;
use crate::methods::{Failure, Method};
use crate::oracle::{self, Judgement, big, to_f64};
use crate::record::{Found, Record};

/// The measured errors and times of one implementation in one regime. In the comments, `u` is the unit roundoff, and
/// `S` the size of a case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// The name of the regime.
    pub regime: &'static str,
    /// The name of the implementation.
    pub method: &'static str,
    /// Number of cases.
    pub cases: usize,
    /// Number of cases in which the ray hits the object.
    pub hits: usize,
    /// Number of cases with each [`Fault`], in the order of the enumeration.
    pub faults: [usize; 3],
    /// Number of wrong cases that stay wrong if the surface moves by 8 u S. `None` for cylinders, for which this is not
    /// computed.
    pub wrong_beyond_noise: Option<usize>,
    /// Number of right hits with the wrong side: inside instead of outside, or the reverse.
    pub wrong_side: usize,
    /// Relative errors of lambda, for the hits without a [`Fault`]: the median, the value that 99.9 % of the errors
    /// do not exceed, and the largest.
    pub lambda_error: [f64; 3],
    /// Distances of the hit points from the surface, in units of u times the largest coordinate: the median and the
    /// largest.
    pub surface_error: [f64; 2],
    /// Time of one intersection in nanoseconds, the shortest of nine passes.
    pub nanoseconds: f64,
}

impl Row {
    /// Returns the number of cases with a wrong decision.
    #[must_use]
    pub fn wrong(&self) -> usize {
        self.faults.iter().sum()
    }
}

/// A wrong decision about a case. The error of lambda is no decision: [`judge_answer`] measures it apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// A miss instead of a hit, or the reverse.
    Hit,
    /// A hit of another part of the object.
    Part,
    /// A hit of the right part where the line crosses this part the other time.
    Root,
}

/// The cases of a regime with the oracle's answers, twice: in double precision, and rounded to single precision.
#[derive(Debug)]
pub struct Judged {
    /// The regime's name.
    pub regime: &'static str,
    cases: [Vec<Case>; 2],
    judgements: [Vec<Judgement>; 2],
}

impl Judged {
    /// Computes the oracle's answers for `cases`, and for these cases in single precision.
    #[must_use]
    pub fn new(regime: &'static str, cases: Vec<Case>) -> Self {
        let single = cases.iter().map(Case::single).collect();
        let cases = [cases, single];
        let judgements = [0, 1].map(|index| cases[index].iter().map(oracle::judge).collect());
        Self { regime, cases, judgements }
    }

    /// Returns the cases with the oracle's answers, in the precision of an implementation that has this unit roundoff.
    fn seen_with(&self, unit_roundoff: f64) -> (&[Case], &[Judgement]) {
        let precision = usize::from(unit_roundoff > f64::EPSILON);
        (&self.cases[precision], &self.judgements[precision])
    }

    /// Compares an implementation with the oracle, and measures its time.
    ///
    /// # Errors
    /// An error of [`Method::answer`] or [`Method::stopwatch`].
    pub fn measure(&self, method: &dyn Method) -> Result<Row, Failure> {
        let (cases, judgements) = self.seen_with(method.unit_roundoff());
        let (answers, nanoseconds) = (method.answer(cases)?, nanoseconds(method, cases)?);
        let hits = judgements.iter().filter(|judgement| judgement.truth.is_some()).count();
        let mut row = Row {
            regime: self.regime,
            method: method.name(),
            cases: cases.len(),
            hits,
            nanoseconds,
            wrong_beyond_noise: judgements.first().and_then(|judgement| judgement.slack).map(|_| 0),
            ..Row::default()
        };
        let (mut lambda_errors, mut surface_errors) = (Vec::new(), Vec::new());
        for ((case, judgement), answer) in cases.iter().zip(judgements).zip(answers) {
            let found = answer.map(|found| (found.lambda, found.part));
            let error = match judge_answer(judgement, found, method.unit_roundoff()) {
                Ok(error) => error,
                Err(fault) => {
                    row.faults[fault as usize] += 1;
                    let noise = 8.0 * method.unit_roundoff() * case.size();
                    if let (Some(count), Some(slack)) = (&mut row.wrong_beyond_noise, judgement.slack) {
                        *count += usize::from(slack > noise);
                    }
                    continue;
                }
            };
            let (Some(truth), Some(answer)) = (&judgement.truth, answer) else { continue };
            lambda_errors.push(error);
            row.wrong_side += usize::from(truth.front != answer.front);
            let distance = oracle::distance_from_surface(case, answer.part, answer.point);
            surface_errors.push(distance / (method.unit_roundoff() * largest(case, answer.point)));
        }
        row.lambda_error = [0.5, 0.999, 1.0].map(|share| quantile(&mut lambda_errors, share));
        row.surface_error = [0.5, 1.0].map(|share| quantile(&mut surface_errors, share));
        Ok(row)
    }

    /// Returns two shares of the cases, from 0 to 1: those that need the compensated formulas, and those that need
    /// dyadic arithmetic.
    #[must_use]
    pub fn fallbacks(&self) -> [f64; 2] {
        let share = |needs: &dyn Fn(&Record, &Ray) -> bool| {
            let counted = self.cases[0].iter().filter(|case| {
                let (record, ray) = case.of();
                needs(&record, &ray)
            });
            counted.count() as f64 / self.cases[0].len() as f64
        };
        [
            share(&|record, ray| record.filtered(ray) == Decision::Uncertain),
            share(&|record, ray| record.needs_dyadic(ray)),
        ]
    }
}

/// The largest number of cases whose time is measured. A pass over them mostly takes less than a millisecond, so that
/// on a busy machine some passes are not interrupted.
const TIMED_CASES: usize = 4096;

/// Returns the time of one intersection in nanoseconds. It is the shortest of nine passes over the first cases, because
/// other processes can only add time.
fn nanoseconds(method: &dyn Method, cases: &[Case]) -> Result<f64, Failure> {
    let cases = &cases[..cases.len().min(TIMED_CASES)];
    let mut stopwatch = method.stopwatch(cases)?;
    let mut least = f64::INFINITY;
    for _ in 0..9 {
        least = least.min(stopwatch()?.as_secs_f64());
    }
    Ok(least * 1e9 / cases.len() as f64)
}

/// A relative error of a lambda, in units of u, from which on something has cancelled in its formula. It is about the
/// error of the compensated step if the condition number is 2, which it is at most if nothing cancels.
const ORDINARY_ERROR: f64 = 26.0;

/// Compares an answer, which is a lambda and a part, with the oracle's. Returns the relative error of lambda, which is
/// 0 for a right miss.
///
/// # Errors
/// The decision that is wrong. An answer takes the root of its part that is nearest to its lambda. Two roots that are
/// too near to be told apart by a lambda with ordinary rounding errors count as one.
pub fn judge_answer(judgement: &Judgement, answer: Found, unit_roundoff: f64) -> Result<f64, Fault> {
    let (truth, (lambda, part)) = match (&judgement.truth, answer) {
        (None, None) => return Ok(0.0),
        (Some(truth), Some(answer)) => (truth, answer),
        _ => return Err(Fault::Hit),
    };
    if truth.part != part {
        return Err(Fault::Part);
    }
    let lambda = big(lambda);
    let distance = |other: &oracle::Big| to_f64(&(&lambda - other)).abs();
    let error = distance(&truth.lambda);
    let resolution = ORDINARY_ERROR * unit_roundoff * to_f64(&truth.lambda);
    let is_nearer = |(of, other): &(CylinderPart, oracle::Big)| *of == part && distance(other) < error;
    if error > resolution && judgement.crossings.iter().any(is_nearer) {
        return Err(Fault::Root);
    }
    Ok(error / to_f64(&truth.lambda))
}

/// Returns the largest magnitude in the computation of a hit point: of the coordinates of the point and of the ray's
/// origin, and of the radius.
fn largest(case: &Case, point: Vec3) -> f64 {
    let reach = |vector: Vec3| vector.to_array().iter().fold(0.0_f64, |most, component| most.max(component.abs()));
    let (Shape::Sphere(Sphere { radius, .. }) | Shape::Cylinder(Cylinder { radius, .. })) = case.shape;
    reach(point).max(reach(case.ray.origin)).max(radius)
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * share).round() as usize]
}

#[cfg(test)]
mod tests;
