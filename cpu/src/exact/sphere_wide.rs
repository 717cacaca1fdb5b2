//! Intersects ray and sphere in [double-double](DoubleDouble) arithmetic. It serves spheres that are so large or so far
//! away that the [compensated](crate::exact::sphere_compensated) formulas are uncertain about most rays. It takes
//! less time than dyadic arithmetic, because its numbers have a fixed size.
//!
//! With `m` for the component of `C - O` of largest magnitude, and `p` and `q` for the others, the constant coefficient
//! is `c = (|m| - r) (|m| + r) + p^2 + q^2`. Components of `C - O` are held without a rounding error, as two numbers
//! each, and the first difference cancels before it is multiplied. So the error of `c` is relative to these terms, not
//! to `r^2`. They are small if the ray starts near a ground of any radius. Where they cancel too, as on a huge sphere
//! off the axes, all products are added without a rounding error.
//!
//! A lambda counts only if all numbers within its error round to one `f64`. So this step never changes the result.

use crate::exact::{error_bound::Decision, error_bound::UNDERFLOW, error_bound::in_scale};
use crate::geometry::{ray::LAMBDA_MIN, ray::Ray, sphere::SphereRecord};
use crate::math::{double_double::DoubleDouble, dyadic::times_power_of_two, error_free::vector_difference};
use crate::math::{exact_sum::ExactSum, real::Real, vec3::Vec3};

/// Bounds the errors of the coefficients and of the discriminant, relative to the sizes of their terms: 2^-96.
pub const WIDE_ERROR: f64 = f64::from_bits((1023 - 96) << 52);
/// If a component of `C - O` or the radius is at least this, 2^200, the equation is scaled, so that no square of a
/// number below 2^1022 overflows. What overflows becomes NaN, and is uncertain.
const LARGE: f64 = f64::from_bits((1023 + 200) << 52);

/// A number with a bound of its error.
#[derive(Clone, Copy)]
struct Bounded {
    value: DoubleDouble,
    error_bound: f64,
}

/// What is certain about a root.
enum Root {
    /// The `f64` nearest to a root that is in range.
    Hits(f64),
    /// The root is too small.
    Fails,
    Uncertain,
}

impl Bounded {
    /// Returns a number whose error is relative to the size of its terms, but for underflow.
    #[inline(always)]
    fn of_size(value: DoubleDouble, size: f64) -> Self {
        Self { value, error_bound: size * WIDE_ERROR + UNDERFLOW }
    }

    /// Returns the lambda `self / divisor`. The error of the divisor must be at most a quarter of it.
    #[inline(always)]
    fn root(self, divisor: Self, scale: f64) -> Root {
        let DoubleDouble { high, low } = self.value / divisor.value;
        let relative = divisor.error_bound / divisor.value.high.abs() + WIDE_ERROR;
        let error_bound = 2.0 * (self.error_bound / divisor.value.high.abs() + high.abs() * relative);
        let (high, low, error_bound) = (high * scale, low * scale, error_bound * scale);
        // A lambda that rounds to the limit is not below it; see `HALF_STEP`.
        if high + error_bound < LAMBDA_MIN.next_down() {
            Root::Fails
        } else if (LAMBDA_MIN..f64::INFINITY).contains(&high)
            && high + (low + error_bound) == high + (low - error_bound)
        {
            Root::Hits(high)
        } else {
            Root::Uncertain
        }
    }
}

/// The equation `a lambda^2 - 2 h lambda + c = 0` times `scale`, a power of two. `h` and `c` are held so multiplied.
/// `a` is not, because it might underflow.
struct Equation {
    a: DoubleDouble,
    h: Bounded,
    size_of_h: f64,
    scale: f64,
}

