//! Compares the closest of several near hits with exact arithmetic.
//!
//! The variable RENDER_CASES sets the number of cases of each regime, and RENDER_SEED sets another seed.

use cpu::internals::accel::closest_hit::ClosestHit;
use cpu::internals::accel::every_object::intersect_every_object;
use cpu::internals::accel::object::file_index_of;
use cpu::internals::exact::order::is_certainly_closer;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::geometry::tie::{is_closer, rank};
use cpu::internals::input::scene::Object;
use cpu::internals::layout::{Objects, aos::AosObjects};
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
    hit.is_hit().then(|| (file_index_of(&objects, hit.object) as usize, hit.part))
}

/// Returns what [`found`] would return if it compared the rounded lambdas.
fn found_by_rounded_lambdas(NearCase { shapes, ray }: &NearCase) -> Option<(usize, CylinderPart)> {
    let mut closest: Option<((f64, i64), usize, CylinderPart)> = None;
    for (order, &shape) in shapes.iter().enumerate() {
        let (record, ray) = Case { shape, ray: *ray }.of();
        let Some((lambda, part)) = record.exact(&ray) else { continue };
        let hit = (lambda, rank(order as u32, part != CylinderPart::Side));
        if closest.is_none_or(|(best, ..)| is_closer(hit, best)) {
            closest = Some((hit, order, part));
        }
    }
    closest.map(|(_, order, part)| (order, part))
}

/// Whether the lambdas decide as they are which of the first two objects is closer. The result is `None` unless the ray
/// hits both.
fn lambdas_decide(NearCase { shapes, ray }: &NearCase) -> Option<bool> {
    let case = |index: usize| Case { shape: shapes[index], ray: *ray };
    let lambdas = [0, 1].map(|index| {
        let (record, ray) = case(index).of();
        record.exact(&ray).map(|(lambda, _)| lambda)
    });
    let [Some(first), Some(second)] = lambdas else { return None };
    Some(is_certainly_closer(first, second) || is_certainly_closer(second, first))
}

#[test]
fn the_closest_of_near_surfaces_is_the_closest() {
    let (cases, seed) = (number("RENDER_CASES", CASES), number("RENDER_SEED", 3));
    for (name, draw) in REGIMES {
        let mut random = Random::new(seed);
        let (mut hits, mut wrong, mut decided) = (0, 0, [0; 2]);
        for _ in 0..cases {
            let case = draw(&mut random);
            let closest = oracle::closest(&case.shapes, &case.ray);
            assert_eq!(found(&case), closest, "{name}: {case:?}");
            hits += u64::from(closest.is_some());
            wrong += u64::from(found_by_rounded_lambdas(&case) != closest);
            if let Some(decides) = lambdas_decide(&case) {
                decided[usize::from(decides)] += 1;
            }
        }
        let [later, plainly] = decided;
        println!("{name}: {hits} hits of {cases}, rounded lambdas are wrong in {wrong}");
        println!("the first two objects: compared as they are {plainly}, in other steps {later}");
        assert!(3 * hits > cases && 50 * wrong > hits, "{name} is not hard: {hits} hits of {cases}, {wrong} wrong");
    }
}
