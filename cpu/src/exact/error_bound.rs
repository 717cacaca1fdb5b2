//! A bound of the rounding errors in a quadratic's roots: when rounding cannot have changed a decision.
//!
//! Spheres and the sides of cylinders lead to `a lambda^2 - 2 h lambda + c = 0`. Rounding moves the discriminant
//! `D = h^2 - a c` by at most `noise u M`, where `u` is the unit roundoff, `M = |d|^2 (|O - C|^2 + r^2)` and `noise` a
//! number that counts operations; it moves the numerator `n = h -+ sqrt(D)` of a root by at most `noise u M / sqrt(D)`.
//! Both are derived in `docs/accuracy.md`. Hence, all quantities as computed:
//!
//! - the ray misses when `-D > noise u M`;
//! - a root is below [`LAMBDA_MIN`] when `(a LAMBDA_MIN - n) sqrt(D) > noise u M`;
//! - a root is accurate when `M + 4 n^2 < condition n sqrt(D)`, and then `D > 0` is certain too.
//!
//! A comparison with something that is not a number fails, so whatever overflows is in doubt. Underflow is covered by
//! a tiny constant beside `M`, and by the demand that the direction is [in scale](in_scale).

use crate::geometry::ray::LAMBDA_MIN;
use crate::math::real::Real;
use crate::math::rounding::Rounding;

/// What a formula gives, or that rounding may have changed it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision<A> {
    /// The decisions are right, and a lambda is accurate.
    Certain(A),
    /// Something may be wrong.
    Uncertain,
}

/// What depends on the shape.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// A bound of the rounding errors in the discriminant, in units of `u M`.
    pub noise: f64,
    /// The largest condition number of a root that is accepted in f64. The smaller, the more accurate is lambda, and
    /// the fewer rays keep the bits of the plain formula.
    pub condition: f64,
}

impl Limits {
    /// The condition number up to which a root is accepted in the arithmetic `T`.
    #[inline(always)]
    #[must_use]
    pub const fn condition<T: Rounding>(&self) -> f64 {
        self.condition * T::LENIENCE
    }

    /// What the relative error of an accepted lambda stays below, with room to spare: it is at most a third of this.
    #[inline(always)]
    #[must_use]
    pub const fn lambda_error<T: Rounding>(&self) -> f64 {
        256.0 * self.condition::<T>() * T::UNIT_ROUNDOFF
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
/// The shortest direction's length squared whose relative error is not spoilt by underflow: 2^-300.
const SHORTEST: f64 = f64::from_bits((1023 - 300) << 52);
/// The longest direction's length squared: 2^300.
const LONGEST: f64 = f64::from_bits((1023 + 300) << 52);

/// Whether a direction's length squared lies between 2^-300 and 2^300, outside of which nothing is certain in f64. The
/// same for all objects that a ray is tried on.
#[inline(always)]
pub fn in_scale<T: Rounding>(length_squared: T) -> T::Mask {
    T::of(SHORTEST).less_equal(length_squared) & length_squared.less_equal(T::of(LONGEST))
}

/// What is certain of one surface or one root. Where it neither hits nor fails it is in doubt.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<T: Real> {
    /// Where, if it hits.
    pub lambda: T,
    /// It certainly counts.
    pub hits: T::Mask,
    /// It certainly does not.
    pub fails: T::Mask,
}

/// The bounds for one ray and one object.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBound<T> {
    limits: Limits,
    /// `M`, the size of what cancels in the discriminant.
    size: T,
    /// `noise u M`.
    noise: T,
}

impl<T: Rounding> ErrorBound<T> {
    /// The bounds for a direction's length squared, and the sum of the squares of distance to the centre and radius.
    #[inline(always)]
    #[must_use]
    pub fn new(limits: Limits, length_squared: T, squares: T) -> Self {
        let size = length_squared * squares;
        Self { limits, size, noise: size * T::of(limits.noise * T::UNIT_ROUNDOFF) + T::of(UNDERFLOW) }
    }

    /// Whether the line certainly misses.
    #[inline(always)]
    pub fn misses(&self, discriminant: T) -> T::Mask {
        self.noise.less(-discriminant)
    }

    /// The root `numerator / a`, where `root` is that of the discriminant: whether it is in range.
    #[inline(always)]
    pub fn root(&self, a: T, numerator: T, root: T) -> Outcome<T> {
        let lambda = numerator / a;
        let share = 1.0 / self.limits.condition::<T>();
        // The first sum is the same for both roots. Strictly less: two infinities give no certainty.
        let least = (self.size * T::of(share) + T::of(UNDERFLOW)) + numerator * numerator * T::of(4.0 * share);
        let accurate = least.less(root * numerator);
        let finite = self.size.less(T::of(OVERFLOW));
        let hits = accurate & finite & self.limits.in_range(lambda);
        Outcome { lambda, hits, fails: self.is_too_small(a, numerator, root) }
    }

    /// Whether the root `numerator / a` certainly is too small to count: for less than the [root](Self::root) itself.
    #[inline(always)]
    pub fn is_too_small(&self, a: T, numerator: T, root: T) -> T::Mask {
        // Lowered by more than the relative error of `a`.
        let least = T::of(LAMBDA_MIN) - T::of(LAMBDA_MIN * self.limits.lambda_error::<T>());
        self.noise.less((a * least - numerator) * root)
    }
}
