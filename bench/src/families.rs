//! Families of scenes that may be slow: large floors, tubes seen along their axis, rooms of mirrors, and others.
//!
//! A scene of a family is a point: one number from 0 to 1 for each property of the family, such as a radius. `cliffs`
//! searches the points for the scene with which the renderer gains least over the literal program.

use std::fmt::Write as _;

use cpu::internals::sampling::uniform::Uniform;

/// The largest number of properties of a family.
pub const PROPERTIES: usize = 4;

/// A point of a family: the numbers from 0 to 1 that give its properties. A family may use fewer of them.
pub type Point = [f64; PROPERTIES];

/// A family of scenes.
pub struct Family {
    /// The name.
    pub name: &'static str,
    /// Returns the scene at a point.
    pub scene: fn(Point) -> FamilyScene,
}

/// A scene of a family.
pub struct FamilyScene {
    /// What distinguishes the scene from others of its family, in words.
    pub properties: String,
    /// The lines of the configuration, without the size of the picture and the number of samples.
    pub config: String,
    /// The text of the scene file.
    pub scene: String,
}

impl FamilyScene {
    /// Returns a scene with the project's materials for families: `m` and `n` are matte, `s` is rough metal, `a` a
    /// mirror and `g` glass.
    fn new(properties: String, config: String, objects: &str) -> Self {
        let scene = format!(
            "matte: m .7 .7 .7\nmatte: n .2 .4 .8\nmetal: s .9 .9 .9 .1\nmetal: a .9 .9 .9 0\nrefractive: g 1.5\n{objects}"
        );
        Self { properties, config, scene }
    }

    /// Returns the configuration with this width and number of samples.
    #[must_use]
    pub fn config(&self, width: usize, samples: usize) -> String {
        format!("image_width: {width}\nsamples_per_pixel: {samples}\n{}", self.config)
    }
}

/// Returns the number at `x` between `low` and `high`, on a logarithmic scale, rounded to three digits.
fn log(x: f64, low: f64, high: f64) -> f64 {
    let value = low * (high / low).powf(x);
    format!("{value:.2e}").parse().expect("it is a number")
}

/// Returns the whole number at `x` between `low` and `high`, on a logarithmic scale.
fn count(x: f64, low: f64, high: f64) -> usize {
    log(x, low, high).round() as usize
}

/// Returns a camera at a point that looks at another one, with this field of view in degrees, and a depth of 8.
fn camera(position: [f64; 3], target: [f64; 3], field_of_view: f64) -> String {
    let [position, target] = [position, target].map(|[x, y, z]| format!("{x:e} {y:e} {z:e}"));
    format!("camera_position: {position}\ncamera_target: {target}\nfield_of_view: {field_of_view:e}\nmax_depth: 8\n")
}

/// Returns the lines of `count` spheres and cylinders of all materials, a little above `y = 0`. Lengths are multiplied
/// by `scale`.
fn small_objects(count: usize, scale: f64) -> String {
    let mut draws = Uniform::new(3);
    let side = 4.0 * (count as f64 / 20.0).sqrt().max(1.0);
    let mut lines = String::new();
    for number in 0..count {
        let [x, z] = [(); 2].map(|()| draws.draw(-side, side) * scale);
        let (y, size) = (draws.draw(0.3, 1.0) * scale, 0.3 * scale);
        let material = ["m", "n", "s", "a", "g"][number % 5];
        let _ = if number % 4 == 3 {
            let [a, b] = [(); 2].map(|()| draws.draw(-0.5, 0.5) * scale);
            writeln!(lines, "cylinder: {x:e} {y:e} {z:e} {size:e} {a:e} {size:e} {b:e} {material}")
        } else {
            writeln!(lines, "sphere: {x:e} {y:e} {z:e} {size:e} {material}")
        };
    }
    lines
}

const ABOVE: [f64; 3] = [3.0, 3.0, -9.0];
const MIDDLE: [f64; 3] = [0.0; 3];

