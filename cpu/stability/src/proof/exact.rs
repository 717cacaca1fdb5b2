//! The margins of the exact intersections: quadratics of spheres and cylinders, and the planes of caps.

use cpu::internals::exact::cylinder::SideLanes;
use cpu::internals::exact::cylinder_parts;
use cpu::internals::exact::sphere_compensated::{ACCURACY_OF_C, CONDITION_LIMIT};
use cpu::internals::exact::{
    error_bound::Limits, error_bound::NUMERATOR_WEIGHT, error_bound::UNDERFLOW, sphere_filter,
};
use cpu::internals::geometry::{ray::LAMBDA_MIN, sphere::SphereRecord};
use cpu::internals::render::hit_lanes::DISCRIMINANT_ERROR;

use super::bounded::{Bounded, begin, compared};
use super::bounds::Arithmetic;
use super::parts::{self, record};
use super::polynomial::Polynomial;
use super::row::{IN_SCALE, Row, U, added, enlarged, family::*, is, length, ray, squared, uses_of_margin};

/// The errors of a quadratic `a lambda^2 - 2 h lambda + c` and of its discriminant, in units of `u`.
struct Quadratic {
    limits: Limits,
    /// The constant in the code for the error of the discriminant, and its file.
    constant: f64,
    file: &'static str,
    /// Relative to `|d|^2` for a sphere, and to `|d| |d'|` for a cylinder, where `d'` is the part of `d` across the
    /// axis: each term of first order has a factor `|d'|`.
    a: f64,
    /// Relative to `|d| |O - C|`.
    h: f64,
    /// Relative to `|O - C|^2`, and to `r^2`.
    c: [f64; 2],
    /// Relative to `M = |d|^2 (|O - C|^2 + r^2)`.
    discriminant: f64,
}

/// Returns the rows of all margins.
#[must_use]
pub fn rows() -> Vec<Row> {
    let sphere = quadratic(sphere_filter::LIMITS, "exact/sphere_filter.rs", sphere);
    let cylinder = quadratic(cylinder_parts::LIMITS, "exact/cylinder_parts.rs", cylinder);
    let [sphere_lambda, side_lambda] = [sphere.lambda(0.0), cylinder.lambda(cylinder.a / 2.0 * 2.0_f64.sqrt())];
    let mut rows = Vec::new();
    for (quadratic, lambda, names) in [
        (&sphere, sphere_lambda, ["discriminant of a sphere", "numerator of a sphere's root", "lambda of a sphere"]),
        (&cylinder, side_lambda, ["discriminant of a cylinder", "numerator of a side's root", "lambda of a side"]),
    ] {
        let Quadratic { limits, constant, file, discriminant, .. } = *quadratic;
        // A third of the margin of lambda is for lambda's own error.
        let of_lambda = limits.lambda_error::<f64>() / 3.0 / U;
        let margins = [
            (constant, discriminant, "u M"),
            (constant, quadratic.numerator(), "u M / sqrt(D)"),
            (of_lambda, lambda, "u lambda"),
        ];
        let named = names.into_iter().zip(margins);
        rows.extend(named.map(|(what, (constant, need, unit))| Row { what, file, constant, need, unit }));
    }
    // As docs/accuracy.md derives, with an error of the discriminant of 10 u times its terms.
    let compensated = (10.0 / 2.0 + sphere.h) * CONDITION_LIMIT + ACCURACY_OF_C + 6.0;
    let (what, file) = ("lambda of a compensated root", "exact/sphere_compensated.rs");
    let constant = sphere.limits.lambda_error::<f64>() / 3.0 / U;
    rows.push(Row { what, file, constant, need: compensated, unit: "u lambda" });
    // A ray is steep enough if `|d|^2 <= 64 k^2 |d'|^2`, with 64 for the constant of the code.
    let steep = cylinder_parts::STEEPNESS.sqrt() * cylinder.limits.condition_limit;
    let constant = cylinder.limits.lambda_error::<f64>() / U;
    let (what, file) = ("a of a steep ray and a side", cylinder.file);
    rows.push(Row { what, file, constant, need: cylinder.a * steep, unit: "u a" });
    let (what, file, constant) = ("all rays miss, in lanes", "render/hit_lanes.rs", DISCRIMINANT_ERROR / U);
    rows.push(Row { what, file, constant, need: cylinder.discriminant, unit: "u M" });
    rows.extend(parts::rows(side_lambda));
    rows
}

impl Quadratic {
    /// Returns what the numerator `n = h -+ sqrt(D)` needs, times `sqrt(D)`, relative to `M`.
    ///
    /// `sqrt(D) <= |d| r` and `sqrt(D) <= sqrt(M)`, up to the error of `D`, which adds less than 10^-5. The error of
    /// `h` times `sqrt(D)` is at most `e |d|^2 |O - C| r <= e M / 2`. The error of the root times `sqrt(D)` is at most
    /// that of `D`, and one rounding. The rounding of the difference is at most `|h| sqrt(D) + D <= (1/2 + 1) M`.
    fn numerator(&self) -> f64 {
        self.discriminant + 1.0 + self.h / 2.0 + 1.5
    }

