//! Regimes of several objects that a ray hits at nearly or exactly the same lambda. The objects come in random order.

use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::{Ray, Vec3};

use crate::random::Random;

/// A regime of several objects, with its name.
pub type NearRegime = (&'static str, fn(&mut Random) -> NearCase);

/// One ray and the objects near each other that it may hit.
#[derive(Clone, Debug)]
pub struct NearCase {
    /// The objects, in the order of the scene file.
    pub shapes: Vec<Shape>,
    /// The ray.
    pub ray: Ray,
}

/// All regimes.
pub const REGIMES: [NearRegime; 6] = [
    ("shells", shells),
    ("touching spheres", touching),
    ("coplanar straight caps", |random| coplanar(random, true)),
    ("coplanar tilted caps", |random| coplanar(random, false)),
    ("surfaces through a rim", through_a_rim),
    ("nearly identical objects", nearly_identical),
];

fn sphere(center: Vec3, radius: f64) -> Shape {
    Shape::Sphere(Sphere { center, radius })
}

fn cylinder(center: Vec3, radius: f64, axis: Vec3) -> Shape {
    Shape::Cylinder(Cylinder { center, radius, axis })
}

/// Returns a ray towards `target`, which starts at `distance` from it, and the objects in random order.
fn seen(random: &mut Random, mut shapes: Vec<Shape>, target: Vec3, from: Vec3, distance: f64) -> NearCase {
    for last in (1..shapes.len()).rev() {
        shapes.swap(last, random.below(last + 1));
    }
    let direction = -from * random.decades(-1.0, 1.0);
    NearCase { shapes, ray: Ray { origin: target + from * distance, direction } }
}

/// Two to four spheres in each other, with gaps of 10^-16 to 10^-4 radii, from distances of 1.3 to 10^9 radii.
fn shells(random: &mut Random) -> NearCase {
    let (center, radius) = (random.cube(10.0), random.length());
    let mut shapes = vec![sphere(center, radius)];
    for _ in 0..1 + random.below(3) {
        let gap = radius * random.decades(-16.0, -4.0);
        // Half of the shells touch the outermost one.
        let aside = if random.below(2) == 0 { Vec3::ZERO } else { random.unit() * gap };
        shapes.push(sphere(center + aside, radius - gap));
    }
    let (from, off) = (random.unit(), random.uniform(0.0, 0.99));
    let target = center + random.perpendicular(from) * (off * radius);
    let distance = radius * random.decades(0.1, 9.0);
    seen(random, shapes, target, from, distance)
}

/// Two spheres that touch each other from outside or inside. The ray goes towards the point where they touch.
fn touching(random: &mut Random) -> NearCase {
    let (center, up, radius, other) = (random.cube(10.0), random.unit(), random.length(), random.length());
    let point = center + up * radius;
    let second = sphere(point + up * (other * random.sign()), other);
    let target = point + random.unit() * (random.decades(-12.0, -1.0) * random.sign());
    let (from, distance) = (random.unit(), random.decades(-1.0, 6.0));
    seen(random, vec![sphere(center, radius), second], target, from, distance)
}

/// Cylinders with a cap in one plane, exactly or up to some units in the last place. The caps are perpendicular to a
/// coordinate axis if `is_straight` is set.
fn coplanar(random: &mut Random, is_straight: bool) -> NearCase {
    let sign = random.sign();
    let up = if is_straight { random.shuffled(Vec3::new(0.0, sign, 0.0)) } else { random.unit() };
    let target = random.cube(40.0).map(|number| number.round() / 4.0);
    let shapes = (0..2 + random.below(3)).map(|_| {
        let (height, radius) = (random.length() * random.sign(), random.length());
        let aside = random.perpendicular(up) * (radius * random.uniform(0.0, 0.9));
        let aside = if is_straight { aside - up * aside.dot(up) } else { aside };
        let steps = 2 * random.below(2);
        cylinder(random.nudged_vector(target + up * (height / 2.0) + aside, steps), radius, up * height)
    });
    let shapes = shapes.collect();
    let from = (random.unit() + up * random.uniform(-2.0, 2.0)).unit();
    let distance = random.decades(-1.0, 7.0);
    seen(random, shapes, target, from, distance)
}

/// A cylinder, and a surface through a point of its rim: a sphere, a side or a cap. Half of the cases have a longer
/// cylinder with the same side. The ray goes towards that point.
fn through_a_rim(random: &mut Random) -> NearCase {
    let (center, radius, axis) = (random.cube(10.0), random.length(), random.unit() * random.length());
    let rim = center + axis * 0.5 + random.perpendicular(axis) * radius;
    let mut shapes = vec![cylinder(center, radius, axis)];
    if random.below(2) == 0 {
        // This one is longer, and its side coincides with that of the first.
        shapes.push(cylinder(center + axis * 0.25, radius, axis * 1.5));
    }
    let (other, along) = (random.length(), random.unit() * random.length());
    let foot = rim + random.perpendicular(along) * other;
    shapes.push(match random.below(3) {
        0 => sphere(rim + random.unit() * other, other),
        1 => cylinder(foot, other, along),
        _ => cylinder(rim + along * 0.5 + random.perpendicular(along) * (other / 2.0), other, along),
    });
    let target = rim + random.unit() * random.decades(-17.0, -6.0);
    let (from, distance) = (random.unit(), random.decades(-1.0, 5.0));
    seen(random, shapes, target, from, distance)
}

/// Two to four copies of an object. In a third of them the centre differs by up to two units in the last place, and so
/// do the radius and the axis.
fn nearly_identical(random: &mut Random) -> NearCase {
    let (center, radius, axis) = (random.cube(10.0), random.length(), random.unit() * random.length());
    let is_sphere = random.below(2) == 0;
    let shapes = (0..2 + random.below(3)).map(|_| {
        let mut steps = || if random.below(3) == 0 { 2 } else { 0 };
        let [of_center, of_radius, of_axis] = [steps(), steps(), steps()];
        let (center, radius) = (random.nudged_vector(center, of_center), random.nudged(radius, of_radius));
        if is_sphere { sphere(center, radius) } else { cylinder(center, radius, random.nudged_vector(axis, of_axis)) }
    });
    let shapes = shapes.collect();
    let (from, distance) = (random.unit(), radius * random.decades(0.1, 7.0));
    let target = center + random.unit() * (radius * random.uniform(0.0, 0.9));
    seen(random, shapes, target, from, distance)
}
