//! The margins of a cylinder's parts: the planes and discs of the caps, and the height of a hit on the side.

use std::slice;

use cpu::Vec3;
use cpu::internals::accel::isolated::SEPARATION;
use cpu::internals::exact::cylinder_decision::{CYLINDER_BOUND, CapPlane, LEAST_REACH};
use cpu::internals::exact::cylinder_lanes::SideLanes;
use cpu::internals::exact::cylinder_plain::PlainSide;
use cpu::internals::exact::order::{ERROR_OF_CAP_ORDER, is_certainly_closer};
use cpu::internals::exact::sphere_wide;
use cpu::internals::geometry::{cylinder::CylinderRecord, ray::LAMBDA_MIN};
use cpu::internals::math::real::Real;

use super::bounded::{Bounded, begin, compared};
use super::bounds::Arithmetic;
use super::direction::{growth, hardens};
use super::polynomial::{LENGTH, Polynomial};
use super::row::{
    IN_SCALE, Row, U, added, components, factors, family::*, is, length, ray, relative_to_sizes, sum, uses_of_margin,
};

const FILE: &str = "exact/cylinder_decision.rs";

/// The family of an accurate lambda.
const LAMBDA: u8 = DERIVED;
/// The family of the axis of the file.
pub const FILE_AXIS: u8 = DERIVED + 1;

/// The part of a distance that the error of lambda moves, as a multiple of `u lambda |d|_1`.
const MOVED: f64 = 2.0 * CYLINDER_BOUND.lambda_error() / U;
/// The part of a distance that other errors move, as a multiple of `u X`.
const FIXED: f64 = 64.0;

/// Returns the unit axis and half of the height of the cylinder with an axis of the file.
pub fn axis_and_half_height() -> (Vec3<Bounded>, Bounded) {
    let axis = Bounded::vector(FILE_AXIS, 0.0);
    let (unit, half_height) = (axis.unit(), axis.length() / Bounded::constant(2.0, 0.0));
    is(unit, AXIS);
    half_height.assume(length(HALF_HEIGHT));
    (unit, half_height)
}

/// Returns the record of a cylinder, and states that `from_center` of it is the vector of `TO_CENTER`.
pub fn record() -> CylinderRecord<Bounded> {
    let (axis, half_height) = axis_and_half_height();
    CylinderRecord::with_unit_axis(Bounded::vector(CENTER, 0.0), Bounded::number(RADIUS, 0.0), axis, half_height)
}

/// Returns the rows. `of_side` is the relative error of an accepted lambda of the side, in units of `u`.
pub fn rows(of_side: f64) -> Vec<Row> {
    let row = |what, constant, need, unit| Row::new(what, FILE, [constant, need], unit);
    let slope = slope();
    let ([constant, need], of_cap) = plane(slope[1] - 1.0);
    let [[side, to_side], [cap, to_cap]] = [height(of_side), disc(of_cap)];
    vec![
        row("slope of a ray along an axis", slope[0], slope[1], "u abs(d)"),
        row("distance of a cap's plane", constant, need, "u X"),
        row("lambda of a cap", CYLINDER_BOUND.lambda_error() / 3.0 / U, of_cap, "u lambda"),
        row("height of a hit, due to lambda", side[0], to_side[0], "u lambda abs(d)"),
        row("height of a hit, due to the reach", side[1], to_side[1], "u X"),
        row("distance from a cap's centre, due to lambda", cap[0], to_cap[0], "u lambda abs(d)"),
        row("distance from a cap's centre, due to the reach", cap[1], to_cap[1], "u X"),
        order(of_cap),
        caps(),
        wide_sphere(),
        isolated(of_cap),
    ]
}

/// Returns the row of the order of two hits, each with this relative error of lambda.
fn order(of_lambda: f64) -> Row {
    let (margin, size) = (CYLINDER_BOUND.lambda_error(), length(LAMBDA));
    begin(Arithmetic::F64, margin);
    let lambda = Bounded::number(LAMBDA, of_lambda);
    _ = is_certainly_closer(lambda, lambda);
    let [[nearer, farther]] = first(0);
    let error = nearer.bounds().error.plus(&farther.bounds().error);
    let margins = [added(nearer, &size, margin, U), relative_to_sizes(&error, margin, &[size], 1.0)];
    Row::new("order of two hits", "exact/order.rs", margins, "u lambda")
}

