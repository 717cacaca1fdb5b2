//! The regimes of spheres. Lengths are in scene units. Directions have length one, unless a regime varies the length.

use cpu::Vec3;

use super::Regime;
use crate::case::Case;
use crate::random::Random;

pub const REGIMES: [Regime; 9] = [
    Regime { name: "ordinary", draw: ordinary },
    Regime { name: "far and small", draw: far_and_small },
    Regime { name: "huge and near", draw: huge_and_near },
    Regime { name: "grazing", draw: grazing },
    Regime { name: "tangent to the last bit", draw: tangent },
    Regime { name: "origin on the surface", draw: on_the_surface },
    Regime { name: "inside and at the centre", draw: inside },
    Regime { name: "direction lengths", draw: direction_lengths },
    Regime { name: "everything at once", draw: everything },
];

/// Returns a ray whose line passes the centre at the distance of `off` radii. The ray starts `distance` before the
/// point nearest to the centre, and its direction has the length `length`.
fn passing(random: &mut Random, center: Vec3, radius: f64, distance: f64, off: f64, length: f64) -> Case {
    let forward = random.unit();
    let target = center + random.perpendicular(forward) * (radius * off);
    Case::sphere(center, radius, target - forward * distance, forward * length)
}

fn ordinary(random: &mut Random) -> Case {
    let (center, radius, distance) = (random.cube(10.0), random.uniform(0.1, 2.0), random.uniform(2.5, 30.0));
    let off = random.uniform(0.0, 1.5);
    passing(random, center, radius, distance, off, 1.0)
}

fn far_and_small(random: &mut Random) -> Case {
    let (radius, distance) = (random.decades(-6.0, 0.0), random.decades(2.0, 12.0));
    let off = random.uniform(0.0, 1.5);
    if random.below(2) == 0 {
        let center = random.cube(1.0);
        return passing(random, center, radius, distance, off, 1.0);
    }
    // A far ray with rounded coordinates would miss a small object, unless its direction is along a coordinate axis.
    let (near, far) = (random.unit() * (radius * off), distance * random.sign());
    let direction = Vec3::new(0.0, 0.0, -far.signum() * random.uniform(0.5, 2.0));
    let swap = random.below(3);
    let rotate = |vector: Vec3| {
        let mut components = vector.to_array();
        components.rotate_left(swap);
        Vec3::from(components)
    };
    Case::sphere(Vec3::ZERO, radius, rotate(Vec3::new(near.x, near.y, far)), rotate(direction))
}

fn huge_and_near(random: &mut Random) -> Case {
    let radius = random.decades(3.0, 9.0);
    let up = if random.below(2) == 0 { Vec3::new(0.0, 1.0, 0.0) } else { random.unit() };
    let height = random.decades(-4.0, 2.0) * random.sign();
    let origin = random.cube(10.0).perpendicular_to(up) + up * height;
    let direction = random.unit();
    Case::sphere(up * -radius, radius, origin, direction)
}

/// Returns 1 plus or minus a random number from 10^-16 to 1.
fn almost_one(random: &mut Random) -> f64 {
    1.0 + random.sign() * random.decades(-16.0, 0.0)
}

fn grazing(random: &mut Random) -> Case {
    let (center, radius, distance) = (random.cube(10.0), random.decades(-1.0, 1.0), random.decades(0.0, 2.0));
    let off = almost_one(random);
    passing(random, center, radius, radius + distance, off, 1.0)
}

/// Returns a tangent that f64 represents exactly, or a ray one unit in the last place beside such a tangent. The
/// direction is along a coordinate axis or along (3, 4, 0).
fn tangent(random: &mut Random) -> Case {
    // Numbers with few digits, so that sums of their products are exact.
    let short = |random: &mut Random, extent: f64| (random.uniform(-extent, extent) * 1024.0).round() / 1024.0;
    let center = Vec3::from([(); 3].map(|()| short(random, 16.0)));
    let radius = 5.0 * (short(random, 1.0).abs() + 1.0 / 1024.0);
    let distance = short(random, 256.0).abs() + 16.0;
    let (forward, across) = if random.below(2) == 0 {
        (Vec3::new(0.0, 0.0, 5.0), Vec3::new(5.0, 0.0, 0.0))
    } else {
        (Vec3::new(3.0, 4.0, 0.0), Vec3::new(4.0, -3.0, 0.0))
    };
    let origin = center + across * (radius / 5.0) - forward * distance;
    let radius = random.nudged(radius, 1);
    let origin = Vec3::new(random.nudged(origin.x, 1), origin.y, origin.z);
    let case = Case::sphere(center, radius, origin, forward);
    let seed = random.below(6);
    shuffled(case, seed)
}

