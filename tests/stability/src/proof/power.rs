//! The error of a power in double-double arithmetic, `math/power/quick.rs`.
//!
//! Sums and products have the relative errors that their authors prove (`math/double_double.rs`): `3 u^2` and `4 u^2`.
//! The entries of the tables have those that all of them are measured to have, in arithmetic of 256 bits. Bounds are
//! computed in `f64`, whose rounding is far below the slack.

use std::cell::Cell;

use cpu::internals::math::double_double::DoubleDouble;
use cpu::internals::math::power::quick::{POWER_ERROR, Wide, exp_of_rest, ln_of_parts, rest};
use cpu::internals::math::power::tables::{LN_2, exponential, ln_128_over, reciprocal};
use dashu_float::{FBig, round::mode::HalfEven};

use super::row::{Row, U};
use super::ruled::{Ruled, Rules};

/// The square of the unit roundoff.
const UU: f64 = U * U;

/// A number of about 106 bits, or of 53 bits if it is `NARROW`, as a multiple of a power of `z`. It is `c z^power` with
/// `low <= c <= high`, up to an error of at most `error |z|^power`. [`MOST`] bounds `|z|`.
#[derive(Clone, Copy, Debug)]
struct Near<const NARROW: bool> {
    power: i32,
    low: f64,
    high: f64,
    error: f64,
}

thread_local! {
    /// A bound of `|z|`.
    static MOST: Cell<f64> = const { Cell::new(0.0) };
    /// A bound of the relative error of the entries of the tables.
    static TABLES: Cell<f64> = const { Cell::new(0.0) };
}

impl<const NARROW: bool> Near<NARROW> {
    /// Returns the number whose exact value is from `low` to `high` times a power of `z`, with this error.
    const fn new(power: i32, low: f64, high: f64, error: f64) -> Self {
        Self { power, low, high, error }
    }

    const fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Returns the number after a rounding, with a relative error of at most `roundings u^2`, or `u` if it is narrow.
    fn rounded(self, roundings: f64) -> Self {
        let unit = if NARROW { U } else { roundings * UU };
        Self { error: self.error + unit * (self.magnitude() + self.error), ..self }
    }

    /// Returns the same number as a multiple of a lower power of `z`, which may have either sign.
    fn lowered(self, power: i32) -> Self {
        if power == self.power {
            return self;
        }
        let factor = MOST.get().powi(self.power - power);
        let most = self.magnitude() * factor;
        Self { power, low: -most, high: most, error: self.error * factor }
    }

    /// Returns the largest relative error, for a number that is not 0.
    fn relative(self) -> f64 {
        assert!(self.low > 0.0 || self.high < 0.0, "{self:?} may be 0");
        self.error / self.low.abs().min(self.high.abs())
    }
}

impl<const NARROW: bool> Rules for Near<NARROW> {
    fn of(value: f64) -> Self {
        // The constants of narrow numbers are rounded quotients.
        Self::new(0, value, value, if NARROW { value.abs() * U } else { 0.0 })
    }
    fn plus(self, other: Self) -> Self {
        // A number that is exactly 0 is a multiple of any power.
        let is_zero = |number: Self| number.magnitude() + number.error == 0.0;
        if is_zero(self) || is_zero(other) {
            return if is_zero(self) { other } else { self };
        }
        let power = self.power.min(other.power);
        let (a, b) = (self.lowered(power), other.lowered(power));
        Self::new(power, a.low + b.low, a.high + b.high, a.error + b.error).rounded(3.0)
    }
    fn negative(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }
    fn times(self, other: Self) -> Self {
        let ends = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        let (low, high) =
            (ends.into_iter().fold(f64::INFINITY, f64::min), ends.into_iter().fold(-f64::INFINITY, f64::max));
        let error = self.magnitude() * other.error + other.magnitude() * self.error + self.error * other.error;
        Self::new(self.power + other.power, low, high, error).rounded(4.0)
    }
}

impl Wide for Ruled<Near<false>> {
    type Narrow = Ruled<Near<true>>;

