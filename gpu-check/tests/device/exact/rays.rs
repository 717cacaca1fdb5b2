//! The cases of the exact kernels: those of the plain formulas, and the hard rays of `stability`.

use cpu::internals::input::scene::{Cylinder, Shape};
use gpu_check::methods;
use stability::case::Case;
use stability::random::Random;
use stability::regimes::near::{self, NearCase};
use stability::regimes::{CYLINDERS, EXTREMES, LIMITS, Regime, SPHERES};

use crate::kernels;
use crate::kernels::of_regimes;
use crate::kernels::special::{Row, any_size, rows};

/// Numbers for edge cases of products. The last one overflows if WGSL splits it without scaling it first.
const FACTORS: [f64; 13] = [
    0.0,
    1.0,
    -1.0,
    0.1,
    -3.0,
    1e-3,
    1e8,
    -1e12,
    1e150,
    1.000_000_000_000_000_2,
    0.999_999_999_999_999_9,
    134_217_729.0,
    1e302,
];

/// Returns the extreme regimes of spheres, or those of cylinders.
fn extremes(of_spheres: bool) -> impl Iterator<Item = &'static Regime> {
    EXTREMES.iter().chain(&LIMITS).filter(move |regime| regime.name.starts_with("spheres") == of_spheres)
}

/// Returns `count` cases of each regime of spheres, and the edge cases.
pub fn spheres(count: usize, seed: u64) -> Vec<f64> {
    [kernels::spheres(SPHERES.len() * count, seed), of_regimes(extremes(true), count, seed)].concat()
}

/// Returns `count` cases of each regime of cylinders, and the edge cases.
pub fn cylinders(count: usize, seed: u64) -> Vec<f64> {
    let others = of_regimes(extremes(false).chain(&COMPENSATED), count, seed);
    [kernels::cylinders(CYLINDERS.len() * count, seed), others].concat()
}

/// Long, wide and far cylinders. The plain formula is uncertain about many of their rays, and the compensated formula
/// decides most of those.
const COMPENSATED: [Regime; 3] = [
    Regime { name: "nearly along a long cylinder", draw: along_a_long_one },
    Regime { name: "near the side of a wide cylinder", draw: near_a_wide_side },
    Regime { name: "from far away", draw: far_away },
];

/// Returns a ray that runs nearly along the axis, inside a cylinder or beside it.
fn along_a_long_one(random: &mut Random) -> Case {
    let (center, radius, axis) = (random.cube(10.0), random.decades(-2.0, 1.0), random.unit());
    let height = radius * random.decades(1.5, 5.0);
    let (around, along) = (random.uniform(0.0, 1.2) * radius, random.uniform(-0.6, 0.6) * height);
    let origin = center + random.perpendicular(axis) * around + axis * along;
    let direction = axis * random.sign() + random.perpendicular(axis) * random.decades(-6.0, -1.0);
    Case::cylinder(Cylinder { center, radius, axis: axis * height }, origin, direction)
}

/// Returns a ray that starts near the side of a cylinder, which is as flat as a floor there, and near the origin of
/// coordinates.
fn near_a_wide_side(random: &mut Random) -> Case {
    let (radius, axis) = (random.decades(4.0, 9.0), random.unit());
    let (up, height) = (random.perpendicular(axis), radius * random.decades(-1.0, 1.0));
    let center = up * -radius + axis * (height * random.uniform(-0.5, 0.5));
    let origin = random.cube(1.0) + up * (random.sign() * random.decades(-3.0, 2.0));
    Case::cylinder(Cylinder { center, radius, axis: axis * height }, origin, random.unit())
}

/// Returns a ray that starts far away from a cylinder, and hits it or passes near it.
fn far_away(random: &mut Random) -> Case {
    let (center, radius, axis) = (random.cube(10.0), random.uniform(0.1, 2.0), random.unit());
    let height = random.uniform(0.2, 5.0);
    let (around, along) = (random.uniform(0.0, 1.3) * radius, random.uniform(-0.6, 0.6) * height);
    let target = center + random.perpendicular(axis) * around + axis * along;
    let direction = random.unit();
    let origin = target - direction * random.decades(4.0, 8.0);
    Case::cylinder(Cylinder { center, radius, axis: axis * height }, origin, direction)
}

/// Returns rays with two spheres that they hit at nearly the same lambda, from the regimes of several near objects.
pub fn two_spheres(count: usize, seed: u64) -> Vec<f64> {
    let (mut random, mut rows) = (Random::new(seed), Vec::new());
    for _ in 0..count {
        for (_, draw) in near::REGIMES {
            let NearCase { shapes, ray } = draw(&mut random);
            let spheres: Vec<_> = shapes.into_iter().filter(|shape| matches!(shape, Shape::Sphere(_))).collect();
            if let [first, second, ..] = spheres[..] {
                rows.extend(methods::rows::<f64>(&[Case { shape: first, ray }]));
                // The ray stands before the first sphere only.
                rows.extend(&methods::rows::<f64>(&[Case { shape: second, ray }])[6..]);
            }
        }
    }
    rows
}

/// Returns two factors and a term for each case. Half of the terms nearly cancel the product. In a quarter the product
/// has 54 bits and lies in the middle between two numbers of f64, so that a tiny term decides the rounding.
pub fn products(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        for (a, b) in FACTORS.into_iter().flat_map(|a| FACTORS.map(|b| (a, b))) {
            // Neither a product nor its error may leave the range of f64.
            if (a * b).is_finite() {
                FACTORS.into_iter().chain([-a * b]).for_each(|c| rows.0.extend([a, b, c]));
            }
        }
    };
    rows(count, seed, edges, |random, row| {
        let (mut a, mut b) = (any_size(random, -12.0, 12.0), any_size(random, -12.0, 12.0));
        let c = match random.below(8) {
            0 | 1 => any_size(random, -30.0, 30.0),
            2 | 3 => -a * b,
            4 | 5 => -a * b * (1.0 + any_size(random, -17.0, 0.0)),
            kind => {
                // Odd numbers of 27 bits.
                let mut odd = || ((random.below(1 << 25) + (1 << 25)) * 2 + 1) as f64;
                (a, b) = (odd(), odd());
                if kind == 6 { 0.0 } else { any_size(random, -40.0, 2.0) }
            }
        };
        row.0.extend([a, b, c]);
    })
}
