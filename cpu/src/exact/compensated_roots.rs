//! The roots of the quadratic `a lambda^2 - 2 h lambda + c` of a ray and a surface, by formulas in which less cancels
//! than in the plain ones. Spheres and the sides of cylinders use them. The discriminant is `D = h^2 - a c`.
//!
//! If the ray starts near the surface, one of the roots `(h -+ sqrt(D)) / a` cancels. With `w = |h| + sqrt(D)`, which
//! does not, the roots are `w / a` and `c / w`, both with the sign of `h`. Only `c` still cancels. So its products and
//! sums are computed together with their rounding errors (Ogita, Rump and Oishi, "Accurate sum and dot product", SIAM
//! J. Sci. Comput. 26, 2005).
//!
//! If the surface is far away, `h^2 - a c` is the small difference of two large numbers. Each shape has another formula
//! for it. The bounds are derived in `docs/accuracy.md`.

use crate::exact::{error_bound::OVERFLOW, error_bound::UNDERFLOW, sphere_filter::SPHERE_BOUND};
use crate::geometry::ray::LAMBDA_MIN;
use crate::math::error_free::{two_product, two_sum};
use crate::math::{rounding::Rounding, vec3::Vec3};

/// Limits the relative error of lambda to 4.6e-12. A root is accepted only if the [terms](Discriminant::size) of `D`
/// are below `CONDITION_LIMIT w sqrt(D)`, and those of `h` below `CONDITION_LIMIT w`.
pub const CONDITION_LIMIT: f64 = 4096.0;
/// The bound of the error of `c`, in units of `u^2` and its [terms](Quadratic::size_of_c), beside one rounding of `c`.
/// `u` is the unit roundoff.
pub const ERROR_OF_C: f64 = 64.0;
/// The largest relative error of `c` with which its root is accepted, in units of `u`.
pub const ACCURACY_OF_C: f64 = 4096.0;

/// The coefficients of the quadratic.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<T> {
    /// The coefficient of `lambda^2`.
    pub a: T,
    /// Half of the negative linear coefficient.
    pub h: T,
    /// The constant coefficient, which is negative if the ray starts inside.
    pub c: T,
    /// The size of the terms of `c`.
    pub size_of_c: T,
    /// The size of the terms of `h`.
    pub size_of_h: T,
}

/// A discriminant, and the size of its terms. Its error is at most the error constant of spheres times `u` and the
/// size.
#[derive(Clone, Copy, Debug)]
pub struct Discriminant<T> {
    /// The discriminant.
    pub value: T,
    /// The size of its terms.
    pub size: T,
}

/// What is certain about the two roots. One is `w / a` with the sign of `h`, and is called the large one. The other is
/// `|c| / w` with the sign of `h c`, and is called the small one.
pub struct Roots<T: Rounding> {
    /// `|h| + sqrt(D)`.
    pub w: T,
    /// The size of the terms of `w`, relative to `w`.
    pub condition: T,
    /// The bound of the error of `c` that is not relative to `c`.
    pub error_bound_of_c: T,
    /// The ray's line misses the surface.
    pub misses: T::Mask,
    /// Both magnitudes are accurate, but for the error of `c`.
    pub accurate: T::Mask,
    /// The small root is positive and accurate.
    pub small_is_ahead: T::Mask,
    /// The small root is below [`LAMBDA_MIN`].
    pub small_fails: T::Mask,
    /// The large root is, which includes every negative one.
    pub large_fails: T::Mask,
}

/// Bounds the error of a root, as a multiple of `u lambda` and of the [condition](Roots::condition). It is twice the
/// error or more.
pub const ERROR_OF_ROOT: f64 = 64.0;

impl<T: Rounding> Roots<T> {
    /// Returns the magnitudes of the small and of the large root of `quadratic`, each with twice the bound of its
    /// error.
    #[inline(always)]
    pub(crate) fn magnitudes(&self, &Quadratic { a, c, .. }: &Quadratic<T>) -> [(T, T); 2] {
        let relative = self.condition * T::of(ERROR_OF_ROOT * T::UNIT_ROUNDOFF);
        let (small, large) = (c.abs() / self.w, self.w / a);
        let of_c = (self.error_bound_of_c + self.error_bound_of_c) / self.w;
        [(small, small * relative + of_c), (large, large * relative)]
    }
}

impl<T: Rounding> Quadratic<T> {
    /// Returns `h^2 - a c`, which is accurate if the ray starts near the surface.
    #[inline(always)]
    pub fn near(&self) -> Discriminant<T> {
        let &Self { a, h, c, size_of_c, size_of_h } = self;
        // The size is multiplied by `u` later, so this is the error of `c` divided by `u`.
        let lost = size_of_c * T::of(ERROR_OF_C * T::UNIT_ROUNDOFF);
        Discriminant { value: h * h - a * c, size: h.abs() * size_of_h + a * (c.abs() + lost) }
    }

