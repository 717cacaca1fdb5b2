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
mod tests {
    use super::*;
    use crate::exact::sphere::precise;
    use crate::math::vec3::Vec3;
    use crate::sampling::uniform::Uniform;

    /// Returns a sphere of this radius and a ray that starts near the origin. The sphere's surface passes near the
    /// origin, or the sphere is far, and the ray is aimed near its rim.
    fn case(radius: f64, number: usize, draws: &mut Uniform) -> (SphereRecord, Ray) {
        let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
        let (mut origin, direction, up) = (vector() * 10.0, vector(), vector().unit());
        let center = match number % 5 {
            0 => Vec3::new(radius, 0.0, 0.0),
            1 => Vec3::new(0.0, -radius, 0.0),
            2 => Vec3::new(0.0, 0.0, radius),
            3 => up * radius,
            _ => origin + direction * (radius * 1e9) + direction.cross(up).unit() * (radius * 0.999_999_999),
        };
        if number.is_multiple_of(2) {
            origin = origin * 1e-17;
        }
        (SphereRecord::new(center, radius), Ray { origin, direction })
    }

    #[test]
    fn what_is_certain_is_the_precise_answer_to_the_last_bit() {
        let mut draws = Uniform::new(23);
        let (mut certain, mut hits, mut all) = (0, 0, 0);
        for exponent in [-250, -100, -9, 0, 1, 3, 9, 15, 18, 30, 70, 140, 160, 250, 299, 307] {
            for number in 0..1000 {
                let (record, mut ray) = case(10.0_f64.powi(exponent), number, &mut draws);
                if number % 7 == 0 {
                    ray.direction = ray.direction * 10.0_f64.powf(draws.draw(-60.0, 60.0));
                }
                all += 1;
                if let Decision::Certain(hit) = wide(&record, &ray) {
                    assert_eq!(hit, precise(&record, &ray), "{record:?}, {ray:?}");
                    certain += 1;
                    hits += usize::from(hit.is_some());
                }
            }
        }
        assert!(certain * 10 > all * 7 && hits * 10 > certain * 3, "{hits} of {certain} of {all}");
    }

    #[test]
    fn a_root_is_certain_only_if_no_midpoint_is_within_its_error() {
        let power = |exponent: i64| times_power_of_two(1.0, exponent);
        // The midpoints between 1 and its neighbours, less 1. Each error comes from another number.
        for midpoint in [power(-53), -power(-54)] {
            for (of_dividend, of_divisor) in [(power(-80), 0.0), (0.0, power(-80)), (0.0, 0.0)] {
                for (scale, share) in
                    [1.0, power(-9), power(60)].into_iter().flat_map(|scale| [(scale, 0.5), (scale, 2.0)])
                {
                    let error = 2.0 * (of_dividend + of_divisor + WIDE_ERROR);
                    let low = midpoint - midpoint.signum() * share * error;
                    let dividend = Bounded { value: DoubleDouble { high: 1.0, low }, error_bound: of_dividend };
                    let divisor = Bounded { value: DoubleDouble::of(1.0), error_bound: of_divisor };
                    let is_certain = matches!(dividend.root(divisor, scale), Root::Hits(lambda) if lambda == scale);
                    assert_eq!(is_certain, share > 1.0, "{midpoint:e}, {of_dividend:e}, {of_divisor:e}, {scale:e}");
                }
            }
        }
    }

    #[test]
    fn a_root_fails_only_if_it_certainly_rounds_to_less_than_the_limit() {
        let root = |value: f64, error_bound: f64| {
            Bounded { value: DoubleDouble::of(value), error_bound }
                .root(Bounded::of_size(DoubleDouble::of(1.0), 0.0), 1.0)
        };
        assert!(matches!(root(LAMBDA_MIN.next_down().next_down(), 0.0), Root::Fails));
        assert!(matches!(root(LAMBDA_MIN.next_down(), 0.0), Root::Uncertain));
        assert!(matches!(root(LAMBDA_MIN, 0.0), Root::Hits(LAMBDA_MIN)));
        assert!(matches!(root(LAMBDA_MIN / 2.0, LAMBDA_MIN / 5.0), Root::Fails));
        assert!(matches!(root(LAMBDA_MIN / 2.0, LAMBDA_MIN / 3.0), Root::Uncertain));
        assert!(matches!(root(-1.0, 0.0), Root::Fails));
        assert!(matches!(root(f64::INFINITY, 0.0), Root::Uncertain));
    }

    #[test]
    fn most_rays_above_a_ground_of_any_radius_are_certain() {
        let mut draws = Uniform::new(5);
        for radius in [1e12, 1e18, 1e30, 1e100, 1e200, 1e300] {
            for on_or_off_axis in [1, 3] {
                let cases = (0..1000).map(|_| case(radius, on_or_off_axis, &mut draws));
                let certain = cases.filter(|(record, ray)| wide(record, ray) != Decision::Uncertain).count();
                assert!(certain > 990, "{radius:e}: {certain}");
            }
        }
    }

    #[test]
    fn what_touches_or_has_no_number_is_uncertain() {
        let along = |x: f64, length: f64| Ray { origin: Vec3::ZERO, direction: Vec3::new(x, 0.0, length) };
        let touching = SphereRecord::new(Vec3::new(1.0, 0.0, 5.0), 1.0);
        let limit = SphereRecord::new(Vec3::new(0.0, 0.0, 1.0 + LAMBDA_MIN), 1.0);
        assert_eq!(wide(&touching, &along(0.0, 1.0)), Decision::Uncertain);
        assert_eq!(wide(&limit, &along(0.0, 1.0)), Decision::Certain(precise(&limit, &along(0.0, 1.0))));
        for length in [0.0, 1e-60, 1e60, f64::INFINITY, f64::NAN] {
            assert_eq!(wide(&touching, &along(0.0, length)), Decision::Uncertain, "{length}");
        }
        let endless = SphereRecord::new(Vec3::new(0.0, 0.0, f64::MAX), f64::INFINITY);
        assert_eq!(wide(&endless, &along(0.1, 1.0)), Decision::Uncertain);
        let from_nowhere = Ray { origin: Vec3::new(f64::INFINITY, 0.0, 0.0), direction: Vec3::new(0.0, 1.0, 0.0) };
        assert_eq!(wide(&touching, &from_nowhere), Decision::Uncertain);
    }
}