/// Returns the row of the order of two caps, for the errors of the operations on
/// [`DoubleDouble`](cpu::internals::math::double_double). A distance has those of a difference, a product and two sums,
/// and a slope those of a product and two sums. A product and a difference follow. The need is twice the sum of these
/// errors, because products of two errors are left out of the sum.
fn caps() -> Row {
    let [sum, product] = [3.0, 4.0];
    let (distance, slope) = (sum + product + 2.0 * sum, product + 2.0 * sum);
    let need = 2.0 * (distance + slope + product + sum);
    Row::new("order of two caps", "exact/order.rs", [ERROR_OF_CAP_ORDER / (U * U), need], "u^2")
}

/// Returns the row of a sphere in double-double arithmetic, for the errors of the operations on
/// [`DoubleDouble`](cpu::internals::math::double_double). The need is that of the discriminant `h^2 - a c`, relative to
/// the sizes of its terms, which includes those of `h`, `a` and `c`. It is doubled as in [`caps`].
fn wide_sphere() -> Row {
    let [sum, product] = [3.0, 4.0];
    let dot = product + 2.0 * sum;
    // A product of a difference and a sum, which is added to two squares. An `ExactSum` needs less: 12.
    let c = (2.0 * sum + product) + 2.0 * sum;
    let need = 2.0 * ((dot + dot + product) + (dot + c + product) + sum);
    Row::new("sphere in double-double", "exact/sphere_wide.rs", [sphere_wide::WIDE_ERROR / (U * U), need], "u^2")
}

/// Returns the row of isolated objects, for this relative error of every lambda.
///
/// A ray between points of the scene is at most `2 sqrt(3) L` long, and one inside an object `2 L`. The first moves the
/// start. The second moves the end, and the hit on another object that is compared with the end. The rounding of points
/// adds less than 64 u L.
fn isolated(of_lambda: f64) -> Row {
    let need = ((12.0_f64.sqrt() + 2.0 * 2.0) * of_lambda + 64.0) * U * 1e9;
    Row::new("isolated objects", "accel/isolated.rs", [SEPARATION * 1e9, need], "10^-9 L")
}

/// Returns the least that the code adds in the comparisons in which the margin takes part. There must be `count` of
/// them.
fn least_added(count: usize, size: &Polynomial, margin: f64) -> f64 {
    assert_eq!(uses_of_margin(), count, "the code does not use the margin in all comparisons");
    let numbers = compared().into_iter().flatten().filter(|&number| growth(number) != Some(0));
    numbers.map(|number| added(number, size, margin, U)).fold(f64::MAX, f64::min)
}

/// Returns the constant and the need of a ray's slope along the axis, relative to `|d|_1`.
fn slope() -> [f64; 2] {
    begin(Arithmetic::F64, 8.0 * U);
    let (ray, record) = (ray(), record());
    _ = CapPlane::new(&record, &ray, record.top);
    // The slope is compared with the limit of parallel rays from both sides, and with the distance of the plane.
    assert_eq!(uses_of_margin(), 3, "the code compares the slope");
    let ([[steep, _], [parallel, _], [_, behind]], size) = (first(0), components(DIRECTION));
    let need = relative_to_sizes(&steep.raw().error, 8.0 * U, slice::from_ref(&size), IN_SCALE.direction);
    let sizes =
        [(steep, 1.0), (parallel, 1.0), (behind, LAMBDA_MIN)].map(|(number, of)| (number, size.clone().scaled(of)));
    let constants = sizes.map(|(number, size)| added(number, &size, 8.0 * U, U));
    [constants.into_iter().fold(f64::MAX, f64::min), need]
}

/// Returns `N` pairs of numbers that were compared.
fn first<const N: usize>(from: usize) -> [[Bounded; 2]; N] {
    compared()[from..from + N].try_into().expect("there are so many")
}

/// Returns the constant and the need of the distance from the origin to a cap's plane, relative to the reach of
/// cylinder and distance. Then returns the relative error of an accepted lambda, for this error of the slope.
fn plane(of_slope: f64) -> ([f64; 2], f64) {
    let run = |margin: f64| {
        begin(Arithmetic::F64, margin);
        let (ray, record) = (ray(), record());
        is(record.top - ray.origin, TO_CENTER);
        _ = CapPlane::new(&record, &ray, record.top);
        first::<1>(2)
    };
    // A vector's length is at most the sum of its components' magnitudes.
    let extent = sum(&[components(CENTER), components(TO_CENTER), length(HALF_HEIGHT)]);
    let sizes = [sum(&[CENTER, TO_CENTER, HALF_HEIGHT].map(length)), extent.clone()];
    let need = |number: Bounded| relative_to_sizes(&number.bounds().error, 16.0 * U, &sizes, LEAST_REACH);
    let [[distance, _]] = run(16.0 * U);
    let row = [added(distance, &extent, 16.0 * U, U), need(distance)];
    // Lambda is accepted if the distance exceeds `X / (4 k)`, and the slope `|d|_1 / (8 k)`.
    let k = CYLINDER_BOUND.condition_limit;
    // The sign of the distance is not known.
    for (limit, effect) in [(4.0 * k, None), (8.0 * k, Some(-1))] {
        run(limit);
        let effects = compared().into_iter().map(hardens).filter(|effect| *effect != Some(0));
        assert!(effects.eq([effect]), "the code compares with {limit}");
    }
    let [x, y] = [(row[1] - 1.0) * 4.0 * k * U, of_slope * 8.0 * k * U];
    (row, (1.0 / ((1.0 - x) * (1.0 - y)) - 1.0) / U + 1.0)
}