/// Returns the case with the components of all vectors in another order, which depends only on `seed`.
fn shuffled(case: Case, seed: usize) -> Case {
    let exchange = |vector: Vec3| Random::new(seed as u64 + 1).shuffled(vector);
    let cpu::internals::input::scene::Shape::Sphere(sphere) = case.shape else { return case };
    Case::sphere(exchange(sphere.center), sphere.radius, exchange(case.ray.origin), exchange(case.ray.direction))
}

/// Returns a secondary ray: from a point on the sphere, in any direction.
fn on_the_surface(random: &mut Random) -> Case {
    let (center, radius) = (random.cube(10.0), random.decades(-2.0, 4.0));
    leaving(random, center, radius, 1.0)
}

fn leaving(random: &mut Random, center: Vec3, radius: f64, length: f64) -> Case {
    let up = random.unit();
    let origin = center + up * radius;
    let direction = if random.below(4) == 0 {
        // A direction nearly along the surface.
        random.perpendicular(up) + up * (random.sign() * random.decades(-16.0, 0.0))
    } else {
        up * random.sign() + random.cube(1.0)
    };
    Case::sphere(center, radius, origin, direction * (length * random.uniform(0.5, 2.0)))
}

fn inside(random: &mut Random) -> Case {
    let (center, radius, direction) = (random.cube(10.0), random.decades(-2.0, 4.0), random.unit());
    let origin = if random.below(4) == 0 { center } else { center + random.unit() * random.uniform(0.0, radius) };
    Case::sphere(center, radius, origin, direction)
}

fn direction_lengths(random: &mut Random) -> Case {
    let Case { shape, mut ray } = ordinary(random);
    ray.direction = ray.direction * random.decades(-6.0, 6.0);
    Case { shape, ray }
}

fn everything(random: &mut Random) -> Case {
    let (radius, length) = (random.decades(-6.0, 9.0), random.decades(-6.0, 6.0));
    let extent = random.decades(-6.0, 9.0);
    let center = random.cube(extent);
    match random.below(4) {
        0 => leaving(random, center, radius, length),
        1 => {
            let (origin, direction) = (center + random.unit() * (radius * random.uniform(0.0, 1.0)), random.unit());
            Case::sphere(center, radius, origin, direction * length)
        }
        kind => {
            let distance = radius + random.decades(-2.0, 12.0);
            let off = if kind == 2 { almost_one(random) } else { random.uniform(0.0, 1.5) };
            passing(random, center, radius, distance, off, length)
        }
    }
}

/// Returns `count` random rays that leave a sphere of this radius, outwards or inwards. They start near the origin of
/// coordinates, through which the sphere's surface passes.
#[must_use]
pub fn large(radius: f64, seed: u64, count: usize) -> Vec<Case> {
    let mut random = Random::new(seed);
    let center = Vec3::new(0.0, -radius, 0.0);
    let mut draw = || {
        let extent = radius.min(10.0) * 0.5;
        let (x, z) = (random.uniform(-extent, extent), random.uniform(-extent, extent));
        let across = x * x + z * z;
        // Equals sqrt(r^2 - across) - r, but nothing cancels.
        let y = -across / (radius + (radius * radius - across).sqrt());
        let origin = Vec3::new(x, y, z);
        let outward = (origin - center) / radius;
        let direction = outward * random.sign() + random.cube(1.0);
        Case::sphere(center, radius, origin, direction)
    };
    (0..count).map(|_| draw()).collect()
}
