//! The margin of camera rays: how far the computed direction may be from the exact one.

use cpu::internals::geometry::camera::Camera;
use cpu::internals::render::ray_error::ROUNDINGS;

use super::bounded::{Bounded, begin};
use super::bounds::Arithmetic;
use super::polynomial::{LENGTH, Polynomial};
use super::row::{Row, family::*, relative_to_sizes};

/// The families of the vectors from a pixel to its neighbours, and of the width and height in pixels.
const DELTA_X: u8 = DERIVED;
const DELTA_Y: u8 = DERIVED + 1;
const WIDTH: u8 = DERIVED + 2;
const HEIGHT: u8 = DERIVED + 3;

/// Returns the row of the error of a camera ray's direction, relative to `|P| + s`. As in `render/ray_error.rs`, `s` is
/// `|O - P| + W |dx| + H |dy|`.
///
/// Each component has the same bound, so the length of the error is at most the same multiple of the lengths. The
/// length of `O` is at most `|P| + |O - P|`, so what multiplies it counts for `|P|` and for `s`.
#[must_use]
pub fn row() -> Row {
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
    Row { what: "direction of a camera ray", file: "render/ray_error.rs", constant: ROUNDINGS, need, unit: "u (P + s)" }
}
