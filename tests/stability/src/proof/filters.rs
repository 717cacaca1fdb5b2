//! The margins of the conservative tests, in `f64` and in `f32`.

use std::slice;

use cpu::internals::accel::extent::Extent;
use cpu::internals::accel::inside::{STEEP_SHARE, is_steep};
use cpu::internals::accel::may_hit::conservative::{ConservativeRay, LEAST_LENGTH_SQUARED, QUADRATIC_MARGIN};
use cpu::internals::accel::may_hit::filter_ray::{
    BoundingSpheres, CYLINDER_MARGIN, FilterRay, InfiniteCylinders, SPHERE_MARGIN,
};
use cpu::internals::accel::may_hit::target::{SLACK, Target};
use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::{Ray, Vec3};

use super::bounded::{Bounded, begin, compared};
use super::bounds::Arithmetic;
use super::direction::growth;
use super::lanes::{self, Lane, name};
use super::parts::axis_and_half_height;
use super::polynomial::Polynomial;
use super::row::{Domain, Row, U, added, enlarged, family::*, is, length, ray, relative_to_sizes, squared};

/// The directions that are not too short, and the scenes of moderate extent.
fn moderate() -> Domain {
    Domain { direction: LEAST_LENGTH_SQUARED.sqrt(), size: Extent::SMALLEST, underflow: 0.0 }
}

/// The family of the scene's largest coordinate `L`.
pub const EXTENT: u8 = DERIVED + 8;

/// The value by which the flat filter multiplies the size of a cylinder.
pub const FLAT_MARGIN: f64 = (4.0 * CYLINDER_MARGIN) as f32 as f64;

/// Returns the rows of all tests.
#[must_use]
pub fn rows() -> Vec<Row> {
    let mut rows = vec![steep()];
    for is_sphere in [true, false] {
        rows.extend(conservative(is_sphere));
    }
    rows.push(beyond_a_cap());
    rows.extend(flat_filter());
    rows
}

/// Returns `|O - C|^2 + R^2`.
fn size_of_c() -> Polynomial {
    squared(TO_CENTER).plus(&squared(RADIUS))
}

/// Returns a target whose numbers are rounded.
pub fn target(is_sphere: bool) -> Target<Bounded> {
    let (axis, half_height) = axis_and_half_height();
    let radius = Bounded::number(if is_sphere { RADIUS } else { INNER_RADIUS }, 0.0);
    let bounding_radius_squared = radius * radius + half_height * half_height;
    bounding_radius_squared.assume(squared(RADIUS));
    let half_height = half_height + Bounded::number(EXTENT, 0.0) * Bounded::constant(SLACK, 0.0);
    let center = Bounded::vector(CENTER, 0.0);
    Target { center, axis, radius_squared: radius * radius, bounding_radius_squared, half_height }
}

/// Returns the row of rays that certainly are not parallel to the caps.
///
/// The code requires that the slope is at least twice the limit. So it is enough that its error is at most half of it.
fn steep() -> Row {
    begin(Arithmetic::F64, STEEP_SHARE);
    let (ray, target) = (ray(), target(false));
    is(target.center - ray.origin, TO_CENTER);
    let test = ConservativeRay::new(ray);
    let (_, slope, _) = test.cylinder_quadratic(&target);
    _ = is_steep(slope, test.length_squared);
    let [least, _] = compared()[compared().len() - 1];
    let constant = added(least, &squared(DIRECTION), STEEP_SHARE, U) * U;
    let need = 2.0 * relative_to_sizes(&slope.bounds().error, 0.0, &[length(DIRECTION)], moderate().direction);
    Row::new("steep rays inside a cylinder", "accel/inside.rs", [constant.sqrt() / U, need], "u abs(d)")
}

/// Returns the row of rays that start beyond a cap.
///
/// For a hit, the ray's origin and the point at `t` are at most `2 sqrt(3) L` from the points of the object. This is
/// below `3.5 L`, which also covers a start that rounding has moved out of the scene's extent.
fn beyond_a_cap() -> Row {
    begin(Arithmetic::F64, SLACK);
    let (ray, target) = (ray(), target(false));
    is(target.center - ray.origin, TO_CENTER);
    _ = ConservativeRay::new(ray).cylinder(&target);
    let [limit, past] = compared()[3];
    let error = in_t(limit).plus(&in_t(past)).scaled_by(TO_CENTER, 3.5).scaled_by(DIRECTION, 3.5);
    let error = enlarged(&error).enlarged(&[TO_CENTER, DIRECTION, HALF_HEIGHT].map(|family| (family, Some(EXTENT))));
    let size = length(EXTENT);
    let constant = added(limit, &size, SLACK, U);
    let need = relative_to_sizes(&error, SLACK, slice::from_ref(&size), moderate().size);
    Row::new("the ray starts beyond a cap", "accel/may_hit/target.rs", [constant, need], "u L")
}