/// Returns the constants and the needs of two margins, relative to `lambda |d|_1` and to `X`: `run` gives the number of
/// comparisons in which the margins take part, and an error that they cover. `split` is a vector that is not longer
/// than `lambda |d| + X`.
fn margins(split: u8, run: impl Fn() -> (usize, Polynomial)) -> [[f64; 2]; 2] {
    let moved = |direction: Polynomial| length(LAMBDA).times(&direction);
    let fixed = sum(&[components(CENTER), length(HALF_HEIGHT), length(RADIUS)]);
    let sizes = [
        length(split),
        Polynomial::of([(split, 0)]),
        moved(length(DIRECTION)),
        moved(Polynomial::of([(DIRECTION, 0)])),
        moved(components(DIRECTION)),
        sum(&[CENTER, HALF_HEIGHT, RADIUS].map(length)),
        sum(&[Polynomial::of([(CENTER, 0)]), Polynomial::of([(AXIS, 0), (HALF_HEIGHT, LENGTH)])]),
        fixed.clone(),
    ];
    let pair = [(MOVED, moved(components(DIRECTION))), (FIXED, fixed)].map(|(margin, size)| {
        begin(Arithmetic::F64, margin * U);
        let (count, error) = run();
        (least_added(count, &size, margin * U), factors(&error, margin * U, &sizes, LEAST_REACH))
    });
    let need = |factors: &[f64], from: usize| factors[..2].iter().chain(&factors[from..from + 3]).sum();
    [[pair[0].0, pair[1].0], [need(&pair[0].1, 2), need(&pair[1].1, 5)]]
}

/// States that the number is an accepted lambda, which is positive, with this relative error.
fn accepted(lambda: Bounded, error: f64) {
    lambda.assume_relative(length(LAMBDA), error);
    _ = lambda.of_squares();
}

/// Returns the margins of the height of a hit on the side, and then what it needs: each due to lambda, and due to the
/// reach.
///
/// `|O - C| <= lambda |d| + |P - C|` for the hit point `P`, which is at most `X` away from the centre.
fn height(of_side: f64) -> [[f64; 2]; 2] {
    margins(TO_CENTER, || {
        let (ray, record) = (ray(), record());
        is(ray.origin - record.center, TO_CENTER);
        let view = record.seen_from(ray.origin);
        let (a, h, discriminant) = record.quadratic(&view, ray.direction);
        let root = discriminant.sqrt();
        for numerator in [-h - root, -h + root] {
            accepted(numerator / a, of_side);
        }
        _ = SideLanes::new(&PlainSide::new(&record, &view, &ray, false));
        // One comparison of `c` and four of the root come first. Entry and exit have four of the height each.
        let [[along, within]] = first(5);
        (8, along.bounds().error.plus(&within.bounds().error))
    })
}

/// Returns the margins of the distance of a hit from a cap's centre.
///
/// The errors of the three components are alike, so the length of the error is at most the same multiple of lengths.
/// The ray starts at most `lambda |d| + |P|` from the scene's origin, and the hit point `P` at most `X`.
fn disc(of_cap: f64) -> [[f64; 2]; 2] {
    margins(ORIGIN, || {
        let (ray, record) = (ray(), record());
        let to_plane = (record.top - ray.origin).dot(record.axis);
        let lambda = to_plane / ray.direction.dot(record.axis);
        accepted(lambda, of_cap);
        let point = (ray.at(lambda) - record.top).x.raw().error;
        let rounding = length(RADIUS).scaled(Bounded::vector(FILE_AXIS, 0.0).length().raw().relative);
        let plane = CapPlane::new(&record, &ray, record.top);
        let from = compared().len() + 1;
        _ = plane.disc(&record, &ray);
        let [[_, within]] = first(from);
        (2, point.plus(&rounding).plus(&within.raw().error))
    })
}
