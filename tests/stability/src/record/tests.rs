//! Tests that rays in lanes get the answers that each ray gets alone, and that certain answers are those of the plain
//! formulas.

use cpu::internals::exact::{
    cylinder_compensated::CompensatedCaps, cylinder_compensated::CompensatedSide, cylinder_lanes::SideLanes,
    cylinder_plain::PlainCaps, cylinder_plain::PlainSide, cylinder_plain::is_long, error_bound::in_scale,
};
use cpu::internals::simd::portable::Portable;
use cpu::internals::simd::{Simd, SimdF64};

use super::*;
use crate::regimes::{CYLINDERS, Regime, SPHERES};

type Lanes = <Portable as Simd>::F64;
const LANES: usize = Lanes::LANES;

const SEED: u64 = 11;
const CASES: usize = 4_000;

fn lanes(numbers: [f64; LANES]) -> Lanes {
    Lanes::load(&numbers)
}

fn vectors(vectors: [Vec3; LANES]) -> Vec3<Lanes> {
    Vec3::from([0, 1, 2].map(|axis| lanes(vectors.map(|vector| vector.to_array()[axis]))))
}

/// The formulas that run in lanes: the plain ones, for long cylinders or others, or the compensated ones of cylinders.
#[derive(Clone, Copy)]
enum Formulas {
    Plain { is_long: bool },
    Compensated,
}

/// Returns the answers in lanes. The objects must be all spheres or all cylinders.
fn in_lanes(cases: [Case; LANES], formulas: Formulas) -> [Decision<Found>; LANES] {
    let center = vectors(cases.map(|case| case.center()));
    let ray = Ray {
        origin: vectors(cases.map(|case| case.ray.origin)),
        direction: vectors(cases.map(|case| case.ray.direction)),
    };
    let parts = cases.map(|case| match case.shape {
        Shape::Sphere(sphere) => (sphere.radius, Vec3::ZERO),
        Shape::Cylinder(cylinder) => (cylinder.radius, cylinder.axis),
    });
    let radius = lanes(parts.map(|(radius, _)| radius));
    let none = Lanes::of(0.0).less(Lanes::of(0.0));
    let (lambda, certain, bottom, top) = if let Shape::Sphere(_) = cases[0].shape {
        let view = SphereRecord::new(center, radius).seen_from(ray.origin);
        let hits = exact::sphere::filtered_from(&view, ray.direction, ray.direction.dot(ray.direction));
        (hits.lambda, hits.certain, none, none)
    } else {
        let axis = vectors(parts.map(|(_, axis)| axis));
        let record = CylinderRecord::new(center, radius, axis);
        let hits = match formulas {
            Formulas::Plain { is_long } => {
                let side = PlainSide::new(&record, &record.seen_from(ray.origin), &ray, is_long);
                SideLanes::new(&side).with_caps(&record, &ray, &PlainCaps)
            }
            Formulas::Compensated => {
                let side = CompensatedSide::new(&record, axis, &ray);
                SideLanes::new(&side).with_caps(&record, &ray, &CompensatedCaps(axis))
            }
        };
        (hits.lambda, hits.certain, hits.bottom, hits.top)
    };
    let mut lambdas = [0.0; LANES];
    lambda.store(&mut lambdas);
    let [certain, bottom, top] = [certain, bottom, top].map(Lanes::bits);
    std::array::from_fn(|lane| {
        let has = |mask: u32| mask >> lane & 1 == 1;
        let part = match (has(bottom), has(top)) {
            (true, _) => CylinderPart::Bottom,
            (false, true) => CylinderPart::Top,
            (false, false) => CylinderPart::Side,
        };
        let found = (lambdas[lane] < f64::INFINITY).then_some((lambdas[lane], part));
        if has(certain) { Decision::Certain(found) } else { Decision::Uncertain }
    })
}

/// Compares the filter in lanes with the filter for one ray, and certain answers with those of the plain formulas.
fn check(regimes: &[Regime]) {
    let mut certain = [0; 2];
    for cases in regimes.iter().flat_map(|regime| regime.cases(SEED, CASES).as_chunks().0.to_vec()) {
        let either = [false, true].map(|is_long| in_lanes(cases, Formulas::Plain { is_long }));
        for (lane, case) in cases.iter().enumerate() {
            let (record, ray) = case.of();
            let in_lanes = either[usize::from(matches!(&record, Record::Cylinder(record, _) if is_long(record)))][lane];
            assert_eq!(in_lanes, record.filtered(&ray), "{case:?}");
            if let Decision::Certain(answer) = in_lanes {
                assert_eq!(answer, record.plain(&ray), "{case:?}");
            }
            certain[usize::from(in_lanes != Decision::Uncertain)] += 1;
        }
    }
    assert!(certain[0] > CASES / 2 && certain[1] > 2 * CASES, "both kinds of rays must come: {certain:?}");
}

#[test]
fn spheres_in_lanes_are_as_alone_and_certain_answers_are_the_plain_ones() {
    check(&SPHERES);
}

#[test]
fn cylinders_in_lanes_are_as_alone_and_certain_answers_are_the_plain_ones() {
    check(&CYLINDERS);
}

#[test]
fn cylinders_in_lanes_have_the_compensated_answers_of_each_alone() {
    let mut certain = [0; 2];
    for cases in CYLINDERS.iter().flat_map(|regime| regime.cases(SEED, CASES).as_chunks().0.to_vec()) {
        let answers = in_lanes(cases, Formulas::Compensated);
        for (lane, case) in cases.iter().enumerate() {
            let (Record::Cylinder(record, axis), ray) = case.of() else { unreachable!("all are cylinders") };
            // The caller of the lanes checks the scale of the direction.
            if in_scale(ray.direction.dot(ray.direction)) {
                let alone = exact::cylinder::compensated(&record, &axis, &ray);
                assert_eq!(answers[lane], alone, "{case:?}");
                certain[usize::from(alone != Decision::Uncertain)] += 1;
            }
        }
    }
    assert!(certain[0] > CASES / 20 && certain[1] > 2 * CASES, "both kinds of rays must come: {certain:?}");
}