/// The axis of a disc of height 0.5 that is tilted, and its centre if the disc's top passes through the origin at the
/// distance `along` from its middle.
fn tilted(tilt: f64, along: f64) -> ([f64; 3], [f64; 3]) {
    let (sin, cos) = tilt.sin_cos();
    let axis = [-0.5 * sin, 0.5 * cos, 0.0];
    (axis, [along * cos + 0.25 * sin, along * sin - 0.25 * cos, 0.0])
}

fn cylinder([x, y, z]: [f64; 3], radius: f64, [a, b, c]: [f64; 3], material: &str) -> String {
    format!("cylinder: {x:e} {y:e} {z:e} {radius:e} {a:e} {b:e} {c:e} {material}\n")
}

/// Returns a floor of one disc, with 20 objects on it.
fn disc_floor([radius, along, tilt, _]: Point) -> FamilyScene {
    let (radius, along, tilt) = (log(radius, 10.0, 1e12), (along - 0.1).max(0.0), (tilt - 0.5).max(0.0));
    let (axis, center) = tilted(tilt, along * radius);
    FamilyScene::new(
        format!("radius {radius:e}, middle {along:.2} radii away, tilt {tilt:.2}"),
        camera(ABOVE, MIDDLE, 45.0),
        &(cylinder(center, radius, axis, "m") + &small_objects(20, 1.0)),
    )
}

/// Returns a floor of one sphere.
fn sphere_floor([radius, number, height, _]: Point) -> FamilyScene {
    let (radius, number, height) = (log(radius, 10.0, 1e12), count(number, 1.0, 100.0), log(height, 0.1, 1e4));
    FamilyScene::new(
        format!("radius {radius:e}, {number} objects, camera at {height:e}"),
        camera([0.0, height, -9.0], MIDDLE, 45.0),
        &format!("sphere: 0 {:e} 0 {radius:e} m\n{}", -radius, small_objects(number, 1.0)),
    )
}

/// Returns a sphere that is larger than the scene by far, whose surface passes through the origin. In half of the
/// scenes its centre lies on an axis. In the others the surface misses the origin by the rounding of the centre.
fn endless_sphere([radius, number, height, turn]: Point) -> FamilyScene {
    let (radius, number, height) = (log(radius, 1e12, 1e300), count(number, 1.0, 100.0), log(height, 0.1, 10.0));
    let turn = (turn - 0.5).max(0.0);
    let [x, y] = [-radius * turn.sin(), -radius * turn.cos()];
    FamilyScene::new(
        format!("radius {radius:e}, {number} objects, camera at {height:e}, turn {turn:.2}"),
        camera([0.0, height, -9.0], MIDDLE, 45.0),
        &format!("sphere: {x:e} {y:e} 0 {radius:e} m\n{}", small_objects(number, 1.0)),
    )
}

/// Returns a floor that is the side of a lying cylinder.
fn side_floor([radius, length, number, turn]: Point) -> FamilyScene {
    let (radius, length, number) = (log(radius, 10.0, 1e12), log(length, 0.1, 100.0), count(number, 1.0, 100.0));
    let (sin, cos) = turn.sin_cos();
    let axis = [length * radius * cos, 0.0, length * radius * sin];
    FamilyScene::new(
        format!("radius {radius:e}, {length:e} radii long, {number} objects, turn {turn:.2}"),
        camera(ABOVE, MIDDLE, 45.0),
        &(cylinder([0.0, -radius, 0.0], radius, axis, "m") + &small_objects(number, 1.0)),
    )
}

/// Returns cylinders around the same middle whose radii hardly differ.
fn films([gap, number, length, _]: Point) -> FamilyScene {
    let (gap, number, length) = (log(gap, 1e-14, 1e-2), count(number, 2.0, 20.0), log(length, 0.1, 10.0));
    let film = |place: usize| {
        let radius = 1.0 + gap * place as f64;
        cylinder(MIDDLE, radius, [0.3 * length, length * radius, 0.2 * length], ["m", "n"][place % 2])
    };
    FamilyScene::new(
        format!("{number} cylinders, {gap:e} apart, length {length:e}"),
        camera(ABOVE, MIDDLE, 20.0),
        &(0..number).map(film).collect::<String>(),
    )
}

