//! What is known of a number: bounds of its exact value and of its rounding error.

use std::cell::Cell;

use super::polynomial::Polynomial;

/// What is known of a number: `|exact| <= size`, `|computed - exact| <= u error` and, short of underflow,
/// `|computed - exact| <= u relative |exact|`.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// Bounds the magnitude of the exact value.
    pub size: Polynomial,
    /// Bounds the rounding error, in units of the unit roundoff.
    pub error: Polynomial,
    /// Bounds the part of the error that the operands bring, without the last rounding. `None` for inputs and
    /// constants.
    pub(super) before: Option<Polynomial>,
    /// Bounds the relative error, in units of the unit roundoff. It is infinite if nothing is known.
    pub relative: f64,
    /// Whether the number is a square, or made from squares, so that it is not negative.
    pub(super) is_positive: bool,
    /// Whether `size` is the magnitude itself and not only a bound. A margin times such a number is known.
    pub(super) is_exact: bool,
    /// Whether the number is a constant that is a power of two, so that products with it are exact.
    pub(super) is_power_of_two: bool,
}

/// The rounding of an arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Arithmetic {
    /// The unit roundoff `u`.
    pub roundoff: f64,
    /// The largest error of a product by underflow, half of the smallest number, in units of `u`.
    pub underflow: f64,
}

impl Arithmetic {
    /// The arithmetic of `f64`.
    pub const F64: Self = Self { roundoff: f64::EPSILON / 2.0, underflow: f64::MIN_POSITIVE };
    /// The arithmetic of `f32`.
    pub const F32: Self = Self { roundoff: f32::EPSILON as f64 / 2.0, underflow: f32::MIN_POSITIVE as f64 };
}

thread_local! {
    /// The arithmetic of the present proof.
    pub(super) static ARITHMETIC: Cell<Arithmetic> = const { Cell::new(Arithmetic::F64) };
}

/// Returns the arithmetic of the present proof.
pub(super) fn arithmetic() -> Arithmetic {
    ARITHMETIC.get()
}

/// Returns the relative error of a product of numbers with these relative errors, in units of `u`.
pub(super) fn composed(a: f64, b: f64) -> f64 {
    if a.is_finite() && b.is_finite() { a + b + a * b * arithmetic().roundoff } else { f64::INFINITY }
}

impl Bounds {
    /// Returns the bounds of a result with this exact size, into which the operands bring the error `before`, and which
    /// is then rounded once.
    pub(super) fn rounded(size: Polynomial, before: Polynomial) -> Self {
        let rounding = size.clone().plus(&before.clone().scaled(arithmetic().roundoff));
        let error = before.clone().plus(&rounding);
        let [is_positive, is_exact, is_power_of_two] = [false; 3];
        Self { size, error, before: Some(before), relative: f64::INFINITY, is_positive, is_exact, is_power_of_two }
    }

    /// Returns the bounds of an exact value of this size, or of one that has a relative error of at most `error u`.
    pub(super) fn of_value(size: Polynomial, error: f64) -> Self {
        let is_exact = size.is_monomial();
        let error = (size.clone().scaled(error), error);
        let [is_positive, is_power_of_two] = [false; 2];
        Self { size, error: error.0, before: None, relative: error.1, is_positive, is_exact, is_power_of_two }
    }

    /// Returns the bounds with this relative error, to which the last rounding is added.
    pub(super) fn with_relative(self, before: f64, is_positive: bool, is_exact: bool) -> Self {
        Self { relative: composed(before, 1.0), is_positive, is_exact, ..self }
    }

    /// Returns the bounds with lengths of vectors in place of products of components.
    #[must_use]
    pub fn in_lengths(&self) -> Self {
        let before = self.before.as_ref().map(Polynomial::in_lengths);
        Self { size: self.size.in_lengths(), error: self.error.in_lengths(), before, ..*self }
    }
}
