//! Bounds the rounding errors at the boundary between two bytes, for every gamma. `image/quantize.rs` leaves a room on
//! both sides of the boundary, in which it calls the power; the row compares this room with the errors.
//!
//! A number here is known by its logarithm. Each rounding changes the logarithm by at most `u`. The row has room for
//! terms in `u^2`. All logarithms and errors are sums of multiples of 1, of gamma and of its reciprocal. So
//! what the room must be, relative to `1 + gamma`, is largest for the smallest or for the largest gamma.

use cpu::internals::image::quantize::{Power, ROOM_FOR_ROUNDING, around, channel_level};

use super::row::{Row, U};
use super::ruled::{Ruled, Rules};

/// A positive number.
#[derive(Clone, Copy, Debug)]
struct Number {
    /// The logarithm. In a product its magnitude is that of the sum.
    log: f64,
    /// Bounds the error of the logarithm, in units of `u`.
    error: f64,
    /// By how much the room moves the logarithm at least, in units of `u`.
    moved: f64,
    /// Whether this is the room, which is below 1/2.
    is_room: bool,
}

impl Number {
    const fn new(log: f64, error: f64) -> Self {
        Self { log, error, moved: 0.0, is_room: false }
    }
}

impl Rules for Number {
    fn of(value: f64) -> Self {
        Self::new(value.ln(), 0.0)
    }
    fn times(self, other: Self) -> Self {
        let is_room = self.log == ROOM_FOR_ROUNDING.ln();
        let (log, error) = (self.log + other.log, self.error + other.error + 1.0);
        Self { log, error, moved: self.moved + other.moved, is_room }
    }
    fn over(self, other: Self) -> Self {
        Self::new(self.log - other.log, self.error + other.error + 1.0)
    }
    /// `ln(1 + room)` is at least `room ln(1.5) / 0.5`.
    fn plus(self, other: Self) -> Self {
        if other.is_room {
            let log = 1.5_f64.ln();
            return Self { moved: other.log.exp() * log / 0.5 / U, ..Self::new(log, other.error + 1.0) };
        }
        let most = self.log.max(other.log);
        let log = most + ((self.log - most).exp() + (other.log - most).exp()).ln();
        Self::new(log, self.error.max(other.error) + 1.0)
    }
    /// The code subtracts the room from 1, which at most doubles the relative error.
    fn minus(self, other: Self) -> Self {
        assert!(other.is_room, "only the room is subtracted");
        Self { moved: -other.log.exp() / U, ..Self::new(0.5_f64.ln(), other.error + 1.0) }
    }
}

impl Power for Ruled<Number> {
    fn power(self, Self(exponent): Self) -> Self {
        let (Self(base), factor) = (self, exponent.log.exp());
        let error = factor * (base.error + base.log.abs() * exponent.error) + 1.0;
        Self(Number { log: factor * base.log, error, moved: factor * base.moved, is_room: false })
    }
}

/// Returns the row. The smallest root is 1/255, which is rounded, and its logarithm is largest.
pub fn row() -> Row {
    let (mut constant, mut need) = (f64::INFINITY, 0.0_f64);
    for gamma in [1e-300_f64, 1e300] {
        let [root, number] = [Number::new(-255.0_f64.ln(), 1.0), Number::new(gamma.ln(), 0.0)].map(Ruled);
        let relative = |of: f64| of * gamma / (1.0 + gamma);
        let [below, from] = around(root, number).1.map(|bound| channel_level(bound, number).0);
        constant = constant.min(relative(-below.moved)).min(relative(from.moved));
        need = need.max(relative(below.error)).max(relative(from.error));
    }
    Row::new("bytes of means", "image/quantize.rs", [constant, need], "u (1 + gamma)")
}
