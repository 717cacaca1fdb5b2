//! Computes a bound on the error of f32 formulas, by running error analysis (N. Higham, Accuracy and Stability of
//! Numerical Algorithms, section 3.3).
//!
//! A [`Running`] is a value with a bound on the distance between this value and the result of the formula in f32. An
//! operation of IEEE 754 returns the exact result of its operands, rounded. The rounding error is at most half a unit
//! in the last place: `u = 2^-24` times the result, or `2^-150` below the normal numbers. If the errors of `x` and `y`
//! are at most `e` and `f`, the errors of results are at most
//!
//! - for `x + y`: `e + f`, plus the rounding error;
//! - for `x y`: `|x| f + |y| e + e f`, plus the rounding error;
//! - for `x / y`: `(e + |x / y| f) / (|y| - f)`, plus the rounding error; there is no bound if `f >= |y|`;
//! - for `sqrt x`: `e / (sqrt x + sqrt(x - e))`, plus the rounding error; there is no bound if `e >= x`, unless both
//!   are 0.
//!
//! WGSL asks less of a device (`Running<false>`). It may round sums and products up or down, and replace numbers
//! below the normal ones by zero. Its quotients may be off by 2.5 units, and its root is `1 / inverseSqrt x`. The
//! bounds hold for operations that are done as they are written.
//!
//! The formulas of `cpu` are generic, so the formula's own code computes the bound. If the operands of a comparison are
//! closer than their bounds, the comparison may have another result in f32. Then the case is marked and not compared.
//! The value and the bound are computed in f64, whose rounding errors `WIDE_U` and `SLACK` cover.

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use cpu::internals::math::real::Real;

/// Half a unit in the last place of f32, relative to the number: `2^-24`.
const U: f64 = 1.0 / 16_777_216.0;
/// Half of the smallest positive f32, `2^-150`: the largest rounding error below the normal numbers.
const ETA: f64 = f64::from_bits((1023 - 150) << 52);
/// The smallest normal f32, `2^-126`. Smaller numbers may be replaced by zero.
const SMALLEST: f64 = f32::MIN_POSITIVE as f64;
/// The largest divisor for which WGSL bounds the error of a quotient, `2^126`.
const LARGEST_DIVISOR: f64 = 1.0 / SMALLEST;
/// Half a unit in the last place of f64, in which the value is computed.
const WIDE_U: f64 = f64::EPSILON / 2.0;
/// A factor that covers the rounding errors of the bound, which is computed in f64. The part above 1 is about 4,500
/// times the epsilon of f64.
const SLACK: f64 = 1.0 + 1e-12;
/// The largest finite f32. Larger results overflow to infinity.
const LARGEST: f64 = f32::MAX as f64;

thread_local! {
    /// Whether any comparison since the start of [`observe`] may have another result in f32.
    static UNDECIDED: Cell<bool> = const { Cell::new(false) };
}

/// A value in f64, and a bound on its distance from the result in f32. The device has the arithmetic of IEEE 754 if
/// `IEEE` is true, and otherwise that of WGSL. The functions are `#[inline]` because millions of them are called.
#[derive(Clone, Copy, Debug)]
pub struct Running<const IEEE: bool> {
    /// The value, computed in f64.
    pub value: f64,
    /// The bound on the distance; infinite if there is no bound.
    pub bound: f64,
}

impl<const IEEE: bool> Running<IEEE> {
    /// Returns an input, which is exact in f32 and in f64.
    #[must_use]
    #[inline]
    pub fn exact(value: f64) -> Self {
        let may_vanish = value.abs() < SMALLEST && !IEEE;
        Self { value, bound: if may_vanish { value.abs() } else { 0.0 } }
    }

    /// Returns a result that is rounded to the nearest number, or for WGSL up or down; see [`Self::off_by`].
    #[inline]
    fn rounded(value: f64, carried: f64) -> Self {
        Self::off_by(if IEEE { 1.0 } else { 2.0 }, value, carried)
    }

    /// Returns a result with its bound. `carried` bounds the error that comes from the operands. The error of the
    /// operation itself is added here; it is `halves` times half a unit in the last place.
    #[inline]
    fn off_by(halves: f64, value: f64, carried: f64) -> Self {
        let largest = value.abs() + carried;
        let tiny = if IEEE { ETA } else { SMALLEST };
        let bound = (carried + (halves * U + WIDE_U) * largest + tiny) * SLACK;
        // There is no bound if f32 may overflow, or if a number is NaN, for which the comparison is false.
        let known = largest + bound < LARGEST;
        Self { value, bound: if known { bound } else { f64::INFINITY } }
    }

    /// Records whether a comparison of `self` with `other` may have another result in f32.
    #[inline]
    fn compare(self, other: Self) {
        let distance = (self.value - other.value).abs();
        let decided = distance > (self.bound + other.bound) * SLACK || self.is_exact() && other.is_exact();
        if !decided {
            UNDECIDED.set(true);
        }
    }

    #[inline]
    fn is_exact(self) -> bool {
        self.bound == 0.0 && !self.value.is_nan()
    }
}

/// Calls `work`. Returns its result, and whether all comparisons in it certainly have the same results in f32.
pub fn observe<R>(work: impl FnOnce() -> R) -> (R, bool) {
    UNDECIDED.set(false);
    let result = work();
    (result, !UNDECIDED.get())
}

impl<const IEEE: bool> Add for Running<IEEE> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.bound + other.bound)
    }
}

