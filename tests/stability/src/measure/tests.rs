//! Tests that the yardstick tells wrong decisions from errors of lambda.

use cpu::Vec3;
use cpu::internals::geometry::cylinder::CylinderPart::{Bottom, Side, Top};
use cpu::internals::input::scene::Cylinder;

use super::*;
use crate::regimes::CYLINDERS;

const DOUBLE: f64 = f64::EPSILON / 2.0;

/// Returns the verdict about an answer, with the error of lambda or the wrong decision.
fn verdict(case: &Case, answer: Found) -> Result<f64, Fault> {
    judge_answer(&oracle::judge(case), answer, DOUBLE)
}

#[test]
fn each_wrong_decision_is_named() {
    let cylinder = Cylinder { center: Vec3::ZERO, radius: 1.0, axis: Vec3::new(0.0, 4.0, 0.0) };
    // The ray enters the side at 2 and leaves it at 4.
    let case = Case::cylinder(cylinder, Vec3::new(0.0, 0.0, -3.0), Vec3::new(0.0, 0.0, 1.0));
    assert_eq!(verdict(&case, Some((2.0, Side))), Ok(0.0));
    assert_eq!(verdict(&case, Some((2.5, Side))), Ok(0.25), "an error of lambda is no wrong decision");
    assert_eq!(verdict(&case, Some((4.0, Side))), Err(Fault::Root));
    assert_eq!(verdict(&case, Some((2.0, Top))), Err(Fault::Part));
    assert_eq!(verdict(&case, None), Err(Fault::Hit));
    let away = Case::cylinder(cylinder, Vec3::new(0.0, 0.0, -3.0), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(verdict(&away, None), Ok(0.0));
    assert_eq!(verdict(&away, Some((2.0, Side))), Err(Fault::Hit));
}

#[test]
fn the_right_cap_of_a_thin_disc_is_right_though_the_other_cap_is_nearer_to_its_lambda() {
    // Top and bottom are 2^-54 apart, so all errors of lambda are larger than the disc is thick.
    let disc = Cylinder { center: Vec3::ZERO, radius: 1.0, axis: Vec3::new(0.0, 0.5_f64.powi(54), 0.0) };
    let case = Case::cylinder(disc, Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, -1.0, 0.0));
    let lambda = 3.0 + 8.0 * DOUBLE;
    let error = verdict(&case, Some((lambda, Top))).expect("the ray hits the top");
    assert!(error > DOUBLE && error < 4.0 * DOUBLE, "{error:e}");
    assert_eq!(verdict(&case, Some((lambda, Bottom))), Err(Fault::Part));
}

#[test]
fn the_exact_intersection_is_right_for_the_thin_discs_that_were_called_wrong() {
    let everything = CYLINDERS.last().expect("there are regimes");
    assert_eq!(everything.name, "everything at once");
    let cases = everything.cases(1, 37_484);
    for index in [866, 24_248, 29_275, 37_483] {
        let case = &cases[index];
        let (record, ray) = case.of();
        let answer = record.exact(&ray);
        let (lambda, part) = answer.expect("the ray hits");
        let judgement = oracle::judge(case);
        let lambda = big(lambda);
        let distances = judgement.crossings.iter().map(|(of, other)| (*of, to_f64(&(&lambda - other)).abs()));
        let (nearest, _) = distances.reduce(|a, b| if b.1 < a.1 { b } else { a }).expect("the line crosses it");
        assert_ne!(nearest, part, "case {index} is such a disc");
        let error = judge_answer(&judgement, answer, DOUBLE).expect("the decision is right");
        assert!(error < 1e-14, "case {index}: {error:e}");
    }
}

#[test]
fn the_first_root_of_a_far_sphere_is_right_though_the_second_is_nearer_to_its_lambda() {
    // A ray of the regime "far and small". Its roots are 4.5 u apart, and `h` is a sum with three roundings.
    let center = Vec3::new(0.326_038_920_779_820_44, 0.472_667_393_855_170_2, 0.149_482_120_786_359_03);
    let origin = Vec3::new(-85_146_337_858.189_2, 103_639_008_982.478_71, 46_720_848_466.240_364);
    let direction = Vec3::new(0.599_476_724_651_276_4, -0.729_675_229_883_346_5, -0.328_940_291_688_420_1);
    let case = Case::sphere(center, 3.724_706_334_919_319e-5, origin, direction);
    let (record, ray) = case.of();
    let answer = record.exact(&ray);
    let error = verdict(&case, answer).expect("the first root is chosen");
    assert!(error > 4.0 * DOUBLE && error < 5.0 * DOUBLE, "{error:e}");
    let (lambda, judgement) = (big(answer.expect("it hits").0), oracle::judge(&case));
    let distances: Vec<_> = judgement.crossings.iter().map(|(_, root)| to_f64(&(&lambda - root)).abs()).collect();
    assert!(distances.iter().any(|other| *other < 0.2 * error * to_f64(&lambda)), "{distances:?}");
}

#[test]
fn the_second_of_two_roots_that_are_just_apart_enough_is_wrong() {
    // The ray crosses the sphere at 1 - 2^-48 and 1 + 2^-48, 64 u apart.
    let half = 0.5_f64.powi(48);
    let case = Case::sphere(Vec3::new(0.0, 0.0, 1.0), half, Vec3::ZERO, Vec3::new(0.0, 0.0, 1.0));
    assert_eq!(verdict(&case, Some((1.0 - half, Side))), Ok(0.0));
    assert_eq!(verdict(&case, Some((1.0 + half, Side))), Err(Fault::Root));
}
