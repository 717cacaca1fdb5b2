//! Tests that [`check`] notices one wrong decision or one error of lambda among right answers.

use cpu::internals::geometry::cylinder::CylinderPart;

use super::*;
use crate::case::Case;
use crate::methods::{Answer, EXACT, Stopwatch};
use crate::regimes::CYLINDERS;

/// The exact intersections with one mistake.
struct Mistaken {
    exact: Box<dyn Method>,
    /// Makes the mistake in the first answer for which it returns true.
    mistake: fn(&mut Option<Answer>) -> bool,
}

impl Method for Mistaken {
    fn name(&self) -> &'static str {
        EXACT
    }

    fn unit_roundoff(&self) -> f64 {
        self.exact.unit_roundoff()
    }

    fn answer(&self, cases: &[Case]) -> Result<Vec<Option<Answer>>, Failure> {
        let mut answers = self.exact.answer(cases)?;
        answers.iter_mut().any(self.mistake);
        Ok(answers)
    }

    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure> {
        self.exact.stopwatch(cases)
    }
}

/// Returns what [`check`] says about a regime in which the exact intersections make a mistake.
fn checked(mistake: fn(&mut Option<Answer>) -> bool) -> Result<usize, String> {
    let exact = methods::all().into_iter().find(|method| method.name() == EXACT).expect("it is an implementation");
    let methods: [Box<dyn Method>; 1] = [Box::new(Mistaken { exact, mistake })];
    let sections = sections(&methods, &CYLINDERS[..1], 1, 200).expect("formulas in Rust have answers");
    check("cylinder", &sections, PROVEN_ERRORS[1])
}

#[test]
fn one_wrong_decision_or_error_of_lambda_is_noticed() {
    assert_eq!(checked(|_| false), Ok(0));
    let missed = checked(|answer| answer.take().is_some()).expect_err("a hit is missing");
    assert!(
        missed.starts_with("cylinder, ordinary, exact f64: 1 wrong hits, 0 wrong parts and 0 wrong roots"),
        "{missed}"
    );
    let other_part = checked(|answer| {
        let Some(answer) = answer else { return false };
        answer.part = if answer.part == CylinderPart::Top { CylinderPart::Bottom } else { CylinderPart::Top };
        true
    });
    assert!(other_part.is_err_and(|message| message.contains("0 wrong hits, 1 wrong parts")));
    let inaccurate = checked(|answer| {
        let Some(answer) = answer else { return false };
        answer.lambda *= 1.0 + 1e-9;
        true
    });
    let inaccurate = inaccurate.expect_err("an error is above the proved bound");
    assert!(inaccurate.contains("0 wrong roots; largest error of lambda 1.000"), "{inaccurate}");
}

#[test]
fn a_regime_without_hits_is_an_error() {
    let beside = Regime {
        name: "beside",
        draw: |_| Case::sphere(cpu::Vec3::ZERO, 1.0, cpu::Vec3::new(0.0, 3.0, 0.0), cpu::Vec3::new(0.0, 0.0, 1.0)),
    };
    let error = sections(&methods::all(), &[beside], 1, 100).expect_err("nothing is measured");
    assert_eq!(error.to_string(), "beside: only 0 hits of 100");
}
