//! The regimes of cylinders. Lengths are in scene units. Directions have length one, unless a regime varies the length.

use cpu::Vec3;
use cpu::internals::input::scene::Cylinder;

use super::Regime;
use crate::case::Case;
use crate::random::Random;

pub const REGIMES: [Regime; 10] = [
    Regime { name: "ordinary", draw: ordinary },
    Regime { name: "far and small", draw: far_and_small },
    Regime { name: "huge and near", draw: huge_and_near },
    Regime { name: "grazing the side", draw: grazing },
    Regime { name: "origin on the surface", draw: on_the_surface },
    Regime { name: "inside, at the centre, on the axis", draw: inside },
    Regime { name: "aspect ratios", draw: aspect_ratios },
    Regime { name: "along the axis or across it", draw: along_or_across },
    Regime { name: "through the rim", draw: through_the_rim },
    Regime { name: "everything at once", draw: everything },
];

fn cylinder(random: &mut Random, center: Vec3, radius: f64, height: f64) -> Cylinder {
    Cylinder { center, radius, axis: random.unit() * height }
}

/// Returns a point at the distance of `around` radii from the axis, in a random direction, and of `along` half heights
/// from the centre.
fn point_of(random: &mut Random, cylinder: &Cylinder, around: f64, along: f64) -> Vec3 {
    let across = random.perpendicular(cylinder.axis) * (cylinder.radius * around);
    cylinder.center + cylinder.axis * (along / 2.0) + across
}

/// Returns a ray that starts at `distance` from the point `target` and goes towards it.
fn toward(random: &mut Random, cylinder: Cylinder, target: Vec3, distance: f64) -> Case {
    let forward = random.unit();
    Case::cylinder(cylinder, target - forward * distance, forward)
}

/// Returns a ray that starts at `distance` from a random point and goes towards it. The point is in the cylinder or
/// slightly outside.
fn aimed(random: &mut Random, cylinder: Cylinder, distance: f64) -> Case {
    let (around, along) = (random.uniform(0.0, 1.3), random.uniform(-1.3, 1.3));
    let target = point_of(random, &cylinder, around, along);
    toward(random, cylinder, target, distance)
}

fn plain(random: &mut Random) -> Cylinder {
    let (center, radius, height) = (random.cube(10.0), random.uniform(0.1, 2.0), random.uniform(0.2, 5.0));
    cylinder(random, center, radius, height)
}

fn ordinary(random: &mut Random) -> Case {
    let (cylinder, distance) = (plain(random), random.uniform(5.0, 30.0));
    aimed(random, cylinder, distance)
}

fn far_and_small(random: &mut Random) -> Case {
    let (radius, distance) = (random.decades(-6.0, 0.0), random.decades(2.0, 12.0));
    let height = radius * random.decades(-1.0, 1.0);
    let cylinder = cylinder(random, Vec3::ZERO, radius, height);
    if random.below(2) == 0 {
        return aimed(random, cylinder, distance);
    }
    // A far ray with rounded coordinates would miss a small object, unless its direction is along a coordinate axis.
    let (near, sign) = (random.cube(radius + height), random.sign());
    let direction = Vec3::new(0.0, 0.0, -sign * random.uniform(0.5, 2.0));
    Case::cylinder(cylinder, Vec3::new(near.x, near.y, sign * distance), direction)
}

fn huge_and_near(random: &mut Random) -> Case {
    let radius = random.decades(3.0, 9.0);
    let height = radius * random.decades(-1.0, 1.0);
    let cylinder = cylinder(random, Vec3::ZERO, radius, height);
    let on_side = random.below(2) == 0;
    let (around, along) = if on_side { (1.0, random.uniform(-1.0, 1.0)) } else { (random.uniform(0.0, 1.0), 1.0) };
    let point = point_of(random, &cylinder, around, along);
    let (offset, direction) = (random.unit() * random.decades(-4.0, 2.0), random.unit());
    // The cylinder is moved so that the ray starts near the origin of coordinates.
    Case::cylinder(Cylinder { center: -point, ..cylinder }, offset, direction)
}

fn grazing(random: &mut Random) -> Case {
    let (cylinder, distance) = (plain(random), random.decades(0.7, 2.0));
    let across = random.perpendicular(cylinder.axis);
    let along = cylinder.axis.unit().cross(across);
    let off = 1.0 + random.sign() * random.decades(-16.0, 0.0);
    let height = random.uniform(-0.6, 0.6);
    let target = cylinder.center + across * (cylinder.radius * off) + cylinder.axis * height;
    let forward = (along + cylinder.axis.unit() * random.uniform(-1.0, 1.0)).unit();
    Case::cylinder(cylinder, target - forward * distance, forward)
}

