//! The proofs that underflow adds almost nothing to the errors of the compensated formulas of a side.
//!
//! `P` is the length of `p = d x V`, `V` that of the axis, and `Z^2` is `V^2 (|O - C|^2 + r^2)`. In scale, `P`, `V` and
//! `Z` are at least 2^-151, and `V` is at most 2^151. In units of these three, no input but the direction is above 1.
//! Neither is a component of `q = (O - C) x V`, nor `c`, by the inequality of Cauchy and Schwarz.

use cpu::internals::exact::compensated_roots::ERROR_OF_C;
use cpu::internals::exact::cylinder_compensated::{SHARE_IN_C, SHARE_IN_D, SHARE_IN_H};
use cpu::internals::exact::error_bound::{LARGEST_IN_SCALE, SMALLEST_IN_SCALE};
use cpu::internals::exact::sphere_filter::SPHERE_BOUND;
use cpu::internals::math::error_free::accurate_cross;

use super::super::bounded::{Bounded, Operation};
use super::super::row::{U, ray};
use super::Proof;
use super::compensated::{Side, side};
use super::underflow::{HALF_OF_LEAST, UnderflowScript, Unit};

const UNIT_OF_AXIS: Unit = [0, 1, 0];
const UNIT_OF_LENGTH: Unit = [0, -1, 1];
const UNIT_OF_CROSS: Unit = [0, 0, 1];
const UNIT_OF_C: Unit = [0, 0, 2];
const UNIT_OF_P: Unit = [1, 0, 0];

/// A number that is at most 1 in its unit, after a few roundings.
const ONE: f64 = 1.0 + 1e-9;
const _: () = assert!(SHARE_IN_C >= 1.0, "the terms of `c` are at least 1");
/// The share of an error bound that is negligible.
const NEGLIGIBLE: f64 = 1e-6;

/// The most that underflow adds, in units of `P`, `V` and `Z`, as binary logarithms. A script proves each.
mod added {
    /// What underflow adds to a component of `p`.
    pub const TO_P: i32 = -921;
    /// What it adds to each of the two parts of a component of `q`.
    pub const TO_CROSS: i32 = -920;
    /// What it adds to each of the two parts of `r^2 |V|^2`.
    pub const TO_RADIUS_TERM: i32 = -468;
    /// What it adds to `c` and to the sum of its squares.
    pub const TO_C: i32 = -464;
    /// What it adds to the numbers of which roots are taken.
    pub const TO_NEAR_RADICAND: i32 = -460;
    pub const TO_FAR_RADICAND: i32 = -168;
}
use added::*;

fn two_to(power: i32) -> f64 {
    2.0_f64.powi(power)
}

/// Returns the proofs, those that others build on first.
pub(super) fn proofs() -> Vec<Proof> {
    vec![direction(), component(), radius_term(), c(), near(), far()]
}

fn begin() -> UnderflowScript {
    // The code compares rounded squares with these limits. The factor 2 covers their rounding.
    let [inverse, longest] = [1.0 / SMALLEST_IN_SCALE, LARGEST_IN_SCALE].map(|limit| 2.0 * limit.sqrt());
    UnderflowScript::new([("iP", inverse), ("iV", inverse), ("iZ", inverse), ("V", longest)])
}

fn proof(what: &'static str, script: &UnderflowScript) -> Proof {
    let wrong = [HALF_OF_LEAST, "1b-150"].map(ToOwned::to_owned);
    Proof { row: "underflow of a side, compensated", what, text: script.text(), wrong }
}

/// Returns the proof for a component of `p = d x V`.
fn direction() -> Proof {
    let Side { axis, .. } = side();
    let mut script = begin();
    script.given(axis.to_array(), UNIT_OF_AXIS, ONE, 0.0);
    // A direction along the axis is much longer than `p`. Underflow of its products does not depend on their size.
    script.given(ray().direction.to_array(), [1, -1, 0], f64::INFINITY, 0.0);
    script.adds_at_most(accurate_cross(ray().direction, axis).x, two_to(TO_P));
    proof("a component of d x V", &script)
}

/// Returns the proof for a component of `q = (O - C) x V`.
fn component() -> Proof {
    let Side { axis, from_center, cross, .. } = side();
    let mut script = begin();
    script.given(axis.to_array(), UNIT_OF_AXIS, ONE, 0.0);
    for (vector, most) in from_center.into_iter().zip([ONE, ONE * U]) {
        script.given(vector.to_array(), UNIT_OF_LENGTH, most, 0.0);
    }
    for part in cross {
        script.adds_at_most(part.x, two_to(TO_CROSS));
    }
    proof("a component of (O - C) x V", &script)
}