impl Equation {
    /// Returns the hit for this value of `c`, whose error is relative to `size_of_c`, but for underflow.
    #[inline(always)]
    fn hit(&self, c: DoubleDouble, size_of_c: f64) -> Decision<Option<f64>> {
        let &Self { a, h, size_of_h, scale } = self;
        let c = Bounded::of_size(c, size_of_c);
        let product = a * (c.value * DoubleDouble::of(scale));
        let size_of_d = (h.value.high.abs() + WIDE_ERROR * size_of_h) * size_of_h
            + a.high * (size_of_c * scale)
            + h.value.high.powi(2);
        let d = Bounded::of_size(h.value * h.value - product, 4.0 * size_of_d);
        if d.value.high < -d.error_bound {
            return Decision::Certain(None);
        }
        let sqrt_d = d.value.sqrt();
        let (sum, is_backward) = match h.value.high < 0.0 {
            true => (h.value - sqrt_d, true),
            false => (h.value + sqrt_d, false),
        };
        let error_bound = h.error_bound + d.error_bound / sqrt_d.high + WIDE_ERROR * sum.high.abs();
        let sum = Bounded { value: sum, error_bound };
        // Also refuses what has overflowed or is NaN.
        if !(d.error_bound < d.value.high * 0.25 && sum.error_bound < sum.value.high.abs() * 0.25) {
            return Decision::Uncertain;
        }
        let (of_sum, of_c) = (sum.root(Bounded::of_size(a, a.high), 1.0 / scale), c.root(sum, 1.0));
        let (smaller, larger) = if is_backward { (of_sum, of_c) } else { (of_c, of_sum) };
        match (smaller, larger) {
            (Root::Hits(lambda), _) | (Root::Fails, Root::Hits(lambda)) => Decision::Certain(Some(lambda)),
            (Root::Fails, Root::Fails) => Decision::Certain(None),
            _ => Decision::Uncertain,
        }
    }
}

/// Returns the hit of a ray, or `None` for a miss, if rounding certainly has not changed it.
#[inline(always)]
pub(crate) fn wide(record: &SphereRecord, ray: &Ray) -> Decision<Option<f64>> {
    let of = DoubleDouble::of;
    let (high, low) = vector_difference(record.center, ray.origin);
    let [mut m, mut p, mut q] = [(high.x, low.x), (high.y, low.y), (high.z, low.z)];
    let largest = high.x.abs().max(high.y.abs()).max(high.z.abs());
    if q.0.abs() == largest {
        (m, q) = (q, m);
    } else if p.0.abs() == largest {
        (m, p) = (p, m);
    }
    // This power of two is 1 for most spheres.
    let scale = match largest.max(record.radius) {
        size if size < LARGE => 1.0,
        size => times_power_of_two(1.0, -(((size.to_bits() >> 52) & 0x7FF) as i64 - 1023)),
    };
    let scaled = |(high, low): (f64, f64)| DoubleDouble { high: high * scale, low: low * scale };
    let [x, y, z] = ray.direction.map(of).to_array();
    let a = x * x + y * y + z * z;
    if !in_scale(a.high) {
        return Decision::Uncertain;
    }
    let [along_x, along_y, along_z] =
        [x * scaled((high.x, low.x)), y * scaled((high.y, low.y)), z * scaled((high.z, low.z))];
    let size_of_h = along_x.high.abs() + along_y.high.abs() + along_z.high.abs();
    let h = Bounded::of_size(along_x + along_y + along_z, size_of_h);
    let equation = Equation { a, h, size_of_h, scale };
    let (outward, radius) = (DoubleDouble { high: m.0, low: m.1 }.abs(), of(record.radius));
    let both = scaled((outward.high, outward.low)) + of(record.radius * scale);
    let [first, second, third] = [(outward - radius) * both, square(p, scaled(p)), square(q, scaled(q))];
    let decision = equation.hit(first + (second + third), first.high.abs() + second.high + third.high);
    if decision != Decision::Uncertain {
        return decision;
    }
    let c = exact_c((high, low), record.radius, scale);
    equation.hit(c, c.high.abs())
}

/// Returns the product of a number and the same number times a power of two.
#[inline(always)]
fn square((high, low): (f64, f64), scaled: DoubleDouble) -> DoubleDouble {
    DoubleDouble { high, low } * scaled
}

/// Returns `|C - O|^2 - r^2` times the power of two `scale`, from the two parts of `C - O`. Its relative error is that
/// of [`ExactSum::rounded`], but for underflow.
#[inline(always)]
fn exact_c((high, low): (Vec3, Vec3), radius: f64, scale: f64) -> DoubleDouble {
    // Ten products and their rounding errors.
    let mut sum = ExactSum::<20>::new();
    for (high, low) in high.to_array().into_iter().zip(low.to_array()) {
        sum.add_product(low * scale, low);
        sum.add_product(high * scale, 2.0 * low);
        sum.add_product(high * scale, high);
    }
    sum.add_product(radius * scale, -radius);
    sum.rounded()
}

#[cfg(test)]
mod tests;