/// Returns a secondary ray: from the side or a cap, in any direction.
fn on_the_surface(random: &mut Random) -> Case {
    let (center, radius) = (random.cube(10.0), random.decades(-2.0, 3.0));
    let height = radius * random.decades(-1.0, 1.0);
    let cylinder = cylinder(random, center, radius, height);
    leaving(random, cylinder)
}

fn leaving(random: &mut Random, cylinder: Cylinder) -> Case {
    let (around, along) = match random.below(3) {
        0 => (random.uniform(0.0, 1.0), random.sign()),
        _ => (1.0, random.uniform(-1.0, 1.0)),
    };
    let (origin, direction) = (point_of(random, &cylinder, around, along), random.unit() * random.uniform(0.5, 2.0));
    Case::cylinder(cylinder, origin, direction)
}

fn inside(random: &mut Random) -> Case {
    let cylinder = plain(random);
    let (mut around, mut along) = (random.uniform(0.0, 1.0), random.uniform(-1.0, 1.0));
    match random.below(4) {
        0 => (around, along) = (0.0, 0.0),
        1 => around = 0.0,
        _ => {}
    }
    let (origin, direction) = (point_of(random, &cylinder, around, along), random.unit());
    Case::cylinder(cylinder, origin, direction)
}

fn aspect_ratios(random: &mut Random) -> Case {
    let (center, radius) = (random.cube(10.0), random.decades(-3.0, 3.0));
    let height = radius * random.decades(-6.0, 6.0);
    let (cylinder, distance) = (cylinder(random, center, radius, height), radius.max(1.0) * random.uniform(2.0, 20.0));
    aimed(random, cylinder, distance)
}

fn along_or_across(random: &mut Random) -> Case {
    let cylinder = plain(random);
    let axis = cylinder.axis.unit();
    let across = random.perpendicular(axis);
    let small = if random.below(8) == 0 { 0.0 } else { random.decades(-16.0, -1.0) };
    let (around, along) = (random.uniform(0.0, 1.1), random.uniform(-1.1, 1.1));
    let target = point_of(random, &cylinder, around, along);
    let forward = if random.below(2) == 0 { axis * random.sign() + across * small } else { across + axis * small };
    Case::cylinder(cylinder, target - forward * random.uniform(0.0, 20.0), forward)
}

/// Returns a ray that passes the rim, where side and cap meet, within some units in the last place.
fn through_the_rim(random: &mut Random) -> Case {
    if random.below(2) == 0 {
        // Numbers with few digits, for which f64 can represent a ray exactly through the rim.
        let short = |random: &mut Random| f64::from(random.below(64) as u32 + 1) / 16.0;
        let (radius, half, steep) = (short(random), short(random), short(random) * random.sign());
        let cylinder =
            Cylinder { center: random.cube(8.0).map(f64::round), radius, axis: Vec3::new(0.0, 2.0 * half, 0.0) };
        let forward = Vec3::new(0.0, steep, 1.0);
        let rim = Vec3::new(0.0, half * random.sign(), radius * random.sign());
        let origin = cylinder.center + rim - forward * short(random);
        return Case::cylinder(cylinder, random.nudged_vector(origin, 1), forward);
    }
    let (cylinder, distance, end) = (plain(random), random.uniform(0.1, 30.0), random.sign());
    let rim = point_of(random, &cylinder, 1.0, end);
    let target = random.nudged_vector(rim, 3);
    toward(random, cylinder, target, distance)
}

fn everything(random: &mut Random) -> Case {
    let (radius, extent) = (random.decades(-6.0, 6.0), random.decades(-6.0, 6.0));
    let (center, height) = (random.cube(extent), radius * random.decades(-6.0, 6.0));
    let cylinder = cylinder(random, center, radius, height);
    let Case { shape, mut ray } = match random.below(3) {
        0 => leaving(random, cylinder),
        1 => {
            let (around, along) = (random.uniform(0.0, 1.0), random.uniform(-1.0, 1.0));
            let (origin, direction) = (point_of(random, &cylinder, around, along), random.unit());
            Case::cylinder(cylinder, origin, direction)
        }
        _ => {
            let distance = random.decades(-2.0, 12.0);
            aimed(random, cylinder, distance)
        }
    };
    ray.direction = ray.direction * random.decades(-6.0, 6.0);
    Case { shape, ray }
}
