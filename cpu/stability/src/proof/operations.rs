//! The operations of [`Bounded`]: what each of them makes of the bounds of its operands.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use cpu::internals::math::real::Real;
use cpu::internals::math::rounding::{MulAdd, Rounding};

use super::bounded::{Bounded, Bounds, Operation};

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.sum(other, Operation::Sum(self, other))
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.sum(other, Operation::Difference(self, other))
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::of_operation(Operation::Product(self, other), || {
            let [size, error] = self.product(other);
            Bounds::rounded(size, error)
        })
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        self.with_sign(Operation::Negative(self))
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::unknown(Operation::Quotient(self, other))
    }
}

/// The result of a comparison, which is not known.
#[derive(Clone, Copy, Debug)]
pub struct Unknown;

impl BitAnd for Unknown {
    type Output = Self;
    fn bitand(self, _: Self) -> Self {
        self
    }
}

impl BitOr for Unknown {
    type Output = Self;
    fn bitor(self, _: Self) -> Self {
        self
    }
}

impl Not for Unknown {
    type Output = Self;
    fn not(self) -> Self {
        self
    }
}

impl Real for Bounded {
    type Mask = Unknown;

    fn of(value: f64) -> Self {
        Self::constant(value, 0.0)
    }
    fn sqrt(self) -> Self {
        Self::unknown(Operation::Root(self))
    }
    fn abs(self) -> Self {
        self.with_sign(Operation::Magnitude(self))
    }
    fn less(self, other: Self) -> Unknown {
        self.compare(other);
        Unknown
    }
    fn less_equal(self, other: Self) -> Unknown {
        self.compare(other);
        Unknown
    }
    fn select(_: Unknown, yes: Self, no: Self) -> Self {
        yes.sum(no, Operation::Sum(yes, no))
    }
    fn flipped_by(self, other: Self) -> Self {
        self.with_sign(Operation::Flipped(self, other))
    }
}

impl Rounding for Bounded {}

impl MulAdd for Bounded {
    /// Rounded once. The bound holds for two roundings too, because it adds the rounding of the product.
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self::of_operation(Operation::Fused(self, factor, term), || {
            let ([size, error], added) = (self.product(factor), term.raw());
            let product = Bounds::rounded(size, error);
            Bounds::rounded(product.size.plus(&added.size), product.error.plus(&added.error))
        })
    }
}
