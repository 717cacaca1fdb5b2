//! Arithmetic in f32 that replaces subnormal numbers by zeros, as WGSL allows a driver to do.
//!
//! Operands and results of arithmetic are flushed to zero, and so are operands of comparisons. Loads, stores, changes
//! of sign and selections do not change a number. An x86 processor with the flags DAZ and FTZ set calculates in this
//! way, and SwiftShader runs on such a processor. A result is flushed if, rounded to 24 bits with an unlimited exponent
//! range, its magnitude is below the smallest normal number.

use std::ops::{Add, Div, Mul, Neg, Sub};

use cpu::internals::math::real::Real;

/// A number whose arithmetic flushes subnormal numbers to zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flushed(pub f32);

/// Returns the value that arithmetic uses for an operand: a zero of its sign if it is subnormal, and otherwise the
/// number.
fn operand(number: Flushed) -> f64 {
    let Flushed(value) = number;
    f64::from(if value.is_subnormal() { 0.0_f32.copysign(value) } else { value })
}

/// Rounds a result to f32, or to a zero of its sign if it is below the normal numbers. `value` must be exact, or so
/// close to the exact result that f32 rounds both to one number.
fn rounded(value: f64) -> Flushed {
    // Halfway between the smallest normal number and the next smaller number of 24 bits in an unlimited exponent range.
    const TINY: f64 = f32::MIN_POSITIVE as f64 * (1.0 - f32::EPSILON as f64 / 4.0);
    Flushed(if value.abs() < TINY { 0.0_f32.copysign(value as f32) } else { value as f32 })
}

// Sums, products, quotients and roots of f32 can be computed in f64 and rounded again. The second rounding causes no
// error, because f64 has 53 bits, at least twice the 24 bits of f32 plus two.

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
        // A change of sign does not flush, so the number stays subnormal.
        assert_eq!((-subnormal).0, 1e-40);
        // The exact product is below the smallest normal number, and f32 would round it up to that number.
        assert_eq!((small * Flushed(1.0_f32.next_down())).0, 0.0);
    }
}
