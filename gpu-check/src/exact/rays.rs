//! The cases of the exact kernels: those of the plain formulas, and the hard rays of `stability`.

use cpu::internals::input::scene::Shape;
use cpu::internals::sampling::uniform::Uniform;
use stability::case::Case;
use stability::random::Random;
use stability::regimes::near::{self, NearCase};
use stability::regimes::{CYLINDERS, EXTREMES, LIMITS, Regime, SPHERES};

use crate::kernels::{CYLINDER, SPHERE};
use crate::special::{self, Row};
use crate::{Kernel, methods};

/// Numbers for edge cases of products. Neither a product nor its error may leave the range of f64.
const FACTORS: [f64; 12] = [
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
];

/// Returns cases of spheres; see [`super::ExactKernel::cases`].
pub fn spheres(count: usize, seed: u64) -> Vec<f64> {
    let extremes = EXTREMES.iter().chain(&LIMITS).filter(|regime| regime.name.starts_with("spheres"));
    all(&SPHERE, SPHERES.iter().chain(extremes), count, seed)
}

/// Returns cases of cylinders; see [`super::ExactKernel::cases`].
pub fn cylinders(count: usize, seed: u64) -> Vec<f64> {
    let extremes = EXTREMES.iter().chain(&LIMITS).filter(|regime| !regime.name.starts_with("spheres"));
    all(&CYLINDER, CYLINDERS.iter().chain(extremes), count, seed)
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

/// Returns the cases of the plain formula's kernel, and of the regimes.
fn all<'a>(plain: &Kernel, regimes: impl Iterator<Item = &'a Regime>, count: usize, seed: u64) -> Vec<f64> {
    let mut rows = [plain.edge_cases::<f64>(), plain.random_cases(count, seed)].concat();
    for regime in regimes {
        rows.extend(methods::rows::<f64>(&regime.cases(seed, count)));
    }
    rows
}

/// Returns two factors and a term for each case. Half of the terms nearly cancel the product. In a quarter the product
/// has 54 bits and lies in the middle between two numbers of f64, so that a tiny term decides the rounding.
pub fn products(count: usize, seed: u64) -> Vec<f64> {
    let mut rows = Row::default();
    for a in FACTORS {
        for b in FACTORS {
            for c in FACTORS.into_iter().chain([-a * b]) {
                rows.number(a).number(b).number(c);
            }
        }
    }
    let mut draws = Uniform::new(seed);
    for number in 0..count {
        let mut any = |low: f64, high: f64| special::of_any_size(&mut draws, low, high);
        let (mut a, mut b) = (any(-12.0, 12.0), any(-12.0, 12.0));
        let c = match number % 4 {
            0 => any(-30.0, 30.0),
            1 => -a * b,
            2 => -a * b * (1.0 + any(-17.0, 0.0)),
            _ => {
                // Odd numbers of 27 bits.
                let mut odd = || (draws.draw(f64::from(1 << 25), f64::from(1 << 26)) as u32 * 2 + 1).into();
                (a, b) = (odd(), odd());
                if number % 8 == 3 { 0.0 } else { special::of_any_size(&mut draws, -40.0, 2.0) }
            }
        };
        rows.number(a).number(b).number(c);
    }
    rows.0
}
