//! The operations of [`Bounded`]: what each of them makes of the bounds of its operands.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use cpu::internals::math::real::Real;
use cpu::internals::math::rounding::Rounding;

use super::bounded::{Bounded, Operation};
use super::bounds::{Bounds, arithmetic, composed};

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
            let ([size, error], a, b) = (self.product(other), self.raw(), other.raw());
            let is_positive = self == other || a.is_positive && b.is_positive;
            let relative = composed(a.relative, b.relative);
            let is_exact = a.is_exact && b.is_exact;
            let rounded = Bounds::rounded(size, error.clone()).with_relative(relative, is_positive, is_exact);
            if a.is_power_of_two || b.is_power_of_two { Bounds { error, relative, ..rounded } } else { rounded }
        })
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        self.with_sign(false, Operation::Negative(self))
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let (a, b) = (self.raw(), other.raw());
        if b.is_power_of_two {
            return self * Self::constant(1.0 / b.size.sum(), 0.0);
        }
        if !a.relative.is_finite() && b.relative.is_finite() {
            // Rounded once. The bound allows for two roundings.
            return self * (Self::constant(1.0, 0.0) / other);
        }
        // 1 / (1 - x) = 1 + x / (1 - x)
        let x = b.relative * arithmetic().roundoff;
        let relative = composed(a.relative, if x < 0.5 { b.relative / (1.0 - x) } else { f64::INFINITY });
        Self::relative(relative, a.is_positive && b.is_positive, Operation::Quotient(self, other))
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
        // sqrt(1 + x) differs from 1 by at most |x| / 2 + x^2 / 2.
        let relative = self.raw().relative;
        Self::relative(relative / 2.0 * (1.0 + relative * arithmetic().roundoff), true, Operation::Root(self))
    }
    fn abs(self) -> Self {
        self.with_sign(true, Operation::Magnitude(self))
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
        self.with_sign(false, Operation::Flipped(self, other))
    }
}

impl Rounding for Bounded {
    /// Rounded once. The bound holds for two roundings too, because it adds the rounding of the product.
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self::of_operation(Operation::Fused(self, factor, term), || {
            let ([size, error], added) = (self.product(factor), term.raw());
            let product = Bounds::rounded(size, error);
            let is_square = self == factor && self.raw().is_exact && added.is_positive && added.is_exact;
            let sum = Bounds::rounded(product.size.plus(&added.size), product.error.plus(&added.error));
            Bounds { is_positive: is_square, is_exact: is_square, ..sum }
        })
    }
}
