//! The margins of the BVH: boxes of objects, planes of boxes, and bounding spheres.
//!
//! Steps are powers of two, so a product with a step is exact short of underflow. Here every step is 1, and a number of
//! steps is a distance. It is at most twice the largest coordinate `P`, and a step of up to a 127th of that.

use cpu::internals::accel::bounds::{
    Bounds, DISC_MARGIN, ENLARGEMENT, above, half_width_of_cylinder, half_width_of_disc,
};
use cpu::internals::accel::bvh::farthest_for;
use cpu::internals::accel::bvh::planes::{Planes, WIDTH};
use cpu::internals::accel::bvh::slab_ray::{
    FARTHEST as FARTHEST_ORIGIN, LARGEST_RECIPROCAL, LEAST_MARGIN, LONGEST_SQUARED, PLANE_MARGIN, SlabRay, margin,
    moved,
};
use cpu::internals::accel::bvh::sphere_leaf::{BoundingSphere, Frame, SphereLeaf};
use cpu::internals::accel::bvh::sphere_ray::{SphereRay, cross, enlargement, unit};
use cpu::internals::accel::extent::Extent;
use cpu::internals::accel::may_hit::conservative::LEAST_LENGTH_SQUARED;
use cpu::internals::exact::cylinder_decision::CYLINDER_BOUND;
use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::internals::math::real::Real;
use cpu::internals::simd::SimdF32;
use cpu::{Ray, Vec3};

use super::bounded::{self, Bounded, begin, compared, forget_later};
use super::bounds::Arithmetic;
use super::direction::growth;
use super::lanes::{self, Lane, name};
use super::parts::axis_and_half_height;
use super::polynomial::Polynomial;
use super::row::{Row, U, added, components, family::*, length, relative_to_sizes, squared, sum};

const WITHOUT_UNDERFLOW: Arithmetic = Arithmetic { underflow: 0.0, ..Arithmetic::F32 };
const V: f64 = Arithmetic::F32.roundoff;

/// The families of the largest coordinates, of a reciprocal, of numbers of steps, and of the origin of a frame.
const FARTHEST: u8 = CENTER;
const RECIPROCAL: u8 = DERIVED;
const STEPS: u8 = DERIVED + 1;
const FRAME: u8 = DERIVED + 4;
/// The families of a cross product and of an enlarged radius, and of the square of a direction's length.
const CROSS: u8 = DERIVED + 7;
const SQUARE: u8 = DERIVED + 8;
/// The family of a step.
const STEP: u8 = DERIVED + 9;

/// The most steps, relative to `P`.
const MOST_STEPS: f64 = 2.0 * (1.0 + 1.0 / 127.0);

/// Returns the rows of the BVH.
#[must_use]
pub fn rows() -> Vec<Row> {
    let mut rows = disc().to_vec();
    rows.push(leaves());
    rows.extend(slabs());
    rows.extend([underflow(), limited_reciprocal()]);
    rows.extend(bounding_spheres());
    rows.extend([overflow_of_spheres(), closest_so_far()]);
    rows
}

/// Returns the rows of the half width of a disc, and of the half sizes of boxes.
///
/// With an error `e` of the difference `x`, `sqrt(x)` is at most `sqrt(x - e) + sqrt(e)`. The root and the sum are
/// rounded once each, which adds at most `3 u`.
fn disc() -> [Row; 2] {
    begin(Arithmetic::F64, DISC_MARGIN);
    let (axis, half_height) = axis_and_half_height();
    let half_width = half_width_of_disc(axis.x);
    let [[_, across]] = compared()[..] else { unreachable!("a disc compares one number") };
    let one = Polynomial::constant(1.0);
    let error = relative_to_sizes(&across.bounds().error, 0.0, std::slice::from_ref(&one), 1.0);
    let constant = added(half_width, &one, DISC_MARGIN, 1e-9);
    let need = ((error * U).sqrt() + 3.0 * U) / 1e-9;
    acts(half_width, 1);
    let file = "accel/bounds.rs";
    let disc = Row::new("boxes of the BVH", file, [constant, need], "10^-9 R");
    // The computed half width of the disc is at least the exact one.
    half_width.assume_relative(one, 0.0);
    forget_later(half_width);
    let half_size = half_width_of_cylinder(axis.x, half_height, Bounded::number(RADIUS, 0.0));
    let half_size = half_size * Bounded::constant(1.0 + ENLARGEMENT, 1.0);
    [disc, Row::new("half sizes of boxes", file, [ENLARGEMENT / U, half_size.raw().relative], "u")]
}