/// Returns the rows of a conservative test: the discriminant, the quadratic at the smallest lambda `t`, and the same
/// for rays that are certainly inside.
fn conservative(is_sphere: bool) -> [Row; 3] {
    begin(Arithmetic::F64, QUADRATIC_MARGIN);
    let (ray, target) = (ray(), target(is_sphere));
    is(target.center - ray.origin, TO_CENTER);
    let test = ConservativeRay::new(ray);
    let quadratic = if is_sphere {
        _ = test.sphere(&target);
        test.sphere_quadratic(&target)
    } else {
        _ = test.cylinder(&target);
        test.cylinder_quadratic(&target).0
    };
    let [[discriminant, _], _, [_, at_first]] = compared()[..3] else { unreachable!("a test compares three numbers") };
    _ = test.starts_within(&quadratic);
    let [inside, _] = compared()[compared().len() - 1];
    let size = squared(DIRECTION).times(&size_of_c());
    let need = moderate().relative(&discriminant.bounds().error, &size, QUADRATIC_MARGIN);
    let names = if is_sphere {
        ["the line misses a sphere", "the ray has passed a sphere", "the ray starts in a sphere"]
    } else {
        ["the line misses a cylinder", "the ray has passed a cylinder", "the ray starts in a cylinder"]
    };
    let [misses, passed, starts] = names;
    let row = |what, file, number, size: &Polynomial, need, unit| {
        Row::new(what, file, [added(number, size, QUADRATIC_MARGIN, U), need], unit)
    };
    let conservative = "accel/may_hit/conservative.rs";
    let passed_need = relative_to_sizes(&in_t(at_first), QUADRATIC_MARGIN, &sizes_of_points(), moderate().size.powi(2));
    // Whether a ray that is not inside is found inside does not depend on how far it goes.
    let all = size_of_c().plus(&squared(DIRECTION));
    let inside_need =
        relative_to_sizes(&in_t(inside), QUADRATIC_MARGIN, slice::from_ref(&all), moderate().size.powi(2));
    let with_t = size_of_c().plus(&squared(DIRECTION).scaled(LAMBDA_MIN * LAMBDA_MIN));
    [
        row(misses, conservative, discriminant, &size, need, "u M"),
        row(passed, conservative, at_first, &size_of_c(), passed_need, "u (q + R^2)"),
        row(starts, "accel/inside.rs", inside, &with_t, inside_need, "u (a t^2 + q + R^2)"),
    ]
}

/// Returns the error of `f(t)` with `t |d|` in place of `|d|`.
fn in_t(number: Bounded) -> Polynomial {
    number.bounds().error.scaled_by(DIRECTION, 1.0 / LAMBDA_MIN)
}

/// Returns bounds of `|O - C|^2 + R^2`, for a ray that has a point of the bounding sphere at `t` or later.
///
/// For such a ray `t |d| <= |O - C| + R`. So `t^2 |d|^2` is at most `2 (|O - C|^2 + R^2)`, and `t |d| |O - C|` at most
/// `1.5` times as much.
fn sizes_of_points() -> [Polynomial; 3] {
    let product = length(DIRECTION).times(&length(TO_CENTER)).scaled(1.0 / 1.5);
    [size_of_c(), squared(DIRECTION).scaled(0.5), product]
}

