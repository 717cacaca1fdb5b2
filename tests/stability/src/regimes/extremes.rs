//! Regimes with magnitudes from 10^-162 to 10^150, for tests of the exact intersections of `cpu`.
//!
//! The other regimes have magnitudes that f32 can represent too, because WGSL is tested with them. In the regimes here,
//! squares of lengths underflow or nearly overflow, directions have any length, and terms cancel to exactly zero.

use cpu::Vec3;
use cpu::internals::input::scene::Cylinder;

use super::Regime;
use crate::case::Case;
use crate::random::Random;

/// The regimes: first those of spheres, then those of cylinders.
pub const REGIMES: [Regime; 6] = [
    Regime { name: "spheres of any magnitude", draw: spheres },
    Regime { name: "spheres, terms that cancel to zero", draw: cancelling_spheres },
    Regime { name: "cylinders of any magnitude", draw: cylinders },
    Regime { name: "axes whose square underflows", draw: short_axes },
    Regime { name: "sides of huge cylinders, long directions", draw: long_directions },
    Regime { name: "cylinders, terms that cancel to zero", draw: cancelling_cylinders },
];

/// Returns a random length from 10^-155 to 10^150. Its square in f64 is neither 0 nor infinite, but may have lost
/// digits.
fn scale(random: &mut Random) -> f64 {
    random.decades(-155.0, 150.0)
}

/// Returns the origin and the direction of a random ray. It starts at `distance` from `target`, and reaches it at a
/// lambda from 10^-4 to 10^6.
fn toward(random: &mut Random, target: Vec3, distance: f64) -> (Vec3, Vec3) {
    let forward = random.unit() * distance;
    let lambda = random.decades(-4.0, 6.0);
    (target - forward, forward / lambda)
}

/// Returns a random length that is at most `decades` powers of ten above or below `size`.
fn near(random: &mut Random, size: f64, decades: f64) -> f64 {
    size * random.decades(-decades, decades)
}

fn spheres(random: &mut Random) -> Case {
    let size = scale(random);
    let (center, radius) = (random.cube(size), near(random, size, 4.0));
    let (off, distance) = (1.0 + random.sign() * random.decades(-17.0, 0.0), near(random, radius, 4.0));
    let aside = random.unit() * (radius * off);
    let (origin, direction) = toward(random, center + aside, distance);
    Case::sphere(center, radius, origin, direction)
}

fn cylinder(random: &mut Random, size: f64, height: f64) -> Cylinder {
    Cylinder { center: random.cube(size), radius: near(random, size, 3.0), axis: random.unit() * height }
}

/// Returns a random ray towards a point at or near the side, a cap or the rim.
fn aimed(random: &mut Random, cylinder: Cylinder) -> Case {
    let edge = 1.0 + random.sign() * random.decades(-17.0, 0.0);
    let (around, along) = match random.below(3) {
        0 => (edge, random.uniform(-1.1, 1.1)),
        1 => (random.uniform(0.0, 1.1), edge * random.sign()),
        _ => (edge, edge * random.sign()),
    };
    // `Vec3::unit` cannot be used here, because the square of the axis may underflow.
    let unit = cylinder.axis.unit_and_length().0;
    let across = random.perpendicular(unit) * (cylinder.radius * around);
    let target = cylinder.center + cylinder.axis * (along / 2.0) + across;
    let distance = near(random, cylinder.radius, 4.0);
    let (origin, direction) = toward(random, target, distance);
    Case::cylinder(cylinder, origin, direction)
}

fn cylinders(random: &mut Random) -> Case {
    let size = scale(random);
    let height = near(random, size, 3.0).max(1e-161);
    let cylinder = cylinder(random, size, height);
    aimed(random, cylinder)
}

fn short_axes(random: &mut Random) -> Case {
    let height = random.decades(-161.9, -135.0);
    let size = if random.below(2) == 0 { random.decades(-6.0, 6.0) } else { near(random, height, 6.0) };
    let cylinder = cylinder(random, size, height);
    let mut case = aimed(random, cylinder);
    // In half of the cases the axis is parallel to a coordinate axis.
    if random.below(2) == 0 {
        let axis = random.shuffled(Vec3::new(height, 0.0, 0.0));
        case = aimed(random, Cylinder { axis, ..cylinder });
    }
    case
}

fn long_directions(random: &mut Random) -> Case {
    let radius = random.decades(2.0, 9.0);
    let height = near(random, radius, 2.0);
    let cylinder = Cylinder { center: random.cube(radius), radius, axis: random.unit() * height };
    let around = random.unit() * radius;
    let origin = cylinder.center + around.perpendicular_to(cylinder.axis.unit());
    // Refractive surfaces scatter along such directions, because the side's normal in their formula is as long as the
    // radius.
    let direction = random.unit() * (radius * radius * random.decades(-6.0, 6.0));
    Case::cylinder(cylinder, origin, direction)
}

/// Returns a random point whose coordinates are 0 or have magnitudes from 10^-60 to 10^140. Smaller coordinates are
/// left out, because the oracle treats numbers that agree in 1,000 bits as equal: beside 1, fourth powers of smaller
/// coordinates would be lost.
fn far_point(random: &mut Random) -> Vec3 {
    let mut far = || if random.below(2) == 0 { 0.0 } else { random.sign() * random.decades(-60.0, 140.0) };
    Vec3::new(far(), far(), far())
}

/// Returns a random vector other than zero. Its components have few binary digits and are often 0.
fn plain_vector(random: &mut Random) -> Vec3 {
    loop {
        let mut component = || random.sign() * [0.0, 0.0, 0.25, 0.5, 1.0, 1.5, 2.0][random.below(7)];
        let vector = Vec3::new(component(), component(), component());
        if vector != Vec3::ZERO {
            return vector;
        }
    }
}

fn cancelling_spheres(random: &mut Random) -> Case {
    let center = far_point(random);
    let origin = if random.below(2) == 0 { center } else { center + plain_vector(random) };
    Case::sphere(center, [0.5, 1.0, 2.0, 2.5][random.below(4)], origin, plain_vector(random))
}

fn cancelling_cylinders(random: &mut Random) -> Case {
    let center = far_point(random);
    let origin = if random.below(2) == 0 { center } else { center + plain_vector(random) };
    let (radius, axis) = ([0.5, 1.0, 2.0][random.below(3)], plain_vector(random) * 2.0);
    Case::cylinder(Cylinder { center, radius, axis }, origin, plain_vector(random))
}