/// Checks that a number grows with the margin, or shrinks, as it must so that objects are kept.
fn acts(number: Bounded, growing: i8) {
    assert_eq!(growth(number), Some(growing), "the margin acts on the wrong side");
}

/// Runs the test of a plane that is at most `steps` steps from the origin of its frame. Returns the numbers of a plane
/// where the ray enters, and of one where it leaves.
fn distances(arithmetic: Arithmetic, steps: Polynomial, of_step: impl Fn() -> Bounded) -> [Bounded; 2] {
    lanes::begin(arithmetic, f64::from(PLANE_MARGIN));
    // The values stand for the numbers of ray and plane.
    let (origin, direction, plane, frame, step) = (3.0, 5.0, 7.0, 11.0, 17.0);
    let margins = [13.0; 3];
    let least = margin(Bounded::number(FARTHEST, 0.0), Bounded::constant(0.0, 0.0));
    let reciprocal = Bounded::constant(1.0, 0.0) / Bounded::number(DIRECTION, 1.0);
    reciprocal.assume(length(RECIPROCAL));
    let values = moved(-origin, 1.0 / direction, 1.0 / direction, margins[0]);
    let numbers = moved(Bounded::number(ORIGIN, 1.0), reciprocal, reciprocal.abs(), least);
    name(1.0 / direction, reciprocal);
    values.into_iter().zip(numbers).for_each(|(value, number)| name(value, number));
    name(plane, Bounded::of_size(STEPS, steps, 0.0));
    name(frame, Bounded::of_size(FRAME, length(FARTHEST), 0.0));
    name(step, of_step());
    let splat = |value: f32| Vec3::splat(f64::from(value));
    let ray = SlabRay::<Lane>::new(&Ray { origin: splat(origin), direction: splat(direction) }, &margins);
    let planes: Planes<f32> = [[[plane; WIDTH]; 3]; 2];
    _ = ray.in_frame(&[frame; 3], &[step; 3]).intersect(&planes, f32::INFINITY, &mut [0.0; WIDTH]);
    let [[near, _], [far, _]] = compared()[..2] else { unreachable!("a test takes a maximum and a minimum") };
    [near, far]
}

/// Returns the rows of the distance of a plane, and of its largest magnitude, which bounds all products and sums.
///
/// If a ray starts on a giant, a product may overflow. The ray then is at all planes along that axis only at a lambda
/// beyond those of all planes across the largest component of its direction, so it hits no box. Infinite distances
/// exclude all boxes, or they are NaN and keep them.
fn slabs() -> [Row; 3] {
    let [near, far] = distances(WITHOUT_UNDERFLOW, length(FARTHEST).scaled(MOST_STEPS), || Bounded::constant(1.0, 0.0));
    acts(near, -1);
    acts(far, 1);
    let size = length(RECIPROCAL).times(&sum(&[FARTHEST, ORIGIN].map(length)));
    let of = |number: Bounded| {
        let margin = f64::from(PLANE_MARGIN);
        let need = relative_to_sizes(&number.bounds().error, margin, std::slice::from_ref(&size), 1.0);
        [added(number, &size, margin, V), need]
    };
    let far_number = far;
    let [near, far] = [of(near), of(far)];
    let (constant, need) = (near[0].min(far[0]), near[1].max(far[1]));
    // Planes and origins are hardly beyond the objects. `is_in_reach` argues about origins on giants.
    let limits = [(FARTHEST, 1.01 * Extent::LARGEST), (ORIGIN, 1.01 * Extent::LARGEST)];
    let limits = limits
        .into_iter()
        .chain([(RECIPROCAL, LARGEST_RECIPROCAL.into()), (bounded::MARGIN.0, f64::from(PLANE_MARGIN))]);
    let size = far_number.bounds().size;
    let largest = limits.clone().fold(size.clone(), |size, (family, most)| size.scaled_by(family, most)).sum();
    let without_origin = limits.filter(|limit| limit.0 != ORIGIN);
    let terms = without_origin.fold(size, |size, (family, most)| size.scaled_by(family, most));
    let parts = [true, false].map(|is_of_origin| {
        let has_origin = |monomial: &[(u8, u8)]| monomial.iter().any(|variable| variable.0 == ORIGIN);
        terms.0.iter().filter(|term| has_origin(term.0) == is_of_origin).map(|term| term.1).sum::<f64>()
    });
    // The terms with the origin have the reciprocal too, which is in units of the largest one.
    let [of_origin, rest] = [parts[0] / f64::from(LARGEST_RECIPROCAL), parts[1]];
    let lambda = (f64::from(f32::MAX) - rest) / of_origin - 1.01 * Extent::LARGEST * f64::from(LARGEST_RECIPROCAL);
    let row = |what, margins, unit| Row::new(what, "accel/bvh/slab_ray.rs", margins, unit);
    let largest = [f64::from(f32::MAX) / 1e37, largest / 1e37];
    let lambda = [lambda.log2(), (lambda_across() * 1e16).log2()];
    [
        row("distance of a box's plane", [constant, need], "v (P + abs(O)) / abs(d)"),
        row("largest number of a slab test, without giants", largest, "10^37"),
        row("lambda along a slab where a product overflows", lambda, "log2"),
    ]
}