/// Returns flat discs above each other.
fn stack([radius, gap, number, tilt]: Point) -> FamilyScene {
    let (radius, gap, number) = (log(radius, 1.0, 1e7), log(gap, 0.01, 1.0), count(number, 2.0, 60.0));
    let tilt = (tilt - 0.5).max(0.0);
    let discs = (0..number).map(|place| {
        let ([a, b, c], [x, y, z]) = tilted(tilt, 0.0);
        let down = gap * place as f64;
        cylinder([x, y - down, z], radius, [a * gap, b * gap, c * gap], if place % 2 == 0 { "m" } else { "n" })
    });
    FamilyScene::new(
        format!("{number} discs of radius {radius:e}, {gap:e} apart, tilt {tilt:.2}"),
        camera(ABOVE, MIDDLE, 45.0),
        &discs.collect::<String>(),
    )
}

/// Returns a tube of mirrors, seen along its axis from within.
fn tube([view, length, tilt, rough]: Point) -> FamilyScene {
    let (view, length, material) = (log(view, 1e-3, 90.0), log(length, 2.0, 1e4), mirror(rough));
    let axis = [tilt, 2.0 * tilt, 1.0].map(|part| part * length);
    let camera = camera(axis.map(|part| -0.4 * part), MIDDLE, view);
    FamilyScene::new(
        format!("length {length:e}, view {view:e} degrees, tilt {tilt:.2}, {}", roughness(material)),
        camera,
        &cylinder(MIDDLE, 1.0, axis, material),
    )
}

/// Returns the material of a mirror: rough if `rough` is more than one half.
fn mirror(rough: f64) -> &'static str {
    if rough < 0.5 { "a" } else { "s" }
}

/// Returns the kind of the object on a line of a scene.
fn kind_of(line: &str) -> &str {
    line.split(':').next().unwrap_or_default()
}

/// Returns how a mirror of this material reflects, in words.
fn roughness(material: &str) -> &str {
    if material == "a" { "smooth" } else { "rough" }
}

/// Returns two long mirrors that enclose a narrowing gap, into which the camera looks.
fn wedge([gap, view, length, rough]: Point) -> FamilyScene {
    let (gap, view, length) = (log(gap, 1e-4, 1.0), log(view, 1e-2, 60.0), log(length, 2.0, 1e4));
    let material = mirror(rough);
    let floor = cylinder([0.0, -1.0 - gap / 2.0, 0.0], 1.0, [0.0, gap / 10.0, length], material);
    let roof = cylinder([0.0, 1.0 + gap / 2.0, 0.0], 1.0, [0.0, -gap / 10.0, length], material);
    FamilyScene::new(
        format!("gap {gap:e}, view {view:e} degrees, length {length:e}, {}", roughness(material)),
        camera([0.0, 0.0, -0.6 * length], [0.0, gap / 10.0, 0.0], view),
        &(floor + &roof),
    )
}

/// Returns a room of mirrors around the camera: a sphere or a cylinder, with up to nine objects.
fn mirror_room([size, depth, number, shape]: Point) -> FamilyScene {
    let (size, depth, number) = (log(size, 1.0, 1e6), count(depth, 5.0, 200.0), count(number, 1.0, 10.0) - 1);
    let material = mirror((2.0 * shape).fract());
    let room = if shape < 0.5 {
        format!("sphere: 0.3 0.2 0.1 {:e} {material}\n", 5.0 * size)
    } else {
        cylinder([0.3, 0.2, 0.1], 5.0 * size, [size, 9.0 * size, 0.0], material)
    };
    let config =
        camera([0.0, 0.5, -2.0], [0.0, 0.4, 0.0], 60.0).replace("max_depth: 8", &format!("max_depth: {depth}"));
    FamilyScene::new(
        format!("size {size:e}, depth {depth}, {number} objects, {} {}", roughness(material), kind_of(&room)),
        config,
        &(room + &small_objects(number, 0.3)),
    )
}

