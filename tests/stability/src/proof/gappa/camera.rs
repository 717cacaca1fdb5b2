//! The proof of the error of a camera ray's direction.

use cpu::internals::geometry::camera::Camera;
use cpu::internals::render::ray_error::ROUNDINGS;

use super::super::bounded::{Bounded, begin};
use super::super::bounds::Arithmetic;
use super::super::row::{U, family::*};
use super::{DOUBLE, Proof, Script, dyadic, one_bit_less, within};

/// Returns the proof of the error of a component, relative to `|P| + s`, which is 1 here. Neither a component of `P` or
/// `O`, nor a product of a side and a place, nor a sum of these exceeds it, because `|O| <= |P| + |O - P|`.
pub(super) fn direction() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let [position, origin, delta_x, delta_y] =
        [CENTER, ORIGIN, DERIVED, DERIVED + 1].map(|family| Bounded::vector(family, 0.0));
    let camera = Camera { position, origin, delta_x, delta_y };
    let [row, column, x, y] = [4, 5, 6, 7].map(|number| Bounded::number(DERIVED + number, 0.0));
    let direction = camera.ray(row, column, [x, y]).direction.x;
    let [right, down] = [delta_x.x * (column + x), delta_y.x * (row + y)];
    let target = origin.x + right;
    let at_most_one = [position.x, origin.x, right, down, target, target + down, direction];
    let mut script = Script::relative(DOUBLE);
    // The places within the picture, of which neither whole pixels nor offsets are rounded.
    for (number, name) in [(column + x, "right"), (row + y, "down")] {
        script.define(number, [name; 2]);
    }
    let [computed, exact] = script.export(direction);
    let mut hypotheses: Vec<_> =
        at_most_one.into_iter().map(|number| within(&script.export(number)[1], [-1.0, 1.0])).collect();
    hypotheses.push("|right| <= 1b64 /\\ |down| <= 1b64".to_owned());
    Proof {
        row: "direction of a camera ray",
        what: "the error of a component relative to |P| + s",
        text: script.proves(&hypotheses, &format!("|{computed} - {exact}| <= {}", dyadic(ROUNDINGS * U)), ""),
        wrong: one_bit_less(DOUBLE),
    }
}