    /// Returns the bound of the error of `c` that is not relative to `c`.
    #[inline(always)]
    fn error_bound_of_c(&self) -> T {
        self.size_of_c * T::of(ERROR_OF_C * T::UNIT_ROUNDOFF * T::UNIT_ROUNDOFF) + T::of(UNDERFLOW)
    }

    /// Whether the ray certainly moves away from the surface: it starts near the surface and not towards the middle, so
    /// both roots are below [`LAMBDA_MIN`]. This needs no discriminant. The direction must be in scale.
    ///
    /// The error of `h` is at most `4 u CONDITION_LIMIT |h|`, so the exact `h` is negative too, and `w / a` is a
    /// negative root. The other root is at most `|c| / |h|`, because `w` is at least `|h|`. If `size_of_h` underflows,
    /// the sign of `h` is not known, but then every lambda is below 2^-200.
    #[inline(always)]
    pub fn moves_away(&self) -> T::Mask {
        let (backward, size) = (self.h.less(T::of(0.0)), self.h.abs());
        let h_is_accurate = self.size_of_h.less(size * T::of(CONDITION_LIMIT));
        backward & h_is_accurate & (self.c.abs() + self.error_bound_of_c()).less(size * lowered_lambda_min())
    }

    /// Returns what is certain about the roots with this discriminant, for any number of lanes.
    #[inline(always)]
    pub fn roots(&self, Discriminant { value, size }: Discriminant<T>) -> Roots<T> {
        let sqrt_d = value.sqrt();
        let w = self.h.abs() + sqrt_d;
        let error_bound = size * T::of(SPHERE_BOUND.error_constant * T::UNIT_ROUNDOFF) + T::of(UNDERFLOW);
        let h_is_accurate = self.size_of_h.less(w * T::of(CONDITION_LIMIT));
        let sqrt_d_is_accurate = error_bound.less(value) & size.less(sqrt_d * w * T::of(CONDITION_LIMIT));
        let accurate = h_is_accurate & sqrt_d_is_accurate & size.less(T::of(OVERFLOW));
        let error_bound_of_c = self.error_bound_of_c();
        let c_is_accurate = (error_bound_of_c * T::of(1.0 / (ACCURACY_OF_C * T::UNIT_ROUNDOFF))).less(self.c.abs());
        let lowered_lambda_min = lowered_lambda_min::<T>();
        // A zero `h` counts as positive: a ray from the middle has two roots of the same size.
        let (backward, zero) = (self.h.less(T::of(0.0)), T::of(0.0));
        let signed_c = T::select(backward, -self.c, self.c);
        Roots {
            w,
            condition: (size / sqrt_d + self.size_of_h) / w,
            error_bound_of_c,
            misses: error_bound.less(-value),
            accurate,
            small_is_ahead: c_is_accurate & zero.less(signed_c),
            small_fails: (c_is_accurate & signed_c.less(zero))
                | (self.c.abs() + error_bound_of_c).less(w * lowered_lambda_min),
            large_fails: backward | w.less(self.a * lowered_lambda_min),
        }
    }
}

/// Returns `|q|^2 - s`, as accurate as if it were computed with twice the digits and then rounded, and `|q|^2 + s` with
/// the usual accuracy. `q` and `s` are given rounded, each with its error.
#[inline(always)]
pub(crate) fn difference_of_squares<T: Rounding>((q, q_error): (Vec3<T>, Vec3<T>), (s, s_error): (T, T)) -> (T, T) {
    let (xx, xx_error) = two_product(q.x, q.x);
    let (yy, yy_error) = two_product(q.y, q.y);
    let (zz, zz_error) = two_product(q.z, q.z);
    // The processor can overlap these two sums.
    let ((first, first_error), (second, second_error)) = (two_sum(xx, yy), two_sum(zz, -s));
    let (difference, third_error) = two_sum(first, second);
    let across = q.x.mul_add(q_error.x, q.y.mul_add(q_error.y, q.z * q_error.z));
    let error =
        (first_error + second_error + third_error) + ((xx_error + yy_error) + (zz_error - s_error)) + (across + across);
    (difference + error, (xx + yy) + (zz + s))
}

/// Returns [`LAMBDA_MIN`], lowered by more than the error of a lambda. So if a computed lambda is below it, the exact
/// one is below [`LAMBDA_MIN`].
#[inline(always)]
fn lowered_lambda_min<T: Rounding>() -> T {
    T::of(LAMBDA_MIN) - T::of(LAMBDA_MIN * SPHERE_BOUND.lambda_error())
}

/// Whether an accurate lambda certainly is in range, and has not overflowed.
#[inline(always)]
pub(crate) fn certainly_in_range_and_finite<T: Rounding>(lambda: T) -> T::Mask {
    SPHERE_BOUND.certainly_in_range(lambda) & lambda.less(T::of(OVERFLOW))
}
