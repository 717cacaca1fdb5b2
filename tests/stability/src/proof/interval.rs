//! Intervals with directed rounding, and branch and bound over them.
//!
//! An operation of `f64` is rounded to the nearest number, so its exact result lies between the two neighbours of the
//! computed one.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::ruled::Rules;

/// The numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The smallest number.
    pub low: f64,
    /// The largest number.
    pub high: f64,
}

impl Interval {
    /// Returns the interval that holds only `value`.
    #[must_use]
    pub const fn of(value: f64) -> Self {
        Self { low: value, high: value }
    }

    /// Returns the smallest interval around the exact numbers that were rounded to these.
    fn around(rounded: &[f64]) -> Self {
        let low = rounded.iter().copied().fold(f64::INFINITY, f64::min);
        let high = rounded.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// Returns the largest magnitude of the numbers.
    #[must_use]
    pub const fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Returns the squares, which are never negative.
    #[must_use]
    pub fn squared(self) -> Self {
        let smallest = self.low.max(-self.high).max(0.0);
        Self { low: (smallest * smallest).next_down().max(0.0), high: (self.magnitude() * self.magnitude()).next_up() }
    }

    /// Returns the square root, for numbers that are positive.
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self::around(&[self.low.sqrt(), self.high.sqrt()])
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::around(&[self.low + other.low, self.high + other.high])
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let Self { low, high } = other;
        Self::around(&[self.low * low, self.low * high, self.high * low, self.high * high])
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let Self { low, high } = other;
        assert!(low > 0.0 || high < 0.0, "a divisor may be 0");
        Self::around(&[self.low / low, self.low / high, self.high / low, self.high / high])
    }
}

/// A number with the operations that a [`Taylor`] needs.
pub trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Returns a constant.
    fn constant(value: f64) -> Self;
    /// Returns the square root.
    fn root(self) -> Self;
}

impl Scalar for Interval {
    fn constant(value: f64) -> Self {
        Self::of(value)
    }
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// A function of `t` near 0, as its value, its first derivative, and half of its second one. Each is an interval, or
/// another number.
#[derive(Clone, Copy, Debug)]
pub struct Taylor<N = Interval>(pub [N; 3]);

impl<N: Scalar> Rules for Taylor<N> {
    fn of(value: f64) -> Self {
        Self([value, 0.0, 0.0].map(N::constant))
    }
    fn plus(self, other: Self) -> Self {
        Self([0, 1, 2].map(|order| self.0[order] + other.0[order]))
    }
    fn negative(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
    fn times(self, other: Self) -> Self {
        let (Self([a, a1, a2]), Self([b, b1, b2])) = (self, other);
        Self([a * b, a * b1 + a1 * b, a * b2 + a1 * b1 + a2 * b])
    }
    fn over(self, other: Self) -> Self {
        let (Self([a, a1, a2]), Self([b, b1, b2])) = (self, other);
        let value = a / b;
        let first = (a1 - value * b1) / b;
        Self([value, first, (a2 - value * b2 - first * b1) / b])
    }
    fn root(self) -> Self {
        let Self([a, a1, a2]) = self;
        let value = a.root();
        let first = a1 / (value + value);
        Self([value, first, (a2 - first * first) / (value + value)])
    }
}

/// Proves that `bound` of every part of a box is at most `limit`: divides the box until it is, at most `depth` times
/// on each path. Returns the number of parts.
///
/// # Errors
/// A part for which `bound` still exceeds `limit`.
pub fn at_most<const N: usize>(
    part: [Interval; N],
    limit: f64,
    depth: u32,
    bound: &impl Fn([Interval; N]) -> f64,
) -> Result<usize, [Interval; N]> {
    if bound(part) <= limit {
        return Ok(1);
    }
    if depth == 0 {
        return Err(part);
    }
    let width = |&axis: &usize| part[axis].high - part[axis].low;
    let widest = (0..N).max_by(|a, b| width(a).total_cmp(&width(b))).expect("a box has an axis");
    let middle = f64::midpoint(part[widest].low, part[widest].high);
    let [mut below, mut above] = [part; 2];
    (below[widest].high, above[widest].low) = (middle, middle);
    Ok(at_most(below, limit, depth - 1, bound)? + at_most(above, limit, depth - 1, bound)?)
}