/// Returns the proof for `r^2 |V|^2`.
fn radius_term() -> Proof {
    let Side { axis, radius, radius_term, .. } = side();
    let mut script = begin();
    script.given(axis.to_array(), UNIT_OF_AXIS, ONE, 0.0);
    script.given([radius], UNIT_OF_LENGTH, ONE, 0.0);
    for part in radius_term {
        script.adds_at_most(part, two_to(TO_RADIUS_TERM));
    }
    proof("the term of the radius", &script)
}

/// Returns the proof for `c`, and for the sum of its squares.
fn c() -> Proof {
    let Side { cross, radius_term, squares, terms, .. } = side();
    let mut script = begin();
    for ((vector, term), most) in cross.into_iter().zip(radius_term).zip([ONE, 8.0 * U]) {
        script.given(vector.to_array(), UNIT_OF_CROSS, most, two_to(TO_CROSS));
        script.given([term], UNIT_OF_C, most, two_to(TO_RADIUS_TERM));
    }
    let most = two_to(TO_C);
    assert!(most < NEGLIGIBLE * ERROR_OF_C * U * U, "the terms of `c` are at least 1");
    for number in [terms.quadratic.c, squares] {
        script.adds_at_most(number, most);
    }
    proof("c", &script)
}

/// Begins a script with the vectors of a discriminant.
fn discriminant(Side { axis, from_center, direction_cross, .. }: &Side) -> UnderflowScript {
    let mut script = begin();
    script.given(axis.to_array(), UNIT_OF_AXIS, ONE, 0.0);
    script.given(direction_cross.to_array(), UNIT_OF_P, ONE, two_to(TO_P));
    for (vector, most) in from_center.iter().zip([ONE, ONE * U]) {
        script.given(vector.to_array(), UNIT_OF_LENGTH, most, 0.0);
    }
    script
}

/// Returns the most that underflow may add to the value of a discriminant and to the size of its terms. These are at
/// least this share of `P^2 Z^2`.
fn negligible(share: f64) -> [f64; 2] {
    [SPHERE_BOUND.error_constant * U, 1.0].map(|factor| NEGLIGIBLE * share * factor)
}

/// Returns the proof for `h` and for `h^2 - a c`.
fn near() -> Proof {
    let side = side();
    let mut script = discriminant(&side);
    let quadratic = &side.terms.quadratic;
    for (vector, most) in side.cross.into_iter().zip([ONE, 8.0 * U]) {
        script.given(vector.to_array(), UNIT_OF_CROSS, most, two_to(TO_CROSS));
    }
    script.given([quadratic.c, side.squares], UNIT_OF_C, ONE, two_to(TO_C));
    script.root_of(quadratic.size_of_h, two_to(TO_NEAR_RADICAND));
    // The terms of `h` are at least this share of `P Z`.
    script.adds_at_most(quadratic.h, NEGLIGIBLE * U * SHARE_IN_H.sqrt());
    let near = quadratic.near();
    for (number, most) in [near.value, near.size].into_iter().zip(negligible(ERROR_OF_C * U)) {
        script.adds_at_most(number, most);
    }
    proof("the discriminant, near", &script)
}

/// Returns the proof for `V.V (a r^2 - ((O - C).p)^2)`.
fn far() -> Proof {
    let side = side();
    let mut script = discriminant(&side);
    script.given([side.radius], UNIT_OF_LENGTH, ONE, 0.0);
    let far = &side.terms.far;
    script.root_of(root_of_far(far.size), two_to(TO_FAR_RADICAND));
    for (number, most) in [far.value, far.size].into_iter().zip(negligible(SHARE_IN_D)) {
        script.adds_at_most(number, most);
    }
    proof("the discriminant, far", &script)
}

/// Returns the root in the size of a discriminant's terms.
fn root_of_far(size: Bounded) -> Bounded {
    let Operation::Product(_, sum) = size.operation() else { panic!("it is no product") };
    let Operation::Sum(_, rest) = sum.operation() else { panic!("it is no sum") };
    let Operation::Sum(first, _) = rest.operation() else { panic!("it is no sum of three") };
    let Operation::Product(_, root) = first.operation() else { panic!("it is no product with a root") };
    root
}