/// Returns spheres or cylinders of glass inside each other.
fn nested_glass([number, gap, size, shape]: Point) -> FamilyScene {
    let (number, gap, size) = (count(number, 1.0, 40.0), log(gap, 1e-15, 0.1), log(size, 1e-3, 1e6));
    let shells = (0..number).map(|place| {
        let radius = 3.0 * size * (1.0 - gap).powi(place as i32);
        if shape < 0.5 {
            format!("sphere: 0 0 0 {radius:e} g\n")
        } else {
            cylinder(MIDDLE, radius, [0.3 * radius, 2.0 * radius, 0.0], "g")
        }
    });
    let shape = if shape < 0.5 { "spheres" } else { "cylinders" };
    FamilyScene::new(
        format!("{number} {shape}, smaller by {gap:e} each, size {size:e}"),
        camera(ABOVE.map(|part| part * size), MIDDLE, 45.0).replace("max_depth: 8", "max_depth: 50"),
        &shells.collect::<String>(),
    )
}

/// Returns objects that a camera sees from far away through a small field of view.
fn telescope([distance, number, side, _]: Point) -> FamilyScene {
    let (distance, number) = (log(distance, 10.0, 1e8), count(number, 1.0, 100.0));
    let position = [distance * (side - 0.5), distance, -3.0 * distance];
    FamilyScene::new(
        format!("distance {distance:e}, {number} objects, aside {side:.2}"),
        camera(position, MIDDLE, 2.0 * (1.5 / distance).atan().to_degrees()),
        &small_objects(number, 1.0),
    )
}

/// Returns objects whose sizes and distances spread over many magnitudes.
fn mixed_scales([small, large, number, _]: Point) -> FamilyScene {
    let (small, large, number) = (log(small, 1e-6, 1.0), log(large, 1.0, 1e12), count(number, 4.0, 60.0));
    let mut draws = Uniform::new(5);
    let objects = (0..number).map(|place| {
        let size = log(draws.canonical(), small, large);
        let [x, y, z] = [(); 3].map(|()| draws.draw(-3.0, 3.0));
        let center = [x + 1.2 * size * x.signum(), y, z + 1.2 * size];
        if place % 3 == 0 {
            return cylinder(center, size, [0.1 * size, size, 0.0], "n");
        }
        let [x, y, z] = center;
        format!("sphere: {x:e} {y:e} {z:e} {size:e} {}\n", ["m", "s", "g"][place % 3])
    });
    FamilyScene::new(
        format!("{number} objects of sizes {small:e} to {large:e}"),
        camera([0.0, 3.0, -9.0], MIDDLE, 60.0),
        &objects.collect::<String>(),
    )
}

/// Returns thin cylinders.
fn thin_cylinders([radius, number, length, _]: Point) -> FamilyScene {
    let (radius, number, length) = (log(radius, 1e-6, 0.1), count(number, 2.0, 100.0), log(length, 0.3, 1e4));
    let mut draws = Uniform::new(7);
    let objects = (0..number).map(|_| {
        let mut vector = |size: f64| [(); 3].map(|()| draws.draw(-size, size));
        cylinder(vector(3.0), radius, vector(length), "m")
    });
    FamilyScene::new(
        format!("{number} of radius {radius:e}, length {length:e}"),
        camera(ABOVE, MIDDLE, 45.0),
        &objects.collect::<String>(),
    )
}

/// Returns a floor that the camera sees at a small angle.
fn grazing_light([radius, height, number, shape]: Point) -> FamilyScene {
    let (radius, height, number) = (log(radius, 10.0, 1e7), log(height, 1e-6, 1.0), count(number, 1.0, 20.0));
    let floor = if shape < 0.5 {
        format!("sphere: 0 {:e} 0 {radius:e} m\n", -radius)
    } else {
        cylinder([0.0, -0.5, 0.0], radius, [0.0, 1.0, 0.0], "m")
    };
    FamilyScene::new(
        format!("radius {radius:e}, height {height:e}, {number} objects, {}", kind_of(&floor)),
        camera([0.0, height, -9.0], [0.0, height / 2.0, 0.0], 20.0),
        &(floor + &small_objects(number, 0.2)),
    )
}

