//! Regimes with cases at the limits of the specification, exactly or within a relative difference of 10^-17 to 10^-6: a
//! surface at the least lambda, 10^-3, and a cap at the slope 10^-8, below which it is skipped. In regimes of small
//! whole numbers, tangents, rims and origins on a surface are frequent.

use cpu::Vec3;
use cpu::internals::geometry::cap::PARALLEL;
use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::internals::input::scene::Cylinder;

use super::Regime;
use crate::case::Case;
use crate::random::Random;

/// The regimes.
pub const REGIMES: [Regime; 6] = [
    Regime { name: "spheres at the least lambda", draw: spheres },
    Regime { name: "cylinders at the least lambda", draw: cylinders },
    Regime { name: "caps at the least lambda, in round decimals", draw: decimal_caps },
    Regime { name: "caps at the smallest slope", draw: slopes },
    Regime { name: "spheres of small whole numbers", draw: whole_spheres },
    Regime { name: "cylinders of small whole numbers", draw: whole_cylinders },
];

/// Returns a random factor that is 1 or differs from 1 by 10^-17 to 10^-10.
fn almost_one(random: &mut Random) -> f64 {
    if random.below(4) == 0 { 1.0 } else { 1.0 + random.sign() * random.decades(-17.0, -10.0) }
}

/// Returns the origin and the direction of a ray whose point at the least lambda, or nearly there, is `point`.
fn reaching(random: &mut Random, point: Vec3, direction: Vec3) -> (Vec3, Vec3) {
    let direction = direction * random.decades(-3.0, 6.0);
    let origin = point - direction * (LAMBDA_MIN * almost_one(random));
    (random.nudged_vector(origin, 2), direction)
}

fn spheres(random: &mut Random) -> Case {
    if random.below(3) == 0 {
        // A camera at the origin of coordinates sees a sphere at a thousandth of the target's distance.
        let (distance, radius) = ((random.below(60) + 1) as f64 / 10.0, random.length());
        let center = Vec3::new(0.0, 0.0, distance + random.sign() * radius);
        let (sign, axis) = (random.sign(), random.below(6) as u64 + 1);
        let turned = |vector: Vec3| Random::new(axis).shuffled(vector) * sign;
        let far = random.nudged(distance * 1000.0, 2);
        return Case::sphere(turned(center), radius, Vec3::ZERO, turned(Vec3::new(0.0, 0.0, far)));
    }
    let (center, radius, up) = (random.cube(10.0), random.length(), random.unit());
    let (origin, direction) = (center + up * radius, random.unit());
    let (origin, direction) = reaching(random, origin, direction);
    Case::sphere(center, radius, origin, direction)
}

fn cylinder(random: &mut Random) -> Cylinder {
    let (center, radius, height) = (random.cube(10.0), random.length(), random.length());
    Cylinder { center, radius, axis: random.unit() * height }
}

fn cylinders(random: &mut Random) -> Case {
    let cylinder = cylinder(random);
    let (around, along) = match random.below(3) {
        0 => (1.0, random.uniform(-1.0, 1.0)),
        _ => (random.uniform(0.0, 1.0), random.sign()),
    };
    let across = random.perpendicular(cylinder.axis) * (cylinder.radius * around);
    let (point, direction) = (cylinder.center + cylinder.axis * (along / 2.0) + across, random.unit());
    let (origin, direction) = reaching(random, point, direction);
    Case::cylinder(cylinder, origin, direction)
}

/// Returns a ray from the origin of coordinates to a cap at a thousandth of the target's distance, or within some units
/// in the last place. The cap is hit from outside or inside. The distance and the height are round decimals.
fn decimal_caps(random: &mut Random) -> Case {
    let (distance, radius) = ((random.below(60) + 1) as f64 / 10.0, random.length());
    let half = random.sign() * (random.below(40) + 1) as f64 / 10.0;
    let (sign, axis) = (random.sign(), random.below(6) as u64 + 1);
    let turned = |vector: Vec3| Random::new(axis).shuffled(vector) * sign;
    let target = Vec3::new(0.0, 0.0, random.nudged(distance * 1000.0, 2));
    let (center, axis) = (Vec3::new(0.0, 0.0, distance + half), Vec3::new(0.0, 0.0, 2.0 * half));
    Case::cylinder(Cylinder { center: turned(center), radius, axis: turned(axis) }, Vec3::ZERO, turned(target))
}

/// Returns a ray that is nearly parallel to the caps. The component of its direction along the axis is 10^-8 within the
/// rounding of the dot product. It crosses a cap's plane on the disc.
fn slopes(random: &mut Random) -> Case {
    let cylinder = Cylinder { center: random.cube(1.0), ..cylinder(random) };
    let (unit, across) = (cylinder.axis.unit(), random.perpendicular(cylinder.axis));
    let (size, end) = (random.decades(-6.0, 0.0), random.sign());
    let slope = PARALLEL * (1.0 + random.sign() * random.decades(-12.0, -6.0) * size.max(1e-4)) * random.sign();
    // The ray starts near the disc's middle, at a distance from the plane that it covers within the disc.
    let lambda = cylinder.radius / size * random.uniform(0.05, 0.6);
    let cap = cylinder.center + cylinder.axis * (end / 2.0);
    let origin = cap - across * (cylinder.radius * random.uniform(0.0, 0.3)) - unit * (slope * lambda);
    Case::cylinder(cylinder, origin, across * size + unit * slope)
}

/// Returns a vector of whole numbers of at most this magnitude, which is not zero.
fn whole(random: &mut Random, most: usize) -> Vec3 {
    loop {
        let vector = Vec3::from([(); 3].map(|()| random.below(2 * most + 1) as f64 - most as f64));
        if vector != Vec3::ZERO {
            return vector;
        }
    }
}

/// Returns two powers of two: a factor for all lengths, and one for directions.
fn scales(random: &mut Random) -> [f64; 2] {
    [(); 2].map(|()| 2.0_f64.powi(random.below(41) as i32 - 20))
}

fn whole_spheres(random: &mut Random) -> Case {
    let ([scale, length], radius) = (scales(random), (random.below(6) + 1) as f64);
    let [center, origin] = [(); 2].map(|()| whole(random, 6) * scale);
    Case::sphere(center, radius * scale, origin, whole(random, 4) * length)
}

fn whole_cylinders(random: &mut Random) -> Case {
    let ([scale, length], radius) = (scales(random), (random.below(4) + 1) as f64);
    // Half of the axes are parallel to a coordinate axis, so that rays hit rims.
    let along = Vec3::new(0.0, (random.below(4) + 1) as f64 * 2.0, 0.0);
    let axis = if random.below(2) == 0 { random.shuffled(along) } else { whole(random, 3) } * scale;
    let cylinder = Cylinder { center: whole(random, 4) * scale, radius: radius * scale, axis };
    let origin = whole(random, 5) * scale;
    Case::cylinder(cylinder, origin, whole(random, 3) * length)
}