    fn high(self) -> Self::Narrow {
        let Near { power, low, high, error } = self.0;
        Ruled(Near::new(power, low, high, error).rounded(0.0))
    }
    fn widened(narrow: Self::Narrow) -> Self {
        let Near { power, low, high, error } = narrow.0;
        Self(Near::new(power, low, high, error))
    }
    fn constant(DoubleDouble { high, low }: DoubleDouble) -> Self {
        let value = high + low;
        // The sum is rounded.
        let around = value.abs() * f64::EPSILON;
        Self(Near::new(0, value - around, value + around, value.abs() * TABLES.get()))
    }
}

/// Returns the largest relative error of the entries of the tables.
fn error_of_tables() -> f64 {
    type Big = FBig<HalfEven, 2>;
    let big = |value: f64| Big::try_from(value).expect("it is finite").with_precision(256).value();
    let logarithms = (90..=181).map(|k| (ln_128_over(k), (big(128.0) / big(k as f64)).ln()));
    let exponentials = (-23..=23).map(|j| (exponential(j), (big(j as f64) / big(64.0)).exp()));
    let reciprocals = [2, 3, 4, 5, 6, 24, 120].map(|n| (reciprocal(n), big(1.0) / big(n as f64)));
    let errors =
        logarithms.chain(exponentials).chain(reciprocals).chain([(LN_2, big(2.0).ln())]).map(|(entry, exact)| {
            let error = (big(entry.high) + big(entry.low) - &exact).to_f64().value().abs();
            if error == 0.0 { 0.0 } else { error / exact.to_f64().value().abs() }
        });
    errors.fold(0.0, f64::max)
}

/// Returns the row of the relative error of a power.
///
/// `z` is exact: `m` has 53 bits and `k` 8, and the difference with 1 has fewer than 106. `|z|` is at most `m / 256`,
/// about `2^-7.5`. The remainders of the series are at most `|z|^15 / 15 (1 - |z|)` and `|r|^13 / 13! e^|r|`. The sum
/// of the fraction's low half and the bound of its error is rounded, which is below `2 u^2`.
#[must_use]
pub fn row() -> Row {
    TABLES.set(error_of_tables());
    // `|t|` is at most 746.
    let fraction = of_exponential(746.0 * of_logarithm());
    Row::new("powers", "math/power/quick.rs", [POWER_ERROR / UU, fraction / UU + 2.0], "u^2")
}

/// Returns the largest relative error of `t`, a logarithm times an exponent.
fn of_logarithm() -> f64 {
    let most = std::f64::consts::SQRT_2 / 256.0 * (1.0 + 1e-9);
    MOST.set(most);
    let z = Ruled(Near::<false>::new(1, 1.0, 1.0, 0.0));
    let remainder = most.powi(14) / 15.0 / (1.0 - most);
    let of = |e: i64, k: usize| {
        let Ruled(ln) = ln_of_parts(e, k, z);
        // Relative to the power of `z` that the logarithm has.
        Near { error: ln.error + remainder * most.powi(1 - ln.power), ..ln }.relative()
    };
    // Every exponent, of subnormal numbers too, with every entry.
    let largest =
        (-1074..=1024).flat_map(|e| (90..=181).map(move |k| (e, k))).map(|(e, k)| of(e, k)).fold(0.0, f64::max);
    largest + 4.0 * UU * (1.0 + largest)
}

/// Returns the largest relative error of `e^t`, if `t` is wrong by at most `error`.
fn of_exponential(error: f64) -> f64 {
    MOST.set(0.0);
    let half = LN_2.high / 2.0 + 1e-9;
    let of_rest = (-1076..=1025).map(|n| {
        let middle = n as f64 * LN_2.high;
        rest(Ruled(Near::<false>::new(0, middle - half, middle + half, error)), n).0.error
    });
    let of_rest = of_rest.fold(0.0, f64::max);
    // The difference with `j / 64` is rounded.
    let most = 0.5_f64.powi(7) + 1e-9;
    let r = Ruled(Near::<false>::new(0, -most, most, of_rest).rounded(3.0));
    let of = |j: i64| {
        let Ruled(fraction) = exp_of_rest(r, j);
        fraction.relative() + most.powi(13) / 6_227_020_800.0 * 1.02
    };
    (-23..=23).map(of).fold(0.0, f64::max)
}
