//! A bound of the rounding errors in a quadratic's roots. It shows when rounding cannot have changed a
//! decision.
//!
//! Spheres and the sides of cylinders lead to `a lambda^2 - 2 h lambda + c = 0`. Rounding moves the discriminant
//! `D = h^2 - a c` by at most `E = error_constant u M`. Here `u` is the unit roundoff, `M = |d|^2 (|O - C|^2 + r^2)`,
//! and the error constant counts roundings. Rounding moves the numerator `n = h -+ sqrt(D)` of a root by at most
//! `E / sqrt(D)`. Both bounds are derived in `docs/accuracy.md`. So these decisions are certain, with the computed
//! values of all quantities:
//!
//! - the ray misses if `-D > E`;
//! - a root is below [`LAMBDA_MIN`] if `(a LAMBDA_MIN - n) sqrt(D) > E`;
//! - a root is accurate if `M + 4 n^2 < condition_limit n sqrt(D)`, and then `D > 0` is certain too;
//! - a root is at least `(n - E / sqrt(D)) / a`, but for the relative error of `a` and of this formula.
//!
//! If `|O - C|^2 + r^2` or `M` is 2^1000 or more, `E` overflows, and nothing is certain. In all other cases no quantity
//! overflows. Underflow cannot make a wrong result certain, for two reasons: a tiny constant is added to `M`, and the
//! direction must be [in scale](in_scale). `tests/stability/src/proof/magnitudes.rs` proves both.

use crate::{geometry::ray::LAMBDA_MIN, math::real::Real, math::rounding::Rounding};

/// The answer of a floating-point filter: the result of a formula if it is certain. If rounding may have changed the
/// result, the answer is [`Decision::Uncertain`]. A certain miss is `Certain(None)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision<A> {
    /// The result. Its decisions are right, and its lambda is accurate.
    Certain(A),
    /// There is no result: a decision may be wrong, or lambda may be inaccurate.
    Uncertain,
}

/// The constants of the error bound, for one kind of surface.
#[derive(Clone, Copy, Debug)]
pub struct BoundConstants {
    /// The bound of the rounding errors in the discriminant, in units of `u M`. The documentation of [this
    /// module](self) defines `u` and `M`.
    pub error_constant: f64,
    /// The largest condition number of a root that is accepted. The condition number is `(M + 4 n^2) / (n
    /// sqrt(D))`, with the root's numerator `n` and the discriminant `D`. With a smaller limit lambda is more accurate,
    /// but fewer rays keep the bits of the plain formula.
    pub condition_limit: f64,
}

impl BoundConstants {
    /// Returns a bound of the relative error of an accepted lambda. The error is at most a third of the bound.
    #[inline(always)]
    pub const fn lambda_error(&self) -> f64 {
        256.0 * self.condition_limit * <f64 as Rounding>::UNIT_ROUNDOFF
    }

    /// Returns the error of the discriminant as a share of `M`, which is given [`HEADROOM`] times as large.
    #[inline(always)]
    pub const fn error_of_size(&self) -> f64 {
        self.error_constant * <f64 as Rounding>::UNIT_ROUNDOFF / HEADROOM
    }

    /// Whether `lambda`, which must be accurate, certainly is at least [`LAMBDA_MIN`].
    #[inline(always)]
    pub(crate) fn certainly_in_range<T: Rounding>(&self, lambda: T) -> T::Mask {
        (T::of(LAMBDA_MIN) + T::of(LAMBDA_MIN * self.lambda_error())).less_equal(lambda)
    }
}

/// The weight of the square of the numerator in the condition number of a root; see
/// [`BoundConstants::condition_limit`].
pub const NUMERATOR_WEIGHT: f64 = 4.0;

/// The constant that covers underflow, 2^-600. It is added to terms whose products may underflow.
pub const UNDERFLOW: f64 = f64::from_bits((1023 - 600) << 52);
/// The limit of `M`, 2^1000. If `M` is smaller, its products cannot overflow.
pub const OVERFLOW: f64 = f64::from_bits((1023 + 1000) << 52);
/// `|O - C|^2 + r^2` is multiplied by this power of two, so that it or `M` overflows if it is not below [`OVERFLOW`].
pub const HEADROOM: f64 = f64::from_bits((1023 + 24) << 52);
/// The smallest squared length of a direction that is in scale, 2^-300. Underflow in its computation is negligible.
pub const SMALLEST_IN_SCALE: f64 = f64::from_bits((1023 - 300) << 52);
/// The largest squared length of a direction that is in scale, 2^300.
pub const LARGEST_IN_SCALE: f64 = f64::from_bits((1023 + 300) << 52);

