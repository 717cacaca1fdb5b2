//! The margin of frustum culling, in turns: bounds of the sine of the angle by which rounding turns a camera ray.

use cpu::internals::accel::bounds::{half_width_of_cylinder, half_width_of_disc};
use cpu::internals::accel::extent::Extent;
use cpu::internals::geometry::camera::Camera;
use cpu::internals::math::real::Real;
use cpu::internals::render::frustum::{TURNS, half_space, is_beyond, margin_of_box, margin_of_object, to_window};
use cpu::internals::render::ray_error::ROUNDINGS;

use super::bounded::{Bounded, MARGIN, begin, compared};
use super::bounds::Arithmetic;
use super::parts::axis_and_half_height;
use super::polynomial::Polynomial;
use super::row::{Row, U, added, components, family::*, is, length, relative_to_sizes, sum};

/// The families of the sides of a pixel, of a place in pixels, and of the vectors to it along both sides of the window.
const SIDES: [u8; 2] = [DERIVED + 2, DERIVED + 3];
const PLACE: [u8; 2] = [DERIVED + 4, DERIVED + 5];
const WINDOW: [u8; 2] = [DERIVED + 6, DERIVED + 7];
/// The families of a turn, and of the normal of a plane.
const TURN: u8 = DERIVED + 8;
const NORMAL: u8 = DERIVED + 9;

/// Returns the row.
///
/// Take a point `p` of an object that a computed ray hits, so that a half-space with the exact normal `n` contains `p`
/// up to `t |p|` for the turn `t`. Then the half-space with the computed normal contains it up to `t + e` times `|p|`,
/// with the error `e` of the normal. The object reaches as far along the computed normal as the code computes, up to
/// rounding. `|p|` is at most the length to which the margin is relative. Of a box the farthest corner is tested, as a
/// point.
#[must_use]
pub fn row() -> Row {
    let ([constant, of_sums], of_normal) = (of_comparisons(), of_normal());
    let need = 1.0 + (of_normal + of_sums) / ROUNDINGS;
    Row::new("frustum", "render/frustum.rs", [constant, need], "turns")
}

/// Returns the error of a computed normal, in units of `ROUNDINGS` of a turn.
///
/// The exact cross product of a vector to the window with a pixel's side is at least as long as that side times the
/// distance `D` of the window's plane. Normalising at most doubles the relative error. With `s` of
/// `render/ray_error.rs`, a turn is at least `ROUNDINGS u s / D`, and `s` is at least `D`.
fn of_normal() -> f64 {
    begin(Arithmetic::F64, f64::NAN);
    let vectors = [CENTER, ORIGIN, SIDES[0], SIDES[1]].map(|family| Bounded::vector(family, 0.0));
    let [position, origin, delta_x, delta_y] = vectors;
    is(origin - position, TO_CENTER);
    let [column, row] = PLACE.map(|family| Bounded::number(family, 0.0));
    is(delta_x * column, WINDOW[0]);
    is(delta_y * row, WINDOW[1]);
    // The planes of a span take this sum, those of a row only its first part.
    let at = to_window(&Camera { position, origin, delta_x, delta_y }, row) + delta_x * column;
    let size = sum(&[TO_CENTER, WINDOW[0], WINDOW[1]].map(length));
    let errors = [(delta_x, SIDES[0]), (delta_y, SIDES[1])].map(|(side, family)| {
        let error = sum(&at.cross(side).to_array().map(|component| component.raw().error)).in_lengths();
        relative_to_sizes(&error, 0.0, &[size.times(&length(family))], 1.0)
    });
    // Dividing an exact cross product by its length.
    for (component, number) in (0..).zip(delta_x.cross(delta_y).to_array()) {
        number.assume_relative(Polynomial::of([(NORMAL, component)]), 0.0);
    }
    2.0 * errors[0].max(errors[1]) + half_space(delta_x, delta_y).x.raw().relative
}

/// Returns the margin of the code, and the error of what is compared with it, in units of `u` of the length to which
/// the margin is relative. The margin's own rounding is relative to the margin, and far below the slack.
fn of_comparisons() -> [f64; 2] {
    begin(Arithmetic::F64, TURNS);
    let (center, (axis, half_height)) =
        (Bounded::vector(CENTER, 0.0) - Bounded::vector(ORIGIN, 0.0), axis_and_half_height());
    is(center, TO_CENTER);
    let [distance, radius, turn] = [TO_CENTER, RADIUS, TURN].map(|family| Bounded::number(family, 0.0));
    // The error of the normal is counted apart.
    let normal = Bounded::vector(NORMAL, 0.0);
    // The computed half width of a disc is at least the exact one (row "boxes of the BVH"), which is at most 1.
    half_width_of_disc(normal.dot(axis)).assume_relative(Polynomial::constant(1.0), 0.0);
    let half_width = half_width_of_cylinder(normal.dot(axis), half_height, radius);
    let of_object = margin_of_object(turn, distance, radius, half_height);
    _ = is_beyond(normal, center, radius + half_height, of_object) & is_beyond(normal, center, half_width, of_object);
    let of_object = sum(&[TO_CENTER, RADIUS, HALF_HEIGHT].map(length));
    // The vector to a corner of a box is rounded like that to a centre.
    let of_box = margin_of_box(Bounded::of(TURNS) * turn, center.map(Real::abs));
    _ = is_beyond(normal, center, Bounded::of(0.0), of_box);
    let sizes = [of_object.clone(), of_object, components(TO_CENTER)];
    let of = compared().into_iter().rev().take(3).rev().zip(sizes).map(|([along, least], size)| {
        let errors = along.bounds().error.plus(&least.bounds().error).enlarged(&[(NORMAL, None)]);
        let errors = Polynomial(errors.0.into_iter().filter(|(monomial, _)| !monomial.contains(&MARGIN)).collect());
        let constant = added(least, &size.times(&length(TURN)), TURNS, U) * U;
        // The length of the vector is at most the sum of its components.
        let sizes = [size, length(TO_CENTER)];
        [constant, relative_to_sizes(&errors, 0.0, &sizes, Extent::SMALLEST)]
    });
    of.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).expect("three numbers are compared")
}