impl<const IEEE: bool> Sub for Running<IEEE> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.bound + other.bound)
    }
}

impl<const IEEE: bool> Mul for Running<IEEE> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let carried = self.value.abs() * other.bound + other.value.abs() * self.bound + self.bound * other.bound;
        Self::rounded(self.value * other.value, carried)
    }
}

impl<const IEEE: bool> Div for Running<IEEE> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = other.value.abs() - other.bound;
        let carried = if least > 0.0 { (self.bound + value.abs() * other.bound) / least } else { f64::INFINITY };
        match IEEE {
            true => Self::rounded(value, carried),
            false if least < SMALLEST || other.value.abs() + other.bound > LARGEST_DIVISOR => {
                Self { value, bound: f64::INFINITY }
            }
            // 2.5 units.
            false => Self::off_by(5.0, value, carried),
        }
    }
}

impl<const IEEE: bool> Neg for Running<IEEE> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl<const IEEE: bool> Real for Running<IEEE> {
    type Mask = bool;

    #[inline]
    fn of(value: f64) -> Self {
        let single = f64::from(value as f32);
        if single == value { Self::exact(value) } else { Self::off_by(0.0, value, (single - value).abs()) }
    }

    #[inline]
    fn sqrt(self) -> Self {
        if self.is_exact() && self.value == 0.0 && IEEE {
            return self;
        }
        let value = self.value.sqrt();
        let least = self.value - self.bound;
        let carried = if least > 0.0 { self.bound / (value + least.sqrt()) } else { f64::INFINITY };
        match IEEE {
            true => Self::rounded(value, carried),
            false if least < SMALLEST => Self { value, bound: f64::INFINITY },
            // 2 units of the inverse root and 2.5 of the quotient are 9 halves; the tenth covers their product.
            false => Self::off_by(10.0, value, carried),
        }
    }

    #[inline]
    fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }

    #[inline]
    fn less(self, other: Self) -> bool {
        self.compare(other);
        self.value < other.value
    }

    #[inline]
    fn less_equal(self, other: Self) -> bool {
        self.compare(other);
        self.value <= other.value
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cpu::internals::sampling::uniform::Uniform;

    type Ieee = Running<true>;
    type Wgsl = Running<false>;

    /// A formula that uses every operation, and in which numbers cancel.
    fn formula<T: Real>(x: T, y: T, z: T) -> T {
        ((x * x + y * y - z * z).abs().sqrt() - x * y) / (z + T::of(0.1)) - y
    }

    #[test]
    fn f32_stays_within_the_bound() {
        let mut draws = Uniform::new(1);
        let (mut compared, mut closest) = (0, 0.0_f64);
        for _ in 0..100_000 {
            let [x, y, z] = [(); 3].map(|()| draws.draw(-10.0, 10.0) as f32);
            let bounded = formula(Ieee::exact(x.into()), Ieee::exact(y.into()), Ieee::exact(z.into()));
            let error = (f64::from(formula(x, y, z)) - bounded.value).abs();
            assert!(error <= bounded.bound, "{x} {y} {z}: {error} > {}", bounded.bound);
            closest = closest.max(error / bounded.bound);
            compared += usize::from(bounded.bound.is_finite());
        }
        assert!(compared > 99_000, "{compared} bounds are finite");
        assert!(closest > 0.1, "the bound is not too large: the largest error is {closest} of it");
    }

    #[test]
    fn a_comparison_too_close_for_f32_is_noted() {
        let third = Ieee::of(1.0 / 3.0);
        assert_eq!(observe(|| third.less(Ieee::of(0.5))), (true, true));
        assert!(!observe(|| third.less(Ieee::of(1.0 / 3.0 + 1e-9))).1);
        assert!(!observe(|| (third - third).sqrt().less(third)).1, "a root of a rounding error has no bound");
        assert!(!observe(|| Ieee::of(f64::NAN).less(third)).1);
    }

    #[test]
    fn wgsl_allows_more_than_ieee() {
        fn result<const IEEE: bool>() -> Running<IEEE> {
            formula(Running::exact(3.0), Running::exact(0.7), Running::exact(1.9))
        }
        let (ieee, wgsl) = (result::<true>(), result::<false>());
        assert!(ieee.bound * 1.5 < wgsl.bound && wgsl.bound < ieee.bound * 10.0, "{ieee:?} {wgsl:?}");
        assert!(Ieee::exact(1e-40).is_exact());
        let tiny = Wgsl::exact(1e-40);
        assert_eq!(tiny.bound, 1e-40);
        assert!((Wgsl::exact(1.0) / tiny).bound.is_infinite() && tiny.sqrt().bound.is_infinite());
        // A quotient that is off by two units, and the root of a number whose inverse root is.
        let quotient = Wgsl::exact(1.0) / Wgsl::exact(3.0);
        let off = (1.0_f32 / 3.0).next_up().next_up();
        assert!((f64::from(off) - quotient.value).abs() <= quotient.bound);
        let root = Wgsl::exact(2.0).sqrt();
        let off = 1.0 / (1.0 / 2.0_f32.sqrt()).next_up().next_up();
        assert!((f64::from(off) - root.value).abs() <= root.bound);
    }

    #[test]
    fn a_result_that_overflows_in_f32_has_no_bound() {
        let large = Ieee::exact(1e30);
        assert!((large * large).bound.is_infinite() && (large + large).bound.is_finite());
        assert!((large / Ieee::exact(0.0)).bound.is_infinite());
    }
}
