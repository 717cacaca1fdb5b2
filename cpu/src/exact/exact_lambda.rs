//! The exact lambda of a hit. It is a root of a quadratic whose coefficients have no rounding errors. Comparisons take
//! no square root. Only [`ExactLambda::rounded`] does.

use std::cmp::Ordering;

use crate::geometry::ray::LAMBDA_MIN;
use crate::math::dyadic::{Dyadic, of_finite, sign_with_sqrt, sign_with_two_sqrts, times_power_of_two};
use crate::math::{double_double::DoubleDouble, real::Real};

/// The equation `a lambda^2 - 2 h lambda + c = 0` with real roots: `a > 0`, and the discriminant `D = h^2 - a c` is at
/// least 0.
#[derive(Debug)]
pub struct ExactQuadratic {
    a: Dyadic,
    h: Dyadic,
    c: Dyadic,
    discriminant: Dyadic,
}

impl ExactQuadratic {
    /// Returns the equation with these coefficients. The result is `None` if it has no real root, so that the ray's
    /// line misses the surface. It is also `None` if `a` is 0: the direction is null, or parallel to the axis.
    pub(crate) fn with_roots(a: Dyadic, h: Dyadic, c: Dyadic) -> Option<Self> {
        let discriminant = &h.squared() - &(&a * &c);
        let real = a.sign() == Ordering::Greater && discriminant.sign() != Ordering::Less;
        real.then_some(Self { a, h, c, discriminant })
    }

    /// Returns the smallest root for which `counts` holds.
    pub(crate) fn smallest_root(self, counts: impl Fn(&ExactLambda) -> bool) -> Option<ExactLambda> {
        let smaller = ExactLambda { quadratic: self, is_larger: false };
        if counts(&smaller) {
            return Some(smaller);
        }
        Some(ExactLambda { is_larger: true, ..smaller }).filter(counts)
    }
}

/// The exact lambda of a hit: one of the roots of a quadratic.
#[derive(Debug)]
pub struct ExactLambda {
    quadratic: ExactQuadratic,
    /// Whether it is the larger root.
    is_larger: bool,
}

impl ExactLambda {
    /// Returns the lambda `numerator / denominator` of a cap, as the double root of a quadratic. Both numbers must be
    /// positive.
    pub(crate) fn fraction(numerator: Dyadic, denominator: Dyadic) -> Self {
        debug_assert!(numerator.sign() == Ordering::Greater && denominator.sign() == Ordering::Greater);
        // Nothing reads `c`, because the numerator of the larger root does not cancel.
        let quadratic =
            ExactQuadratic { a: denominator, h: numerator, c: of_finite(0.0), discriminant: of_finite(0.0) };
        Self { quadratic, is_larger: true }
    }

    /// Whether the lambda is at least `limit`.
    pub(crate) fn is_at_least(&self, limit: &Dyadic) -> bool {
        self.is_linear_form_nonnegative(&-limit, &of_finite(1.0))
    }

    /// Whether `x + y lambda >= 0`.
    pub(crate) fn is_linear_form_nonnegative(&self, x: &Dyadic, y: &Dyadic) -> bool {
        let ExactQuadratic { a, h, discriminant, .. } = &self.quadratic;
        // The form is multiplied by `a`, which is positive. The result is `a x + y h + s y sqrt(D)`, where
        // `s` is -1 for the smaller root and 1 for the larger one.
        sign_with_sqrt(&(&(a * x) + &(y * h)), &self.of_root(y), discriminant) != Ordering::Less
    }

    /// Compares two lambdas.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let (left, right) = (&self.quadratic, &other.quadratic);
        // The difference is multiplied by `a a'`. The result is `a' h - a h' + s a' sqrt(D) - s' a sqrt(D')`, where `s`
        // is -1 for the smaller root and 1 for the larger one.
        let difference = &(&right.a * &left.h) - &(&left.a * &right.h);
        let (of_left, of_right) = (self.of_root(&right.a), -&other.of_root(&left.a));
        sign_with_two_sqrts(&difference, (&of_left, &left.discriminant), (&of_right, &right.discriminant))
    }

    /// Returns `factor` with the sign that `sqrt(D)` has in this root.
    fn of_root(&self, factor: &Dyadic) -> Dyadic {
        if self.is_larger { factor.clone() } else { -factor }
    }

    /// Returns the `f64` nearest to the lambda, or a neighbour of it, but at least [`LAMBDA_MIN`].
    pub(crate) fn rounded(&self) -> f64 {
        let ExactQuadratic { a, h, c, discriminant } = &self.quadratic;
        // f64 must not overflow. So h and sqrt(D) are scaled by a common power of two, and a and c by powers of their
        // own. A zero has no exponent, so it does not change the common power. If h and D are both zero, the root is
        // zero with any power.
        let exponent_of_sqrt = discriminant.top_exponent().map(|exponent| (exponent + 1).div_euclid(2));
        let scale = h.top_exponent().max(exponent_of_sqrt).unwrap_or(0);
        let h = h.to_double_double(-scale);
        let sqrt_d = discriminant.to_double_double(-2 * scale).sqrt();
        let (sum, sqrt_d_is_added) =
            if h.less(DoubleDouble::of(0.0)) { (h - sqrt_d, false) } else { (h + sqrt_d, true) };
        // The numerator of one root does not cancel. The other root follows from the product of both, c / a.
        let (quotient, power) = if sqrt_d_is_added == self.is_larger {
            let (a, exponent) = a.to_fraction_and_power();
            (sum / a, scale - exponent)
        } else {
            let (c, exponent) = c.to_fraction_and_power();
            (c / sum, exponent - scale)
        };
        times_power_of_two(quotient.high, power).max(LAMBDA_MIN)
    }
}