/// Returns an ordinary scene whose lengths are multiplied by a factor.
fn scaled([scale, number, _, _]: Point) -> FamilyScene {
    let (scale, number) = (log(scale, 1e-6, 1e6), count(number, 1.0, 200.0));
    FamilyScene::new(
        format!("{number} objects, lengths times {scale:e}"),
        camera(ABOVE.map(|part| part * scale), MIDDLE, 45.0),
        &format!("sphere: 0 {:e} 0 {:e} m\n{}", -100.0 * scale, 100.0 * scale, small_objects(number, scale)),
    )
}

/// Returns an ordinary scene of some number of objects.
fn crowd([number, size, floor, _]: Point) -> FamilyScene {
    let (number, size) = (count(number, 1.0, 10_000.0), log(size, 0.1, 10.0));
    let floor = if floor < 0.5 { "" } else { "sphere: 0 -1000 0 1000 m\n" };
    FamilyScene::new(
        format!("{number} objects, spread {size:e}{}", if floor.is_empty() { "" } else { ", on a floor" }),
        camera(ABOVE.map(|part| part * size), MIDDLE, 60.0),
        &format!("{floor}{}", small_objects(number, size)),
    )
}

/// Returns small objects, and a far larger sphere around them or a thick cylinder beside them.
fn one_giant([radius, number, shape, _]: Point) -> FamilyScene {
    let (radius, number) = (log(radius, 1e3, 1e12), count(number, 1.0, 10_000.0));
    let giant = if shape < 0.5 {
        format!("sphere: {:e} 0 {radius:e} {:e} m\n", 5.0 + radius * 0.1, radius * 0.9)
    } else {
        cylinder([0.0, 0.0, 1.2 * radius], radius, [radius, 0.0, 0.0], "m")
    };
    FamilyScene::new(
        format!("{number} objects and a giant {} of radius {radius:e}", kind_of(&giant)),
        camera(ABOVE, MIDDLE, 45.0),
        &(giant + &small_objects(number, 1.0)),
    )
}

/// All families.
pub const FAMILIES: &[Family] = &[
    Family { name: "disc-floor", scene: disc_floor },
    Family { name: "sphere-floor", scene: sphere_floor },
    Family { name: "endless-sphere", scene: endless_sphere },
    Family { name: "side-floor", scene: side_floor },
    Family { name: "films", scene: films },
    Family { name: "stack", scene: stack },
    Family { name: "tube", scene: tube },
    Family { name: "wedge", scene: wedge },
    Family { name: "mirror-room", scene: mirror_room },
    Family { name: "nested-glass", scene: nested_glass },
    Family { name: "telescope", scene: telescope },
    Family { name: "mixed-scales", scene: mixed_scales },
    Family { name: "thin-cylinders", scene: thin_cylinders },
    Family { name: "grazing-light", scene: grazing_light },
    Family { name: "scaled", scene: scaled },
    Family { name: "crowd", scene: crowd },
    Family { name: "one-giant", scene: one_giant },
];

#[cfg(test)]
mod tests {
    use cpu::{Config, Scene};

    use super::*;

    #[test]
    fn every_scene_of_a_family_is_accepted() {
        let mut draws = Uniform::new(1);
        for family in FAMILIES {
            for corner in 0..40 {
                let point = match corner {
                    0..16 => [0, 1, 2, 3].map(|bit| f64::from(corner >> bit & 1)),
                    _ => [(); PROPERTIES].map(|()| draws.canonical()),
                };
                let scene = (family.scene)(point);
                assert!(Config::parse(scene.config(8, 1).as_bytes()).is_ok(), "{}: {}", family.name, scene.config);
                assert!(Scene::parse(scene.scene.as_bytes()).is_ok(), "{}: {}", family.name, scene.scene);
            }
        }
    }
}