/// Returns the largest lambda of a plane across the largest component of a direction, which is at least `|d| /
/// sqrt(3)`, in units of 10^16.
fn lambda_across() -> f64 {
    // `is_within` lets an origin be farther away by a millionth.
    3.0_f64.sqrt() * 1.01 * (Extent::LARGEST / LEAST_LENGTH_SQUARED.sqrt() + FARTHEST_ORIGIN) / 1e16
}

/// Returns the row of the least move of a plane, which covers underflow with the smallest reciprocal too.
///
/// A number of steps is at most 255. What is left of the error, beside the multiples of `|r| (P + |O|)` and of the
/// product of `|r|` and a step, comes from underflow.
fn underflow() -> Row {
    let [_, far] = distances(Arithmetic::F32, Polynomial::constant(255.0), || Bounded::number(STEP, 0.0));
    let error =
        far.bounds().error.scaled_by(bounded::MARGIN.0, f64::from(PLANE_MARGIN)).enlarged(&[(bounded::MARGIN.0, None)]);
    let size = length(RECIPROCAL).times(&sum(&[FARTHEST, ORIGIN, STEP].map(length)));
    let (_, rest) = error.relative_to(&size);
    assert!(rest.0.keys().all(|monomial| monomial.iter().all(|of| of.0 == RECIPROCAL)), "{rest:?}");
    let need = rest.sum() * V * LONGEST_SQUARED.sqrt();
    let margins = [f64::from(LEAST_MARGIN) * 1e14, need * 1e14];
    Row::new("least move of a box's plane", "accel/bvh/slab_ray.rs", margins, "10^-14")
}

/// Returns the row of the lambda that the least move is at least, if a reciprocal is limited. It must exceed the lambda
/// of every plane across the largest component of the direction.
fn limited_reciprocal() -> Row {
    let constant = f64::from(LEAST_MARGIN) * f64::from(LARGEST_RECIPROCAL) / 1e16;
    Row::new("lambda along a slab", "accel/bvh/slab_ray.rs", [constant, lambda_across()], "10^16")
}

/// Returns the row of the largest number of a sphere leaf's test, if the ray starts on a giant.
fn overflow_of_spheres() -> Row {
    let SphereNumbers { pairs: [[_, leaves], [enters, _], squares], .. } = sphere_numbers(false);
    // No vector is longer than `sqrt(3)` times its largest component.
    let limits = [
        (FARTHEST, 1.75 * Extent::LARGEST),
        (RADIUS, 1.75 * Extent::LARGEST),
        (ORIGIN, 1.75 * FARTHEST_ORIGIN),
        (RECIPROCAL, 1.0 / LEAST_LENGTH_SQUARED.sqrt()),
        (bounded::MARGIN.0, f64::from(PLANE_MARGIN)),
    ];
    let numbers = [leaves, enters, squares[0], squares[1]].map(|number| number.bounds().size);
    let largest = numbers.map(|size| limits.iter().fold(size, |size, of| size.scaled_by(of.0, of.1)).sum());
    let most = [f64::from(f32::MAX), largest.into_iter().fold(0.0, f64::max)].map(|most| most / 1e34);
    Row::new("largest number of a sphere leaf", "accel/bvh/sphere_ray.rs", most, "10^34")
}