    /// Returns the largest relative error of an accepted lambda, where `M + w n^2 < k n sqrt(D)` with the
    /// weight `w = 4`.
    ///
    /// The errors of the coefficients move a root by at most `(lambda^2 Ea + 2 lambda Eh + Ec) / (2 sqrt(D))`. Its
    /// evaluation adds `(h^2 + a |c| + D) / (2 sqrt(D)) + sqrt(D) + 2 n` roundings. Relative to lambda, and times `n
    /// sqrt(D)`, the sum is at most `A M + B n sqrt(M) + C n^2`, plus `2 n sqrt(D)`. By the condition it is at most `k`
    /// times the largest value of `(A + B t + C t^2) / (1 + w t^2)`, plus 2.
    ///
    /// `h^2 + a |c| + 3 D` is `4 D <= 4 a r^2` if `c < 0`, and otherwise `2 h^2 + 2 D <= 2 a (|O - C|^2 + r^2)`. For a
    /// cylinder `Ea` is relative to `|d| |d'|`. As `n <= |d'| (|O - C| + r)`, `Ea` adds to `B`, and not to `C`:
    /// `across` is what it adds.
    fn lambda(&self, across: f64) -> f64 {
        let [q, p] = self.c.map(|error| error / 2.0);
        let a = (q + 1.0).max(p + 2.0);
        let (b, c) = if across > 0.0 { (self.h + across, 0.0) } else { (self.h, self.a / 2.0) };
        // The smallest s with A + B t + C t^2 <= s (1 + w t^2) for all t has B^2 = 4 (s - A) (w s - C).
        let w = NUMERATOR_WEIGHT;
        let (sum, product) = (a + c / w, (a * c - b * b / 4.0) / w);
        let largest = (sum + (sum * sum - 4.0 * product).sqrt()) / 2.0;
        largest * self.limits.condition_limit + 2.0
    }
}

/// Returns the errors of the quadratic whose `a`, `h`, `c` and discriminant `run` computes, together with its filter.
fn quadratic(limits: Limits, file: &'static str, run: impl Fn() -> [Bounded; 4]) -> Quadratic {
    begin(Arithmetic::F64, LAMBDA_MIN * limits.lambda_error::<f64>());
    run();
    // Both roots are compared with the smallest lambda from both sides.
    assert_eq!(uses_of_margin(), 4, "{file}: the margin of lambda is not used");
    let margin = limits.error_constant * U;
    begin(Arithmetic::F64, margin);
    let [a, h, c, discriminant] = run();
    let size = squared(DIRECTION).times(&squared(TO_CENTER).plus(&squared(RADIUS)));
    let pairs = compared();
    let [error, _] = pairs.iter().find(|pair| pair[1] == -discriminant).expect("a filter compares the discriminant");
    let relative = |number: Bounded, size: &Polynomial| IN_SCALE.relative(&number.bounds().error, size, margin);
    let c = enlarged(&c.bounds().error);
    let constant = error.bounds().size.coefficient(&Polynomial::constant(1.0));
    assert_eq!(constant, UNDERFLOW, "the error bound covers underflow");
    Quadratic {
        limits,
        constant: added(*error, &size, margin, U),
        file,
        a: relative(a, &squared(DIRECTION)),
        h: relative(h, &length(DIRECTION).times(&length(TO_CENTER))),
        c: [TO_CENTER, RADIUS].map(|family| c.coefficient(&squared(family))),
        discriminant: relative(discriminant, &size),
    }
}

fn sphere() -> [Bounded; 4] {
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    is(center - ray.origin, TO_CENTER);
    let view = SphereRecord::new(center, Bounded::number(RADIUS, 0.0)).seen_from(ray.origin);
    let a = ray.direction.dot(ray.direction);
    let (h, discriminant) = view.quadratic(ray.direction, a);
    _ = sphere_filter::filtered_from(&view, ray.direction, a);
    [a, h, view.c, discriminant]
}

fn cylinder() -> [Bounded; 4] {
    let (ray, record) = (ray(), record());
    is(ray.origin - record.center, TO_CENTER);
    is((ray.origin - record.center).perpendicular_to(record.axis), TO_CENTER_ACROSS);
    is(ray.direction.perpendicular_to(record.axis), DIRECTION_ACROSS);
    let view = record.seen_from(ray.origin);
    let (a, h, discriminant) = record.quadratic(&view, ray.direction);
    _ = SideLanes::new(&record, &view, &ray);
    [a, h, view.c, discriminant]
}
