//! The margin of camera rays: how far the computed direction may be from the exact one.

use std::slice;

use cpu::internals::geometry::camera::Camera;
use cpu::internals::render::ray_error::{LEAST_DISTANCE, ROUNDINGS, distance_of_window};

use super::bounded::{Bounded, begin};
use super::bounds::Arithmetic;
use super::polynomial::{LENGTH, Polynomial};
use super::row::{Row, family::*, is, length, relative_to_sizes};

/// The families of the vectors from a pixel to its neighbours, and of the width and height in pixels.
const DELTA_X: u8 = DERIVED;
const DELTA_Y: u8 = DERIVED + 1;
const WIDTH: u8 = DERIVED + 2;
const HEIGHT: u8 = DERIVED + 3;
/// The family of the normal of the window.
const NORMAL: u8 = DERIVED + 8;

/// Returns the rows.
#[must_use]
pub fn rows() -> [Row; 2] {
    let direction = direction();
    // With the need `n` of a direction, the constant `r` and the least distance `f r u (|P| + s)`, the turn is large
    // enough if `n / (D - n) <= r / (D + k - r)` for the error `k` of `D`. As `D >= f r - k`, it is so for `k <= f (r -
    // n)`.
    let constant = LEAST_DISTANCE * (ROUNDINGS - direction.need);
    let distance = Row::new("distance of a window", direction.file, [constant, of_distance()], "u s");
    [direction, distance]
}

/// Returns the error of the distance of the window, relative to the vector to its first pixel.
///
/// A pixel's sides are perpendicular, so their cross product is as long as the product of their lengths. Normalising
/// leaves the part of its error that is across it.
fn of_distance() -> f64 {
    begin(Arithmetic::F64, f64::NAN);
    let vectors = [CENTER, ORIGIN, DELTA_X, DELTA_Y].map(|family| Bounded::vector(family, 0.0));
    let [position, origin, delta_x, delta_y] = vectors;
    is(origin - position, TO_CENTER);
    let (camera, cross) = (Camera { position, origin, delta_x, delta_y }, delta_x.cross(delta_y));
    let area = length(DELTA_X).times(&length(DELTA_Y));
    let of_component = |number: Bounded| relative_to_sizes(&number.bounds().error, 0.0, slice::from_ref(&area), 1.0);
    let of_cross = cross.to_array().map(of_component).into_iter().fold(0.0, f64::max) * 3.0_f64.sqrt();
    for (component, number) in (0..).zip(cross.to_array()) {
        number.assume_relative(Polynomial::of([(NORMAL, component)]), 0.0);
    }
    is(cross.unit(), AXIS);
    let error = distance_of_window(&camera).bounds().error;
    of_cross + relative_to_sizes(&error, 0.0, &[length(TO_CENTER)], 1.0)
}

/// Returns the row of the error of a camera ray's direction, relative to `|P| + s`. As in `render/ray_error.rs`, `s` is
/// `|O - P| + W |dx| + H |dy|`.
///
/// Each component has the same bound, so the length of the error is at most the same multiple of the lengths. The
/// length of `O` is at most `|P| + |O - P|`, so what multiplies it counts for `|P|` and for `s`.
fn direction() -> Row {
    begin(Arithmetic::F64, f64::NAN);
    let [position, origin, delta_x, delta_y] =
        [CENTER, ORIGIN, DELTA_X, DELTA_Y].map(|family| Bounded::vector(family, 0.0));
    let camera = Camera { position, origin, delta_x, delta_y };
    // The places within the picture, of which neither whole pixels nor offsets are rounded.
    let [row, column, x, y] = [4, 5, 6, 7].map(|number| Bounded::number(DERIVED + number, 0.0));
    for (place, size) in [(column + x, WIDTH), (row + y, HEIGHT)] {
        place.assume(Polynomial::of([(size, LENGTH)]));
    }
    let error = camera.ray(row, column, [x, y]).direction.x.raw().error;
    let part = |monomial: &[(u8, u8)]| error.coefficient(&Polynomial::of(monomial));
    let [of_position, of_origin] = [CENTER, ORIGIN].map(|family| part(&[(family, 0)]));
    let sizes =
        [(CENTER, None), (ORIGIN, None), (DELTA_X, Some(WIDTH)), (DELTA_Y, Some(HEIGHT))].map(|(family, count)| {
            let count = count.map(|count| (count, LENGTH));
            Polynomial::of([Some((family, 0)), count].into_iter().flatten().collect::<Vec<_>>())
        });
    // Nothing but these parts is in the error, up to underflow of the products.
    let all = sizes.iter().fold(Polynomial::default(), |sum, size| sum.plus(size));
    let largest = relative_to_sizes(&error, 0.0, &[all], f64::MIN_POSITIVE * 1e10);
    let need = largest.max(of_position + of_origin);
    Row::new("direction of a camera ray", "render/ray_error.rs", [ROUNDINGS, need], "u (P + s)")
}
