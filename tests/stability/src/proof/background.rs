//! The margins of the background: of its colour, of the interval that contains the mean of a pixel, and of the
//! remainder of its derivative.

use cpu::Vec3;
use cpu::internals::geometry::camera::Camera;
use cpu::internals::render::background::{Background, interval};
use cpu::internals::render::background_derivative::{DerivativeBound, PixelReach};
use cpu::internals::render::background_pixels::rounding;
use cpu::internals::render::ray_error::RayError;

use super::bounded::{Bounded, begin};
use super::bounds::Arithmetic;
use super::interval::{Interval, Taylor, at_most};
use super::polynomial::Polynomial;
use super::row::{Row, U, components, factors, family::*, length, relative_to_sizes, sum};
use super::ruled::Ruled;

/// The families of a reciprocal length, of the sides of a pixel, of the remainder, and of colours.
const RECIPROCAL: u8 = DERIVED;
const SIDES: [u8; 2] = [DERIVED + 1, DERIVED + 2];
const REMAINDER: u8 = DERIVED + 3;
const COLORS: [u8; 2] = [DERIVED + 4, DERIVED + 5];

/// Returns the rows of the rounding that the interval of a mean allows, for each sample and for each pixel.
///
/// A sum in order of `n` colours adds at most `n - 1` roundings of at most `n`, and its quotient by `n` one of 1. The
/// mean of the samples' offsets, each at most 1/2, has as many. It is multiplied by the derivatives, whose sum is below
/// 2, and by 1/2.
#[must_use]
pub fn rows() -> [Row; 3] {
    let row = |what, constant: f64, need| Row::new(what, "render/background_pixels.rs", [constant / U, need], "u");
    [
        row("mean of a background, for each sample", rounding(1.0) - rounding(0.0), 1.5),
        row("mean of a background, for each pixel", rounding(0.0), of_color() + of_interval()),
        of_remainder(),
    ]
}

/// The factor of the remainder that is proved.
const NEEDED_REMAINDER: f64 = 0.59;

/// A gradient that is the share of the dark colour.
pub const GRADIENT: Background = Background { dark: Vec3::ONE, light: Vec3::ZERO };

/// Returns the row of the remainder `k |e|^2 / (|d0| - |e|)^2` of the background's `s(d) = d.y / |d|`.
///
/// By Taylor's theorem the remainder is half of the second derivative of `s` along `e` at a place between `d0` and
/// `d0 + e`, where `d` is not shorter than `|d0| - |e|`. So `k` is at least half of the second derivative times
/// `|d|^2 / |e|^2`.
///
/// # Panics
/// If the proof fails, with the part of the box where it does.
fn of_remainder() -> Row {
    remainder_is_at_most(NEEDED_REMAINDER).expect("the second derivative is not larger");
    let factors = [remainder_factor(), NEEDED_REMAINDER].map(|factor| factor * 1000.0);
    Row::new("remainder of a background", "render/background_derivative.rs", factors, "10^-3 abs(e)^2 / abs(d)^2")
}

/// Returns the factor `k` in the code.
pub fn remainder_factor() -> f64 {
    let (camera, reach) = (CAMERA, PixelReach::new(&Camera { delta_x: Vec3::new(1.0, 0.0, 0.0), ..CAMERA }, &EXACT));
    // A pixel's radius of 1/2 is as long as the shortest direction.
    let [.., remainder] = DerivativeBound::new(&camera, 0.0, 0.0, reach).numbers();
    remainder
}

/// A camera with a pixel of no size at the distance 1.
const CAMERA: Camera =
    Camera { position: Vec3::ZERO, origin: Vec3::new(0.0, 0.0, 1.0), delta_x: Vec3::ZERO, delta_y: Vec3::ZERO };

/// Rays without an error.
const EXACT: RayError = RayError { length: 0.0, turn: 0.0 };

