//! The proof of the remainder of a background.

use std::ops::{Add, Div, Mul, Neg, Sub};

use cpu::Vec3;
use cpu::internals::math::real::Real;

use super::super::background::{GRADIENT, remainder_factor};
use super::super::bounded::{Bounded, begin};
use super::super::bounds::Arithmetic;
use super::super::interval::{Scalar, Taylor};
use super::super::row::family::DERIVED;
use super::super::ruled::Ruled;
use super::{Proof, Script, dyadic, within};

/// A number of which sums with 0 and products with 0 and 1 are left out, because Gappa takes time for each operation.
#[derive(Clone, Copy)]
struct Short(Bounded);

impl Short {
    fn is(self, value: f64) -> bool {
        self.0 == Bounded::of(value)
    }
}

impl Add for Short {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is(0.0) {
            other
        } else if other.is(0.0) {
            self
        } else {
            Self(self.0 + other.0)
        }
    }
}

impl Sub for Short {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        if other.is(0.0) { self } else { Self(self.0 - other.0) }
    }
}

impl Mul for Short {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match [self, other] {
            [zero, _] | [_, zero] if zero.is(0.0) => zero,
            [one, number] | [number, one] if one.is(1.0) => number,
            _ => Self(self.0 * other.0),
        }
    }
}

impl Div for Short {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if self.is(0.0) { self } else { Self(self.0 / other.0) }
    }
}

impl Neg for Short {
    type Output = Self;
    fn neg(self) -> Self {
        if self.is(0.0) { self } else { Self(-self.0) }
    }
}

impl Scalar for Short {
    fn constant(value: f64) -> Self {
        Self(Bounded::of(value))
    }
    fn root(self) -> Self {
        Self(self.0.sqrt())
    }
}

/// Returns the proofs of half of the second derivative of `d.y / |d|`, times `|d|^2 / |e|^2`, for the cases of `d` and
/// `e` that `remainder_is_at_most` names. Each number but 1 and 0 lies between -1 and 1.
pub(super) fn remainder() -> Vec<Proof> {
    begin(Arithmetic::F64, f64::NAN);
    let [zero, one] = [0.0, 1.0].map(Short::constant);
    let numbers = [0, 1].map(|number| Short(Bounded::number(DERIVED + number, 0.0)));
    let cases = |number: Short| [[one, number, zero], [number, one, zero]];
    let mut proofs = Vec::new();
    for d in cases(numbers[0]) {
        for e in cases(numbers[1]) {
            // Gappa gives up on more than some ten thousand parts, so the first number is divided before.
            let eighths = (0..8).map(|eighth| [0, 1].map(|more| f64::from(eighth + more) / 4.0 - 1.0));
            proofs.extend(eighths.map(|range| second(d, e, numbers, range)));
        }
        proofs.push(second(d, [zero, zero, one], numbers, [-1.0, 1.0]));
    }
    proofs
}

/// Returns the proof for a direction `d` and a way `e` that depend on two numbers, of which the first is in `range`.
fn second(d: [Short; 3], e: [Short; 3], numbers: [Short; 2], range: [f64; 2]) -> Proof {
    let zero = Short::constant(0.0);
    let direction = [0, 1, 2].map(|axis| Ruled(Taylor([d[axis], e[axis], zero])));
    // The share of the dark colour is `(s + 1) / 2`.
    let Ruled(Taylor([.., half])) = GRADIENT.lanes().color(Vec3::from(direction)).x;
    let squared = |[x, y, z]: [Short; 3]| x * x + y * y + z * z;
    let mut script = Script::new();
    let names = numbers.map(|Short(number)| script.export(number)[1].clone());
    let [_, bound] = script.export((half * (squared(d) / squared(e))).0);
    script.keep_only('e');
    let hypotheses = [within(&names[0], range), within(&names[1], [-1.0, 1.0])];
    let [most, less] = [remainder_factor(), 0.1].map(|most| dyadic(most / 2.0));
    let goal = format!("|{bound}| <= {most}");
    Proof {
        row: "remainder of a background",
        what: "half of the second derivative, which bounds the remainder",
        text: script.proves(&hypotheses, &goal, &format!("$ {} in 32, {} in 256;\n", names[0], names[1])),
        wrong: [most, less],
    }
}
