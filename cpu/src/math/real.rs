//! The arithmetic that formulas are generic over: one number, or several at once.
//!
//! Every operation is one correctly rounded IEEE operation, so a formula gives the same bits in a lane as for a single
//! number.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A real number, or a vector of them, one a lane.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The result of a comparison: one `bool`, or one a lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// The number nearest to `value`, in every lane.
    fn of(value: f64) -> Self;
    /// Square root; not a number below zero.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// Whether `self < other`; false when either is not a number.
    fn less(self, other: Self) -> Self::Mask;
    /// Whether `self <= other`; false when either is not a number.
    fn less_equal(self, other: Self) -> Self::Mask;
    /// `yes` where `mask` holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The number, negated where `other` is negative; either where `other` is a zero.
    #[inline(always)]
    fn flipped_by(self, other: Self) -> Self {
        Self::select(other.less(Self::of(0.0)), -self, self)
    }
}

macro_rules! scalar {
    ($type:ty, $sign:expr) => {
        impl Real for $type {
            type Mask = bool;

            #[inline(always)]
            fn of(value: f64) -> Self {
                value as $type
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn less(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn less_equal(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            // The compiler would turn a selection into a branch.
            #[inline(always)]
            fn flipped_by(self, other: Self) -> Self {
                Self::from_bits(self.to_bits() ^ (other.to_bits() & $sign))
            }
        }
    };
}

scalar!(f64, 1 << 63);
scalar!(f32, 1 << 31);

#[cfg(test)]
mod tests {
    use super::*;

    fn checks<T: Real<Mask = bool> + PartialEq + std::fmt::Debug>() {
        assert_eq!(T::of(9.0).sqrt(), T::of(3.0));
        assert_eq!(T::of(-2.0).abs(), T::of(2.0));
        assert!(T::of(1.0).less(T::of(2.0)) && !T::of(2.0).less(T::of(2.0)));
        assert!(!T::of(f64::NAN).less(T::of(2.0)) && !T::of(2.0).less(T::of(f64::NAN)));
        assert!(T::of(2.0).less_equal(T::of(2.0)) && !T::of(f64::NAN).less_equal(T::of(2.0)));
        assert_eq!(T::select(true, T::of(1.0), T::of(2.0)), T::of(1.0));
        assert_eq!(T::select(false, T::of(1.0), T::of(2.0)), T::of(2.0));
        for (number, other, flipped) in [(2.0, 3.0, 2.0), (2.0, -3.0, -2.0), (-2.0, -0.5, 2.0), (-2.0, 1e-9, -2.0)] {
            assert_eq!(T::of(number).flipped_by(T::of(other)), T::of(flipped), "{number} by {other}");
        }
    }

    #[test]
    fn both_precisions_follow_the_contract() {
        checks::<f64>();
        checks::<f32>();
        assert_eq!(f32::of(0.1), 0.1_f32, "a constant is rounded to the nearest");
    }
}
