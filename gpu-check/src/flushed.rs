//! f32 whose subnormal numbers are zeros, as WGSL allows a driver to have it.
//!
//! Operands and results of arithmetic are flushed, and operands of comparisons; loads, stores, signs and choices leave
//! a number as it is. So does a processor of the x86 family with its two flags set, on which SwiftShader runs: a result
//! is flushed when it would be subnormal if exponents had no end, which is decided before it is rounded to one.

use std::ops::{Add, Div, Mul, Neg, Sub};

use cpu::internals::math::real::Real;

/// A number in such arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flushed(pub f32);

/// An operand as arithmetic sees it: zero with its sign where it is subnormal.
fn operand(number: Flushed) -> f64 {
    let Flushed(value) = number;
    f64::from(if value.is_subnormal() { 0.0_f32.copysign(value) } else { value })
}

/// A result that is exact in f64, or so near that f32 rounds it alike; zero with its sign where it is tiny.
fn rounded(value: f64) -> Flushed {
    // Halfway between the smallest normal number and what lies below it, if exponents had no end.
    const TINY: f64 = f32::MIN_POSITIVE as f64 * (1.0 - f32::EPSILON as f64 / 4.0);
    Flushed(if value.abs() < TINY { 0.0_f32.copysign(value as f32) } else { value as f32 })
}

// Sum, product, quotient and root of f32 may be rounded by way of f64: it has more than twice the digits and two.

impl Add for Flushed {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        rounded(operand(self) + operand(other))
    }
}

impl Sub for Flushed {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        rounded(operand(self) - operand(other))
    }
}

impl Mul for Flushed {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        rounded(operand(self) * operand(other))
    }
}

impl Div for Flushed {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        rounded(operand(self) / operand(other))
    }
}

impl Neg for Flushed {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Flushed {
    type Mask = bool;

    fn of(value: f64) -> Self {
        Self(value as f32)
    }
    fn sqrt(self) -> Self {
        rounded(operand(self).sqrt())
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn less(self, other: Self) -> bool {
        operand(self) < operand(other)
    }
    fn less_equal(self, other: Self) -> bool {
        operand(self) <= operand(other)
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_are_as_in_f32() {
        let numbers = [1.0_f32, -3.0, 0.1, 1e-18, 7e30, f32::MAX, f32::MIN_POSITIVE, -0.0, f32::INFINITY];
        let mut compared = 0;
        for (a, b) in numbers.iter().flat_map(|a| numbers.map(|b| (*a, b))) {
            let (x, y) = (Flushed(a), Flushed(b));
            for (flushed, plain) in [(x + y, a + b), (x - y, a - b), (x * y, a * b), (x / y, a / b)] {
                if !plain.is_subnormal() && plain.abs() != f32::MIN_POSITIVE {
                    assert!(flushed.0.to_bits() == plain.to_bits() || plain.is_nan(), "{a} {b}: {flushed:?} {plain}");
                    compared += 1;
                }
            }
            assert_eq!((x.less(y), x.less_equal(y)), (a < b, a <= b));
        }
        assert!(compared > 200, "{compared}");
    }

    #[test]
    fn subnormal_numbers_are_zeros_with_their_sign() {
        let small = Flushed(f32::MIN_POSITIVE);
        let subnormal = Flushed(-1e-40);
        assert_eq!((small * Flushed(-0.5)).0.to_bits(), (-0.0_f32).to_bits());
        assert_eq!((subnormal * Flushed(1e30)).0.to_bits(), (-0.0_f32).to_bits());
        assert_eq!((Flushed(1.0) / subnormal).0, f32::NEG_INFINITY);
        assert!(!subnormal.less(Flushed(0.0)) && Flushed(0.0).less_equal(subnormal));
        // Not touched by arithmetic, it stays.
        assert_eq!((-subnormal).0, 1e-40);
        // Tiny before it is rounded up to a normal number.
        assert_eq!((small * Flushed(1.0_f32.next_down())).0, 0.0);
    }
}
