//! Tests with rays and objects of small whole numbers. Tangents, rims and origins on a surface are frequent, and the
//! oracle's answer is exact.

use cpu::Vec3;
use cpu::internals::input::scene::Cylinder;
use stability::case::Case;
use stability::oracle::{self, Judgement, to_f64};
use stability::random::Random;

const CASES: usize = 200_000;

fn whole(random: &mut Random, most: usize) -> Vec3 {
    Vec3::from([(); 3].map(|()| random.below(2 * most + 1) as f64 - most as f64))
}

/// Returns a random vector of whole numbers that is not zero.
fn some_direction(random: &mut Random, most: usize) -> Vec3 {
    loop {
        let vector = whole(random, most);
        if vector != Vec3::ZERO {
            return vector;
        }
    }
}

/// Returns two random powers of two: the first is a factor for all lengths, the second is a factor for directions.
fn scales(random: &mut Random) -> [f64; 2] {
    [(); 2].map(|()| 2.0_f64.powi(random.below(41) as i32 - 20))
}

/// Whether the exact intersection hits. It must agree with the oracle's answer.
fn hits(case: &Case, judgement: &Judgement) -> bool {
    let (record, ray) = case.of();
    let answer = record.exact(&ray);
    match (&judgement.truth, answer) {
        (Some(truth), Some((lambda, part))) => {
            assert_eq!(part, truth.part, "{case:?}");
            let error = (lambda / to_f64(&truth.lambda) - 1.0).abs();
            assert!(error < 1e-12, "{case:?}: {lambda} is off by {error:e}");
            true
        }
        (None, None) => false,
        (truth, _) => panic!("{case:?}: {answer:?}, in truth {:?}", truth.as_ref().map(|truth| truth.part)),
    }
}

#[test]
fn spheres_of_small_numbers_are_met_rightly() {
    let mut random = Random::new(3);
    let (mut met, mut tangents) = (0, 0);
    for _ in 0..CASES {
        let [scale, length] = scales(&mut random);
        let (center, radius) = (whole(&mut random, 6) * scale, (random.below(6) + 1) as f64 * scale);
        let (origin, direction) = (whole(&mut random, 6) * scale, some_direction(&mut random, 4) * length);
        let case = Case::sphere(center, radius, origin, direction);
        let judgement = oracle::judge(&case);
        met += usize::from(hits(&case, &judgement));
        let crossings = judgement.crossings;
        tangents += usize::from(crossings.len() == 2 && crossings[0] == crossings[1]);
    }
    assert!(met > CASES / 20 && tangents > CASES / 1000, "{met} hits, {tangents} tangents");
}

#[test]
fn cylinders_of_small_numbers_are_met_rightly() {
    let mut random = Random::new(5);
    let (mut met, mut ties) = (0, 0);
    for _ in 0..CASES {
        let [scale, length] = scales(&mut random);
        let radius = (random.below(4) + 1) as f64 * scale;
        // Half of the axes are parallel to a coordinate axis, so that rays hit rims.
        let axis = if random.below(2) == 0 {
            let along = Vec3::new(0.0, (random.below(4) + 1) as f64 * 2.0, 0.0);
            random.shuffled(along)
        } else {
            some_direction(&mut random, 3)
        };
        let cylinder = Cylinder { center: whole(&mut random, 4) * scale, radius, axis: axis * scale };
        let (origin, direction) = (whole(&mut random, 5) * scale, some_direction(&mut random, 3) * length);
        let case = Case::cylinder(cylinder, origin, direction);
        let judgement = oracle::judge(&case);
        met += usize::from(hits(&case, &judgement));
        let crossings = judgement.crossings;
        ties += usize::from(crossings.len() == 4 && crossings[..2].iter().any(|side| crossings[2..].contains(side)));
    }
    assert!(met > CASES / 20 && ties > CASES / 200, "{met} hits, {ties} rims");
}