/// Proves that half of the second derivative of the background's `s`, times `|d|^2 / |e|^2`, is at most `limit`.
/// Returns the number of boxes.
///
/// The bound depends on neither the lengths of `d` and `e` nor a turn around y, so `d` is `(1, y, 0)` or `(x, 1, 0)`.
/// `s` is the same for the opposite z, so its second derivative is a mean of those along z and across it, weighted by
/// the squares of these parts of `e`. So `e` is along z, or it is `(1, e_y, 0)` or `(e_x, 1, 0)`. The numbers that are
/// left are at most 1 in magnitude. For the opposite vectors only the sign of the second derivative differs.
///
/// # Errors
/// Numbers for which the largest bound that this method finds exceeds `limit`.
pub fn remainder_is_at_most(limit: f64) -> Result<usize, [Interval; 2]> {
    let [zero, one] = [0.0, 1.0].map(Interval::of);
    let gradient = GRADIENT.lanes();
    let second = |d: [Interval; 3], e: [Interval; 3]| {
        let [x, y, z] = [0, 1, 2].map(|axis| Ruled(Taylor([d[axis], e[axis], zero])));
        // The share of the dark colour is `(s + 1) / 2`.
        let Ruled(Taylor([.., half])) = gradient.color(Vec3::new(x, y, z)).x;
        let [d_squared, e_squared] = [d, e].map(|[x, y, z]| x.squared() + y.squared() + z.squared());
        2.0 * (half * d_squared / e_squared).magnitude()
    };
    let directions: [fn(Interval) -> [Interval; 2]; 2] = [|y| [Interval::of(1.0), y], |x| [x, Interval::of(1.0)]];
    let mut parts = 0;
    for [d, e] in [[0, 0], [0, 1], [1, 0], [1, 1]].map(|pair| pair.map(|at| directions[at])) {
        parts += at_most([Interval { low: -1.0, high: 1.0 }; 2], limit, 40, &|[of_d, of_e]| {
            let ([x, y], [e_x, e_y]) = (d(of_d), e(of_e));
            second([x, y, zero], [e_x, e_y, zero]).max(second([x, y, zero], [zero, zero, one]))
        })?;
    }
    Ok(parts)
}

/// Returns the error of a colour.
fn of_color() -> f64 {
    begin(Arithmetic::F64, f64::NAN);
    let one = Polynomial::constant(1.0);
    let [dark, light] = COLORS.map(|family| Vec3::splat(Bounded::of_size(family, one.clone(), 0.0)));
    let direction = Bounded::vector(DIRECTION, 0.0);
    (direction.y / direction.length()).assume(one.clone());
    let color = Background { dark, light }.color(direction).x;
    relative_to_sizes(&color.bounds().error, 0.0, &[one], 1.0)
}

/// Returns the error of the ends of an interval, for a change of the channel of at most 1.
///
/// The sum of a pixel's sides is less than `2 |d0|`, or else there is no bound. The rounding of the remainder is left
/// out, because the bound of the remainder covers it.
fn of_interval() -> f64 {
    begin(Arithmetic::F64, f64::NAN);
    let one = Polynomial::constant(1.0);
    let camera = [CENTER, ORIGIN, SIDES[0], SIDES[1]].map(|family| Bounded::vector(family, 0.0));
    let [position, origin, delta_x, delta_y] = camera;
    let (camera, zero) = (Camera { position, origin, delta_x, delta_y }, Bounded::constant(0.0, 0.0));
    // The bound holds for computed directions, so the direction of the middle is exact.
    let middle = camera.ray(zero, zero, [zero; 2]).direction;
    for (component, number) in (0..).zip(middle.to_array()) {
        number.assume_relative(Polynomial::of([(DIRECTION, component)]), 0.0);
    }
    let (distance, reciprocal) = (middle.length(), length(RECIPROCAL));
    (Bounded::constant(1.0, 0.0) / distance).assume(reciprocal.clone());
    (middle.y / distance).assume(one.clone());
    (middle.y / distance / distance).assume(reciprocal.clone());
    for component in (middle * (middle.y / distance / distance)).to_array() {
        component.assume(one.clone());
    }
    let real = Camera { position: Vec3::ZERO, origin: Vec3::ZERO, delta_x: Vec3::ZERO, delta_y: Vec3::ZERO };
    let reach = PixelReach::new(&real, &RayError { length: 3.0, turn: 5.0 }).lanes();
    let bound = DerivativeBound::new(&camera, zero, zero, reach);
    bound.numbers()[3].assume_relative(length(REMAINDER), 0.0);
    let sides = reciprocal.times(&sum(&SIDES.map(components)));
    // A number just below 1, whose products are rounded.
    let ends = interval(0.0, 1.0 - f64::EPSILON, bound.anywhere(), 0.0).map(|end| {
        let factors = factors(&end.bounds().error, 0.0, &[one.clone(), sides.clone(), length(REMAINDER)], 1.0);
        // The sum of a vector's components is at most sqrt(3) times its length.
        factors[0] + 2.0 * 3.0_f64.sqrt() * factors[1]
    });
    ends[0].max(ends[1])
}
