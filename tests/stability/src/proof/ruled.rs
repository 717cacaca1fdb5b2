//! Numbers that carry bounds in place of a value, in formulas that decide nothing.

use std::ops::{Add, Div, Mul, Neg, Sub};

use cpu::internals::math::real::Real;

use super::operations::Unknown;

/// What an operation does with the bounds of its operands. An operation without a rule occurs in none of the formulas.
pub trait Rules: Copy {
    /// Returns the bounds of a constant.
    fn of(value: f64) -> Self;
    /// Returns the bounds of a sum.
    fn plus(self, other: Self) -> Self;
    /// Returns the bounds of a product.
    fn times(self, other: Self) -> Self;
    /// Returns the bounds of the number with the other sign.
    fn negative(self) -> Self {
        unreachable!("no formula takes the negative of such a number")
    }
    /// Returns the bounds of a difference.
    fn minus(self, other: Self) -> Self {
        self.plus(other.negative())
    }
    /// Returns the bounds of a quotient.
    fn over(self, _: Self) -> Self {
        unreachable!("no formula divides such numbers")
    }
    /// Returns the bounds of the square root.
    fn root(self) -> Self {
        unreachable!("no formula takes the root of such a number")
    }
}

/// A number with these rules.
#[derive(Clone, Copy, Debug)]
pub struct Ruled<R>(pub R);

impl<R: Rules> Add for Ruled<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.plus(other.0))
    }
}

impl<R: Rules> Sub for Ruled<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.minus(other.0))
    }
}

impl<R: Rules> Mul for Ruled<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0.times(other.0))
    }
}

impl<R: Rules> Div for Ruled<R> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0.over(other.0))
    }
}

impl<R: Rules> Neg for Ruled<R> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.negative())
    }
}

impl<R: Rules> Real for Ruled<R> {
    type Mask = Unknown;

    fn of(value: f64) -> Self {
        Self(R::of(value))
    }
    fn sqrt(self) -> Self {
        Self(self.0.root())
    }
    fn abs(self) -> Self {
        unreachable!("no formula takes the magnitude of such a number")
    }
    fn less(self, _: Self) -> Unknown {
        Unknown
    }
    fn less_equal(self, _: Self) -> Unknown {
        Unknown
    }
    fn select(_: Unknown, yes: Self, _: Self) -> Self {
        yes
    }
}
