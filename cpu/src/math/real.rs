//! The trait [`Real`], over which formulas are generic: one number, or several numbers at once.
//!
//! For `f32`, `f64` and lanes of `f64`, every operation is one correctly rounded IEEE operation. So a formula gives the
//! same bits in a lane as for a single number.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A real number, or lanes that hold one real number each.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The result of a comparison: one `bool`, or one for each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// Returns the number nearest to `value`, in every lane.
    fn of(value: f64) -> Self;
    /// Returns the square root, which is NaN if the number is negative.
    fn sqrt(self) -> Self;
    /// Returns the magnitude.
    fn abs(self) -> Self;
    /// Whether `self < other`. The result is false if one of the numbers is NaN.
    fn less(self, other: Self) -> Self::Mask;
    /// Whether `self <= other`. The result is false if one of the numbers is NaN.
    fn less_equal(self, other: Self) -> Self::Mask;
    /// Returns `yes` where `mask` holds, and `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Returns the result of a comparison that holds nowhere.
    #[inline(always)]
    fn empty_mask() -> Self::Mask {
        Self::of(1.0).less(Self::of(0.0))
    }
    /// Returns the number, negated where `other` is negative. Where `other` is a zero, implementations may negate or
    /// not.
    #[inline(always)]
    fn flipped_by(self, other: Self) -> Self {
        Self::select(other.less(Self::of(0.0)), -self, self)
    }
}

/// Adds `#[inline(always)]` to each of the functions that are written in it, in the body of an `impl`. A type of
/// numbers or lanes has many functions of one line each. Without an attribute between them, they can be read like a
/// table.
macro_rules! functions {
    ($(fn $name:ident($($argument:tt)*) $(-> $result:ty)? $body:block)+) => {
        $(#[inline(always)]
        fn $name($($argument)*) $(-> $result)? $body)+
    };
}
pub(crate) use functions;

macro_rules! scalar {
    ($type:ty, $sign:expr) => {
        impl Real for $type {
            type Mask = bool;

            functions! {
                fn of(value: f64) -> Self { value as $type }
                fn sqrt(self) -> Self { self.sqrt() }
                fn abs(self) -> Self { self.abs() }
                fn less(self, other: Self) -> bool { self < other }
                fn less_equal(self, other: Self) -> bool { self <= other }
                fn select(mask: bool, yes: Self, no: Self) -> Self { if mask { yes } else { no } }
                // The compiler would turn a selection into a branch.
                fn flipped_by(self, other: Self) -> Self {
                    Self::from_bits(self.to_bits() ^ (other.to_bits() & $sign))
                }
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
