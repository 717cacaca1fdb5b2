//! A bound of the rounding errors in a quadratic's roots. It shows when rounding cannot have changed a
//! decision.
//!
//! Spheres and the sides of cylinders lead to `a lambda^2 - 2 h lambda + c = 0`. Rounding moves the discriminant
//! `D = h^2 - a c` by at most `E = error_constant u M`, where `u` is the unit roundoff, `M = |d|^2 (|O - C|^2 + r^2)`,
//! and the constant counts operations. It moves the numerator `n = h -+ sqrt(D)` of a root by at most `E / sqrt(D)`.
//! Both are derived in `docs/accuracy.md`. Hence, all quantities as computed:
//!
//! - the ray misses if `-D > E`;
//! - a root is below [`LAMBDA_MIN`] if `(a LAMBDA_MIN - n) sqrt(D) > E`;
//! - a root is accurate if `M + 4 n^2 < condition_limit n sqrt(D)`, and then `D > 0` is certain too.
//!
//! Every comparison with NaN is false, so a result that overflows is uncertain. Underflow is covered by a tiny constant
//! beside `M`, and by the demand that the direction is [in scale](in_scale).

use crate::{geometry::ray::LAMBDA_MIN, math::real::Real, math::rounding::Rounding};

/// The result of a formula, or that rounding may have changed it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision<A> {
    /// The decisions are right, and lambda is accurate.
    Certain(A),
    /// A decision may be wrong, or lambda inaccurate.
    Uncertain,
}

/// The constants of a shape's error bound.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// A bound of the rounding errors in the discriminant, in units of `u M`.
    pub error_constant: f64,
    /// The largest condition number of a root that is accepted in f64. The smaller, the more accurate is lambda, and
    /// the fewer rays keep the bits of the plain formula.
    pub condition_limit: f64,
}

impl Limits {
    /// The condition number up to which a root is accepted in the arithmetic `T`.
    #[inline(always)]
    pub const fn condition_limit<T: Rounding>(&self) -> f64 {
        self.condition_limit * T::LENIENCE
    }

    /// A bound of the relative error of an accepted lambda, which is at most a third of this.
    #[inline(always)]
    pub const fn lambda_error<T: Rounding>(&self) -> f64 {
        256.0 * self.condition_limit::<T>() * T::UNIT_ROUNDOFF
    }

    /// Whether an accurate lambda certainly is at least [`LAMBDA_MIN`].
    #[inline(always)]
    pub fn in_range<T: Rounding>(&self, lambda: T) -> T::Mask {
        (T::of(LAMBDA_MIN) + T::of(LAMBDA_MIN * self.lambda_error::<T>())).less_equal(lambda)
    }
}

/// Added where a product may underflow: 2^-600.
pub(super) const UNDERFLOW: f64 = f64::from_bits((1023 - 600) << 52);
/// The largest `M` whose products cannot overflow: 2^1000.
pub(super) const OVERFLOW: f64 = f64::from_bits((1023 + 1000) << 52);
/// The smallest squared length of a direction whose relative error does not suffer from underflow: 2^-300.
const SHORTEST: f64 = f64::from_bits((1023 - 300) << 52);
/// The largest squared length of a direction: 2^300.
const LONGEST: f64 = f64::from_bits((1023 + 300) << 52);

/// Whether a direction's length squared lies between 2^-300 and 2^300, outside of which nothing is certain in f64. It
/// does not depend on the object.
#[inline(always)]
pub fn in_scale<T: Rounding>(length_squared: T) -> T::Mask {
    T::of(SHORTEST).less_equal(length_squared) & length_squared.less_equal(T::of(LONGEST))
}

/// The certain result for one surface or one root. If neither `hits` nor `fails` holds, the result is uncertain.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<T: Real> {
    /// Lambda of the hit; it has no meaning unless `hits` holds.
    pub lambda: T,
    /// It is certainly a hit.
    pub hits: T::Mask,
    /// It is certainly no hit.
    pub fails: T::Mask,
}

/// The bounds for one ray and one object.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBound<T> {
    limits: Limits,
    /// `M`, the size of the terms that cancel in the discriminant.
    size: T,
    /// `E`, the bound of the error in the discriminant.
    error: T,
}

impl<T: Rounding> ErrorBound<T> {
    /// The bounds for a direction's length squared, and the sum of the squares of distance to the centre and radius.
    #[inline(always)]
    pub fn new(limits: Limits, length_squared: T, squares: T) -> Self {
        let size = length_squared * squares;
        Self { limits, size, error: size * T::of(limits.error_constant * T::UNIT_ROUNDOFF) + T::of(UNDERFLOW) }
    }

    /// Whether the line certainly misses.
    #[inline(always)]
    pub fn misses(&self, discriminant: T) -> T::Mask {
        self.error.less(-discriminant)
    }

    /// The root `numerator / a`, where `root` is that of the discriminant, and whether it is in range.
    #[inline(always)]
    pub fn root(&self, a: T, numerator: T, root: T) -> Outcome<T> {
        let lambda = numerator / a;
        let share = 1.0 / self.limits.condition_limit::<T>();
        // The compiler computes the first sum once for both roots. With two infinities the root is not accurate.
        let least = (self.size * T::of(share) + T::of(UNDERFLOW)) + numerator * numerator * T::of(4.0 * share);
        let accurate = least.less(root * numerator);
        let finite = self.size.less(T::of(OVERFLOW));
        let hits = accurate & finite & self.limits.in_range(lambda);
        Outcome { lambda, hits, fails: self.is_too_small(a, numerator, root) }
    }

    /// Whether the root `numerator / a` is certainly out of range: cheaper than the [root](Self::root) itself.
    #[inline(always)]
    pub fn is_too_small(&self, a: T, numerator: T, root: T) -> T::Mask {
        // Lowered by more than the relative error of `a`.
        let least = T::of(LAMBDA_MIN) - T::of(LAMBDA_MIN * self.limits.lambda_error::<T>());
        self.error.less((a * least - numerator) * root)
    }
}