/// Returns the row of the lambda that a box may have at most, relative to that of the closest hit. It must exceed the
/// error of an accepted lambda. All significands are tried, each with the largest lambda that rounds to it.
fn closest_so_far() -> Row {
    let excess = (1.0_f32.to_bits()..2.0_f32.to_bits()).map(|bits| {
        let rounded = f32::from_bits(bits);
        let lambda = f64::midpoint(rounded.into(), rounded.next_up().into());
        let least = farthest_for(lambda).min(farthest_for(lambda.next_down()));
        (f64::from(least) - lambda) / lambda / U
    });
    let margins = [excess.fold(f64::INFINITY, f64::min), CYLINDER_BOUND.lambda_error() / 3.0 / U];
    Row::new("the closest lambda so far", "accel/bvh.rs", margins, "u lambda")
}

/// Returns the row of the bounding spheres of leaves.
///
/// The box's middle is at most half as far from the sphere's centre, along each axis, as rounding moves a plane, and
/// `sqrt(3)` times that in space. The proof tries all 2^23 significands of a plane in single precision. To each it
/// takes the smallest coordinate that rounds to it. The numbers that are compared with a plane have errors too.
fn leaves() -> Row {
    lanes::begin(WITHOUT_UNDERFLOW, f64::NAN);
    let (center, radius, plane) = (3.0, 5.0, 7.0);
    name(center, Bounded::of_size(STEPS, length(FARTHEST), 0.0));
    name(radius, Bounded::of_size(CROSS, length(FARTHEST), 0.0));
    name(plane, Bounded::of_size(FRAME, length(FARTHEST), 0.0));
    let rows = [[center; WIDTH], [center; WIDTH], [center; WIDTH], [radius; WIDTH]];
    let bounds = Bounds { low: [plane; 3], high: [plane; 3] };
    _ = SphereLeaf { rows: &rows, frame: Frame::IDENTITY }.overlaps::<Lane>(&bounds);
    let needs = compared()
        .into_iter()
        .flatten()
        .map(|number| relative_to_sizes(&number.bounds().error, 0.0, &[length(FARTHEST)], 1.0));
    let moved = (1.0_f32.to_bits()..2.0_f32.to_bits()).map(|bits| {
        let rounded = f32::from_bits(bits);
        let coordinate = f64::midpoint(rounded.next_down().into(), rounded.into());
        let most = above(coordinate.next_up()).max(above(coordinate));
        (f64::from(most) - coordinate) / coordinate / V
    });
    let need = moved.fold(0.0, f64::max) / 2.0 * 3.0_f64.sqrt() + needs.fold(0.0, f64::max);
    // By how much the radius around this cube exceeds 1, for a largest coordinate of 1.
    let cube = BoundingSphere::of(&Bounds { low: [-1.0; 3], high: [1.0; 3] });
    let constant = (cube.radius_around([0.0; 3]) - 1.0) / V;
    Row::new("bounding spheres of leaves", "accel/bvh/sphere_leaf.rs", [constant, need], "v P")
}

/// The numbers of the test of one bounding sphere.
struct SphereNumbers {
    cross: [Lane; 3],
    radius: Lane,
    /// The pairs that the test compares: where the ray leaves the sphere, where it enters, and the squares.
    pairs: [[Bounded; 2]; 3],
}

