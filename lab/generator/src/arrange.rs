//! Generates the shapes of each [`Arrangement`].

use cpu::Vec3;
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};

use super::draws::{Draws, round};
use super::{Arrangement, Options};

/// Returns the shapes of the scene that `options` describe, in the order of the scene file.
pub(super) fn shapes(draws: &mut Draws, options: &Options) -> Vec<Shape> {
    let mut shapes = Vec::with_capacity(options.objects);
    for index in 0..options.objects {
        let shape = match options.arrangement {
            Arrangement::Scattered => scattered(draws, options),
            Arrangement::Grid => on_the_grid(draws, options, index),
            Arrangement::Degenerate => degenerate(draws, options, &shapes),
        };
        shapes.push(shape);
    }
    shapes
}

/// Returns a cylinder if `axis` is given, and otherwise a sphere.
fn shape(center: Vec3, radius: f64, axis: Option<Vec3>) -> Shape {
    match axis {
        None => Shape::Sphere(Sphere { center, radius }),
        Some(axis) => Shape::Cylinder(Cylinder { center, radius, axis }),
    }
}

fn scattered(draws: &mut Draws, options: &Options) -> Shape {
    let extent = options.extent;
    let (center, size) = (draws.point(extent), extent * draws.between(0.03, 0.2));
    if draws.chance(options.cylinders) {
        let axis = draws.direction(2.0 * size);
        shape(center, round(size / 2.0), Some(axis))
    } else {
        shape(center, round(size), None)
    }
}

/// Returns the number of squares along each side of a board for `objects` objects. One of the objects is the ground.
pub(super) fn squares_a_side(objects: usize) -> usize {
    (1..).find(|side| side * side + 1 >= objects).unwrap_or(1)
}

/// Returns the ground if `index` is 0, and otherwise an object on a square of the board. The squares are filled row by
/// row.
fn on_the_grid(draws: &mut Draws, options: &Options, index: usize) -> Shape {
    /// Radius of the ground, divided by the extent. With 1000, the ground is nearly flat.
    const GROUND: f64 = 1000.0;

    let extent = options.extent;
    let Some(square) = index.checked_sub(1) else {
        return shape(Vec3::new(0.0, -GROUND * extent, 0.0), GROUND * extent, None);
    };
    let side = squares_a_side(options.objects);
    let step = 2.0 * extent / side as f64;
    let middle = |position: usize| (position as f64 + 0.5) * step - extent;
    let [x, z] = [square % side, square / side].map(|at| round(middle(at) + step * draws.between(-0.1, 0.1)));
    let size = step * draws.between(0.2, 0.42);
    if draws.chance(options.cylinders) {
        let lean = draws.direction(0.5 * size);
        let height = round(2.0 * size);
        shape(Vec3::new(x, height / 2.0, z), round(size / 2.0), Some(Vec3::new(lean.x, height, lean.z)))
    } else {
        let radius = round(size);
        shape(Vec3::new(x, radius, z), radius, None)
    }
}

/// Returns a shape that shares exact values, such as its centre, with one of the shapes in `before`. If `before` is
/// empty, the shape is random.
fn degenerate(draws: &mut Draws, options: &Options, before: &[Shape]) -> Shape {
    let extent = options.extent;
    let fresh = scattered(draws, options);
    if before.is_empty() {
        return fresh;
    }
    let other = before[draws.index(before.len())];
    let (center, radius, axis) = parts(other);
    // A cylinder made from a cylinder keeps its axis, because coaxial sides and caps in one plane are hard cases.
    let cylinder = draws.chance(options.cylinders);
    let along = axis.unwrap_or_else(|| draws.along_an_axis(radius));
    let axis = cylinder.then_some(along);
    match draws.index(9) {
        // A copy of the other shape. Of two equal objects, the later one is visible.
        0 => other,
        // Touches the other shape from outside, along a coordinate axis.
        1 => shape(center + draws.along_an_axis(2.0 * radius), radius, axis),
        // End to end with the other shape, along the axis.
        2 => shape(center + along, radius, axis),
        // Inside the other shape or around it, with its centre.
        3 => shape(center, radius / 2.0, axis),
        4 => shape(center, radius * 2.0, axis),
        // Touches the other shape from inside.
        5 => shape(center + draws.along_an_axis(radius / 2.0), radius / 2.0, axis),
        // On a lattice, with a diameter equal to the lattice's spacing.
        6 => shape(draws.point(4.0).map(f64::round) * (extent / 4.0), extent / 8.0, axis),
        // A huge sphere beside the other shape, and in the next case a tiny shape.
        7 => shape(center + draws.along_an_axis(100.0 * extent), 100.0 * extent, None),
        _ => {
            let tiny = draws.along_an_axis(1e-6 * extent);
            shape(center, 1e-6 * extent, cylinder.then_some(tiny))
        }
    }
}

fn parts(shape: Shape) -> (Vec3, f64, Option<Vec3>) {
    match shape {
        Shape::Sphere(sphere) => (sphere.center, sphere.radius, None),
        Shape::Cylinder(cylinder) => (cylinder.center, cylinder.radius, Some(cylinder.axis)),
    }
}