/// Whether a direction is in scale: the square of its length lies between 2^-300 and 2^300. If a direction is not in
/// scale, every result is uncertain. This does not depend on the object.
#[inline(always)]
pub fn in_scale<T: Rounding>(length_squared: T) -> T::Mask {
    T::of(SMALLEST_IN_SCALE).less_equal(length_squared) & length_squared.less_equal(T::of(LARGEST_IN_SCALE))
}

/// What is certain about the hit at one root, or with one disc. If neither `hits` nor `fails` holds, it is uncertain
/// whether there is a hit.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<T: Real> {
    /// The lambda of the hit. It has no meaning unless `hits` holds.
    pub lambda: T,
    /// There certainly is a hit.
    pub hits: T::Mask,
    /// There certainly is no hit.
    pub fails: T::Mask,
}

/// The error bound for one ray and one object.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBound<T> {
    constants: BoundConstants,
    /// `M`, the size of the terms that cancel in the discriminant, times [`HEADROOM`].
    size: T,
    /// `E`, the bound of the error in the discriminant.
    error_bound: T,
}

impl<T: Rounding> ErrorBound<T> {
    /// Returns the error bound. `length_squared` is the square of the direction's length, and `squares` is
    /// `|O - C|^2 + r^2`.
    #[inline(always)]
    pub(crate) fn new(constants: BoundConstants, length_squared: T, squares: T) -> Self {
        Self::of_size(constants, length_squared * (squares * T::of(HEADROOM)))
    }

    /// Returns the error bound of a discriminant, for the size of its terms times [`HEADROOM`].
    #[inline(always)]
    pub(crate) fn of_size(constants: BoundConstants, size: T) -> Self {
        Self { constants, size, error_bound: size * T::of(constants.error_of_size()) + T::of(UNDERFLOW) }
    }

    /// Whether the ray's line certainly misses the surface, for this computed discriminant.
    #[inline(always)]
    pub(crate) fn misses(&self, discriminant: T) -> T::Mask {
        self.error_bound.less(-discriminant)
    }

    /// Returns the lambda `numerator / a`, and whether it certainly is in range or certainly is not. `sqrt_d` is the
    /// square root of the discriminant.
    #[inline(always)]
    pub(crate) fn root(&self, a: T, numerator: T, sqrt_d: T) -> Outcome<T> {
        let lambda = numerator / a;
        let share = 1.0 / self.constants.condition_limit;
        // The compiler computes the first sum once for both roots. If both sides are infinite, the root is not
        // accurate.
        let threshold = (self.size * T::of(share / HEADROOM) + T::of(UNDERFLOW))
            + numerator * numerator * T::of(NUMERATOR_WEIGHT * share);
        let accurate = threshold.less(sqrt_d * numerator);
        let hits = accurate & self.constants.certainly_in_range(lambda);
        Outcome { lambda, hits, fails: self.is_too_small(a, numerator, sqrt_d) }
    }

    /// Returns a lower bound of the exact lambda of the root `numerator / a`, with a relative error below 2^-50. It is
    /// negative infinity if no bound is known.
    #[inline(always)]
    pub(crate) fn lower_bound_of_lambda(&self, a: T, numerator: T, sqrt_d: T) -> T {
        let lower_bound = (numerator - self.error_bound / sqrt_d) / a;
        // A number that overflows makes this -inf or NaN.
        T::select(T::of(f64::NEG_INFINITY).less(lower_bound), lower_bound, T::of(f64::NEG_INFINITY))
    }

    /// Whether the lambda `numerator / a` certainly is below [`LAMBDA_MIN`]. This is cheaper than
    /// [`ErrorBound::root`], because there is no division.
    #[inline(always)]
    pub(crate) fn is_too_small(&self, a: T, numerator: T, sqrt_d: T) -> T::Mask {
        // The limit is lowered by more than the relative error of `a` and the rounding of the limit.
        let lowered_lambda_min = T::of(LAMBDA_MIN) - T::of(LAMBDA_MIN * self.constants.lambda_error());
        self.error_bound.less((a * lowered_lambda_min - numerator) * sqrt_d)
    }
}
