//! Compares the closest of several near hits with exact arithmetic.
//!
//! The variable RENDER_NEAR_CASES sets the number of cases of each regime, and RENDER_REGIME_SEED sets another seed.

use cpu::internals::accel::closest_hit::ClosestHit;
use cpu::internals::accel::every_object::intersect_every_object;
use cpu::internals::accel::object::order_of;
use cpu::internals::exact::error_bound::Decision;
use cpu::internals::exact::order::is_certainly_closer;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::geometry::tie::{Place, is_closer};
use cpu::internals::input::scene::Object;
use cpu::internals::layout::{Objects, aos::AosObjects};
use cpu::internals::math::double_double::DoubleDouble;
use cpu::{Material, Scene, Vec3};
use stability::case::Case;
use stability::oracle;
use stability::random::Random;
use stability::regimes::near::{NearCase, REGIMES};

use crate::extremes::number;

const CASES: u64 = 4_000;

/// Returns the place of the closest hit and its part, by the renderer.
fn found(NearCase { shapes, ray }: &NearCase) -> Option<(usize, CylinderPart)> {
    let objects = shapes.iter().map(|&shape| Object { shape, material: 0 }).collect();
    let scene = Scene { materials: vec![Material::Matte { reflectance: Vec3::ONE }], objects };
    let objects = AosObjects::build(&scene).expect("it fits");
    let hit: ClosestHit = intersect_every_object(&objects, *ray);
    hit.is_hit().then(|| (order_of(&objects, hit.object) as usize, hit.part))
}

/// Returns what [`found`] would return if it compared the rounded lambdas.
fn found_by_rounded_lambdas(NearCase { shapes, ray }: &NearCase) -> Option<(usize, CylinderPart)> {
    let mut closest = None;
    for (order, &shape) in shapes.iter().enumerate() {
        let (record, ray) = Case { shape, ray: *ray }.of();
        let Some((lambda, part)) = record.exact(&ray) else { continue };
        let place = Place { order: order as u32, on_cap: part != CylinderPart::Side };
        if closest.is_none_or(|(best, _)| is_closer((lambda, place), best)) {
            closest = Some(((lambda, place), part));
        }
    }
    closest.map(|((_, place), part)| (place.order as usize, part))
}

/// Returns the step that decides which of the first two objects is closer: 0 if the lambdas decide as they are, 1 for
/// double-double, and 2 for exact arithmetic. The result is `None` unless the ray hits both.
fn step(NearCase { shapes, ray }: &NearCase) -> Option<usize> {
    let case = |index: usize| Case { shape: shapes[index], ray: *ray };
    let lambdas = [0, 1].map(|index| {
        let (record, ray) = case(index).of();
        record.exact(&ray).map(|(lambda, _)| lambda)
    });
    let [Some(first), Some(second)] = lambdas else { return None };
    if is_certainly_closer(first, second) || is_certainly_closer(second, first) {
        return Some(0);
    }
    let doubled = [0, 1].map(|index| {
        let (record, ray) = case(index).of::<DoubleDouble>();
        record.filtered(&ray)
    });
    let [Decision::Certain(Some((first, _))), Decision::Certain(Some((second, _)))] = doubled else { return Some(2) };
    Some(if is_certainly_closer(first, second) || is_certainly_closer(second, first) { 1 } else { 2 })
}

#[test]
fn the_closest_of_near_surfaces_is_the_closest() {
    let (cases, seed) = (number("RENDER_NEAR_CASES", CASES), number("RENDER_REGIME_SEED", 3));
    for (name, draw) in REGIMES {
        let mut random = Random::new(seed);
        let (mut hits, mut wrong, mut steps) = (0, 0, [0; 3]);
        for _ in 0..cases {
            let case = draw(&mut random);
            let closest = oracle::closest(&case.shapes, &case.ray);
            assert_eq!(found(&case), closest, "{name}: {case:?}");
            hits += u64::from(closest.is_some());
            wrong += u64::from(found_by_rounded_lambdas(&case) != closest);
            if let Some(step) = step(&case) {
                steps[step] += 1;
            }
        }
        let [plain, doubled, exact] = steps;
        println!("{name}: {hits} hits of {cases}, rounded lambdas are wrong in {wrong}");
        println!("the first two objects: compared as they are {plain}, in double-double {doubled}, exactly {exact}");
        assert!(3 * hits > cases && 50 * wrong > hits, "{name} is not hard: {hits} hits of {cases}, {wrong} wrong");
    }
}
