//! Tests of the exact intersections in every regime, including those in which squares underflow or nearly overflow,
//! terms cancel to zero, or a surface is at the least lambda.
//!
//! The variable RENDER_CASES sets the number of rays for each regime, and RENDER_SEED sets another seed.

use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::internals::input::scene::{Cylinder, Shape};
use cpu::{Ray, Vec3};
use stability::case::Case;
use stability::measure::judge_answer;
use stability::oracle;
use stability::record::Found;
use stability::regimes::{CYLINDERS, EXTREMES, LIMITS, SPHERES};
use stability::run::PROVEN_ERRORS;

/// Number of rays for each regime, unless RENDER_CASES is set.
const RAYS: u64 = 5_000;

pub fn number(variable: &str, default: u64) -> u64 {
    std::env::var(variable).map_or(default, |text| text.parse().expect("the variable is a number"))
}

/// Returns the exact intersection of a case, with all fallbacks.
fn exact_answer(case: &Case) -> Found {
    let (record, ray) = case.of();
    record.exact(&ray)
}

fn hex(bits: u64) -> f64 {
    f64::from_bits(bits)
}

#[test]
fn every_decision_is_right_and_every_lambda_within_its_bound() {
    let (rays, seed) = (number("RENDER_CASES", RAYS) as usize, number("RENDER_SEED", 3));
    let mut plain_wrong = 0;
    for regime in SPHERES.iter().chain(&CYLINDERS).chain(&EXTREMES).chain(&LIMITS) {
        // `share` is the largest quotient of an error and the proven bound for that kind of object.
        let (mut hits, mut worst, mut share) = (0, 0.0_f64, 0.0_f64);
        for case in regime.cases(seed, rays) {
            let (judgement, answer) = (oracle::judge(&case), exact_answer(&case));
            let error = judge_answer(&judgement, answer, f64::EPSILON / 2.0);
            let error =
                error.unwrap_or_else(|fault| panic!("{}: {case:?} gives {answer:?}, a wrong {fault:?}", regime.name));
            let (record, ray) = case.of::<f64>();
            plain_wrong += usize::from(record.plain(&ray).map(|hit| hit.1) != answer.map(|hit| hit.1));
            hits += usize::from(judgement.truth.is_some());
            worst = worst.max(error);
            share = share.max(error / PROVEN_ERRORS[usize::from(matches!(case.shape, Shape::Cylinder(_)))]);
        }
        println!("{}: {hits} hits of {rays}, largest error of lambda {worst:.2e}", regime.name);
        assert!(share < 1.0, "{}: {worst:e}", regime.name);
        assert!(50 * hits > rays, "{}: {hits} hits of {rays}", regime.name);
    }
    assert!(plain_wrong > rays, "the regimes are no longer hard: the plain formulas are wrong {plain_wrong} times");
}

#[test]
fn a_plane_is_skipped_by_the_exact_slope_where_the_axis_has_no_square() {
    let ray = Ray {
        origin: Vec3::new(hex(0xbf84_1205_bc01_a36e), hex(0xc059_0000_0000_0000), 0.0),
        direction: Vec3::new(hex(0x3e45_0b9b_62c9_2d43), hex(0x3f1a_36e2_eb1c_432d), 0.0),
    };
    let axis = Vec3::new(hex(0x1e60_8e56_3277_847e), 0.0, 0.0);
    let cylinder = Cylinder { center: Vec3::ZERO, radius: 1.0, axis };
    let case = Case::cylinder(cylinder, ray.origin, ray.direction);
    // The slope is 9.8e-9, below the limit of 1e-8 for rays parallel to a cap, so the caps are skipped.
    assert!(ray.direction.x < 1e-8);
    assert!(oracle::judge(&case).truth.is_none());
    assert_eq!(exact_answer(&case), None);
}

#[test]
fn a_coefficient_that_cancels_to_zero_leaves_the_root_its_size() {
    let far = Vec3::new(0.0, 0.0, hex(0x6fb0_7d45_7124_123d));
    let cylinder = Cylinder { center: far, radius: 1.0, axis: Vec3::new(0.0, 0.0, 2.0) };
    let case = Case::cylinder(cylinder, far, Vec3::new(1.0, 0.0, 0.25));
    assert_eq!(exact_answer(&case), Some((1.0, CylinderPart::Side)));
    let case = Case::sphere(far, 2.0, far, Vec3::new(0.0, 4.0, 0.0));
    assert_eq!(exact_answer(&case), Some((0.5, CylinderPart::Side)));
}

#[test]
fn a_surface_at_the_midpoint_below_the_least_lambda_counts() {
    let half_step = (LAMBDA_MIN - LAMBDA_MIN.next_down()) / 2.0;
    let forward = Vec3::new(0.0, 0.0, 1.0);
    // Both objects end at z = 1e-3. The rays start inside, and meet nothing else.
    let cylinder = Cylinder { center: Vec3::ZERO, radius: 1.0, axis: Vec3::new(0.0, 0.0, 2.0 * LAMBDA_MIN) };
    let (center, radius) = (Vec3::new(0.0, 0.0, LAMBDA_MIN - 0.000_976_562_5), 0.000_976_562_5);
    for (start, counts) in [(0.0, true), (half_step, true), (half_step.next_up(), false)] {
        let origin = Vec3::new(0.0, 0.0, start);
        for case in [Case::cylinder(cylinder, origin, forward), Case::sphere(center, radius, origin, forward)] {
            assert_eq!(oracle::judge(&case).truth.is_some(), counts, "the oracle, {case:?}");
            let lambda = exact_answer(&case).map(|(lambda, _)| lambda);
            assert_eq!(lambda, counts.then_some(LAMBDA_MIN), "{case:?}");
        }
    }
}