/// Runs the test of a bounding sphere on one ray. With `is_exact`, the cross product and the enlarged radius count as
/// exact, with the family [`CROSS`].
fn sphere_numbers(is_exact: bool) -> SphereNumbers {
    lanes::begin(Arithmetic::F32, f64::from(PLANE_MARGIN));
    // Values that stand for the numbers of ray and sphere.
    let (origin, direction, frame) = ([3.0, 5.0, 7.0], [11.0, 13.0, 17.0], [19.0_f32, 23.0, 29.0]);
    let (margins, centers, radius) = ([31.0; 3], [37.0, 41.0, 43.0], 47.0);
    let farthest = Bounded::vector(FARTHEST, 0.0).to_array();
    let [from, along] =
        [(ORIGIN, 1.0), (DIRECTION, 1.0)].map(|(family, error)| Bounded::vector(family, error).to_array());
    let least = farthest.map(|coordinate| margin(coordinate, Bounded::constant(0.0, 0.0)));
    let (along, reciprocal) = unit(along, Bounded::number(SQUARE, 1.0));
    reciprocal.assume(length(RECIPROCAL));
    let length_squared: f32 = direction.iter().map(|component| component * component).sum();
    let (values, inverse) = unit(direction, length_squared);
    name(inverse, reciprocal);
    name(enlargement(origin, margins), enlargement(from, least));
    for axis in 0..3 {
        let of = |family: u8| Polynomial::of([(family, axis as u8)]);
        along[axis].assume(of(AXIS));
        name(values[axis], along[axis]);
        let start = Bounded::of_size(FRAME + axis as u8, of(FARTHEST), 0.0) - from[axis];
        name(frame[axis] - origin[axis], start);
        name(centers[axis], Bounded::of_size(STEPS + axis as u8, of(FARTHEST).scaled(MOST_STEPS), 0.0));
    }
    name(radius, Bounded::number(RADIUS, 0.0));
    let rows = [[centers[0]; WIDTH], [centers[1]; WIDTH], [centers[2]; WIDTH], [radius; WIDTH]];
    let leaf = SphereLeaf { rows: &rows, frame: Frame { origin: frame, ..Frame::IDENTITY } };
    // The centre is at most `P` from the middle of the scene along each axis, and a step more.
    let (to_center, radius) = leaf.load::<Lane>(0, &origin);
    for (axis, Lane(number)) in (0..).zip(to_center) {
        let [farthest, origin] = [FARTHEST, ORIGIN].map(|family| Polynomial::of([(family, axis)]));
        number.assume(farthest.scaled(MOST_STEPS / 2.0).plus(&origin));
    }
    let radius = radius + Lane::splat(enlargement(origin, margins));
    let cross = cross(to_center, values.map(Lane::splat));
    if is_exact {
        cross.iter().chain([&radius]).for_each(|lane| lane.0.assume_relative(length(CROSS), 0.0));
    }
    let ray = Ray { origin: origin.map(f64::from).into(), direction: direction.map(f64::from).into() };
    let ray = SphereRay::new(&ray, &margins, length_squared.into());
    _ = ray.intersect::<_, Lane>(&leaf, f32::INFINITY, &mut [0.0; WIDTH]);
    let pairs = compared()[..3].try_into().expect("a test compares three pairs");
    SphereNumbers { cross, radius, pairs }
}

/// Returns the rows of bounding spheres: how near the line passes, where the ray enters, and where it leaves.
///
/// The computed cross product is at most `R + e`, with its error `e`, and the enlarged radius is at least `R` plus the
/// margin. Both are compared by their squares. If their errors are at most `k u` times the square of the radius, it is
/// enough that the margin exceeds `e` by `k u` times the radius, which is at most `P + |O|` itself.
fn bounding_spheres() -> [Row; 3] {
    let size = sum(&[FARTHEST, ORIGIN].map(components));
    // Beside the multiples of a size, the margin has a part that covers underflow. In lambda the least one covers it.
    let least = 6.0 * f64::from(LEAST_MARGIN);
    let need = |error: &Polynomial, unit: &Polynomial| {
        let sizes = [sum(&[FARTHEST, ORIGIN].map(length)), length(RADIUS), size.clone()].map(|size| size.times(unit));
        relative_to_sizes(error, f64::from(PLANE_MARGIN), &sizes, (least / V).min(LAMBDA_MIN))
    };
    let SphereNumbers { cross, radius, pairs: [[_, leaves], [enters, _], [_, rest]] } = sphere_numbers(false);
    for (number, growing) in [(radius.0, 1), (rest, 1), (leaves, 1), (enters, -1)] {
        acts(number, growing);
    }
    let constant = added(radius.0, &size, f64::from(PLANE_MARGIN), V);
    let of_cross = sum(&cross.map(|lane| lane.0.raw().error)).plus(&radius.0.bounds().error).in_lengths();
    let (one, reciprocal) = (Polynomial::constant(1.0), length(RECIPROCAL));
    let [passes, leaves, enters] =
        [(of_cross, &one), (leaves.bounds().error, &one), (enters.bounds().error, &reciprocal)]
            .map(|(error, unit)| need(&error, unit));
    let SphereNumbers { pairs: [.., [squares, rest]], .. } = sphere_numbers(true);
    let squares = squares.bounds().error.plus(&rest.bounds().error);
    let squares = relative_to_sizes(&squares, 0.0, &[squared(CROSS)], least * least);
    let row = |what, need| Row::new(what, "accel/bvh/sphere_ray.rs", [constant, need], "v (P + abs(O))");
    [
        row("the line misses a sphere of a leaf", passes + squares),
        row("the ray enters a sphere of a leaf", enters),
        row("the ray leaves a sphere of a leaf", leaves),
    ]
}