/// Returns the rows of the flat filter. Its errors are relative to `S = |C|^2 + |O|^2 + R^2`, as coordinates are
/// relative to the middle of the scene: those of four times the discriminants to `4 a S`, and that of `f(t)` to `S`.
fn flat_filter() -> [Row; 3] {
    const V: f64 = Arithmetic::F32.roundoff;
    let squares = squared(CENTER).plus(&squared(ORIGIN)).plus(&squared(RADIUS));
    let row = |what, constant: f64, number: Bounded, size: &Polynomial| {
        let need = moderate().relative(&number.bounds().error, size, FLAT_MARGIN);
        Row::new(what, "accel/may_hit/filter_ray.rs", [constant / V, need], "v a S")
    };
    let size = squared(DIRECTION).times(&squares).scaled(4.0);
    // The margin of a sphere is a part of the factors of `|C|^2`, `R^2` and `|O|^2`. Those of the first two are in
    // values that must be known.
    let lowered = f64::from((1.0 - SPHERE_MARGIN) as f32);
    let of_origin = squared(DIRECTION).times(&squared(ORIGIN)).scaled(4.0);
    let FlatNumbers { sphere, at_first, .. } = flat_numbers(lowered);
    let used = added(sphere, &of_origin, lowered, 1.0);
    // A number that is positive makes the filter discard an object. `lowered` is smaller if the margin is larger.
    assert_eq!([sphere, at_first].map(growth), [Some(1); 2], "the margin acts on the wrong side");
    let FlatNumbers { sphere, at_first, cylinder } = flat_numbers(FLAT_MARGIN);
    assert_eq!(growth(cylinder), Some(-1), "the margin acts on the wrong side");
    // A ray that has a point of the bounding sphere at t or later has `t |d| <= |C| + |O| + R`.
    let products = [CENTER, ORIGIN].map(|family| length(DIRECTION).times(&length(family)).scaled(0.5));
    let [center, origin] = products;
    let sizes = [squares, squared(DIRECTION).scaled(1.0 / 3.0), center, origin];
    let passed = relative_to_sizes(&in_t(at_first), SPHERE_MARGIN, &sizes, moderate().size.powi(2));
    let misses = row("the line misses a bounding sphere", SPHERE_MARGIN * used, sphere, &size);
    [
        Row { what: "the ray has passed a bounding sphere", need: passed, unit: "v S", ..misses.clone() },
        misses,
        Row {
            constant: added(cylinder, &size, FLAT_MARGIN, V),
            ..row("the line misses an infinite cylinder", CYLINDER_MARGIN, cylinder, &size)
        },
    ]
}

/// What the flat filter compares with 0: four times the discriminants, and `f(t)`.
pub struct FlatNumbers {
    /// Of a sphere, less its margin.
    pub sphere: Bounded,
    /// The bounding sphere's `f(t)`, less its margin.
    pub at_first: Bounded,
    /// Of a cylinder, less its margin.
    pub cylinder: Bounded,
}

/// Runs the flat filter on one ray and one object.
pub fn flat_numbers(margin: f64) -> FlatNumbers {
    // The code doubles all terms of a cylinder, and multiplies the margin by 4.
    lanes::begin(Arithmetic::F32, margin);
    const ROOT: f64 = std::f64::consts::SQRT_2;
    // Values that stand for the numbers of ray and object.
    let (origin, direction, center) =
        (Vec3::new(3.0, 5.0, 7.0), Vec3::new(11.0, 13.0, 17.0), Vec3::new(19.0, 23.0, 29.0));
    let (axis, radius_squared, half_height) = (Vec3::new(0.48, 0.6, 0.64), 961.0, 37.0);
    let mut derived = DERIVED;
    let mut known = |value: f64, size: Polynomial| {
        derived += 1;
        // Rounded once to f32, after a few roundings of f64.
        let number = Bounded::of_size(derived, size, 1.0 + 16.0 * U / Arithmetic::F32.roundoff);
        name(value as f32, number);
        number
    };
    for (family, vector, factor) in
        [(ORIGIN, origin, 1.0), (DIRECTION, direction, 1.0), (CENTER, center, 2.0), (AXIS, axis, ROOT)]
    {
        for (component, value) in (0..).zip(vector.to_array()) {
            known(value * factor, Polynomial::of([(family, component)]).scaled(factor));
        }
    }
    let squares = squared(CENTER).plus(&squared(RADIUS));
    _ = known(direction.dot(direction), squared(DIRECTION)).of_squares();
    known(center.dot(center) * (1.0 - SPHERE_MARGIN) - radius_squared * (1.0 + SPHERE_MARGIN), squares.clone());
    known(center.dot(axis * ROOT), length(CENTER).scaled(ROOT));
    known(2.0 * half_height * half_height, squared(RADIUS).scaled(2.0));
    _ = known(center.dot(center) + radius_squared, squares).of_squares();
    let (mut spheres, mut cylinders) = (BoundingSpheres::EMPTY, InfiniteCylinders::EMPTY);
    let target = Target { center, axis, radius_squared, bounding_radius_squared: radius_squared, half_height };
    spheres.set(0, center, radius_squared);
    cylinders.set(0, center, &target);
    let ray = FilterRay::<Lane>::new(&Ray { origin, direction }, Vec3::ZERO);
    let test = ray.spheres(&spheres, 0);
    let [[_, at_first], [sphere, _]] = compared()[..] else { unreachable!("a test takes a minimum and a maximum") };
    FlatNumbers { sphere, at_first, cylinder: ray.cylinders(&test, &cylinders, 0).0 }
}
