//! The margins of the exact intersections: quadratics of spheres and cylinders, and the planes of caps.

use cpu::internals::exact::cylinder::SideLanes;
use cpu::internals::exact::cylinder_parts;
use cpu::internals::exact::sphere_compensated::{ACCURACY_OF_C, CONDITION_LIMIT};
use cpu::internals::exact::{error_bound::Limits, error_bound::UNDERFLOW, sphere_filter};
use cpu::internals::geometry::{ray::LAMBDA_MIN, sphere::SphereRecord};
use cpu::internals::render::hit_lanes::DISCRIMINANT_ERROR;

use super::bounded::{Bounded, begin, compared};
use super::bounds::Arithmetic;
use super::compensated;
use super::parts::{self, record};
use super::polynomial::Polynomial;
use super::quadratic::Quadratic;
use super::row::{IN_SCALE, Row, U, added, enlarged, family::*, is, length, ray, squared, uses_of_margin};

/// Returns the rows of all margins.
#[must_use]
pub fn rows() -> Vec<Row> {
    let sphere = quadratic(sphere_filter::LIMITS, "exact/sphere_filter.rs", sphere);
    let cylinder = quadratic(cylinder_parts::LIMITS, "exact/cylinder_parts.rs", cylinder);
    let compensated = compensated::side();
    let [sphere_lambda, side_lambda] = [sphere.lambda(0.0), cylinder.lambda(cylinder.a / 2.0 * 2.0_f64.sqrt())];
    let mut rows = Vec::new();
    for (quadratic, lambda, names) in [
        (&sphere, sphere_lambda, ["discriminant of a sphere", "numerator of a sphere's root", "lambda of a sphere"]),
        (&cylinder, side_lambda, ["discriminant of a cylinder", "numerator of a side's root", "lambda of a side"]),
        (
            &compensated,
            compensated.lambda(0.0),
            [
                "discriminant of a side, compensated",
                "numerator of a side's root, compensated",
                "lambda of a side, compensated",
            ],
        ),
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
    let of_sphere = compensated::sphere_rows();
    // As docs/accuracy.md derives. The discriminant exceeds the error that the code takes, so its root is far above 0.
    let [c, near, far] = of_sphere.each_ref().map(|row| row.need / row.constant);
    let error_constant = sphere_filter::LIMITS.error_constant;
    let of_root = near.max(far) * error_constant / (1.0 + (1.0 - near.max(far)).sqrt());
    let compensated = (of_root + sphere.h) * CONDITION_LIMIT + c * ACCURACY_OF_C + 6.0;
    let (what, file) = ("lambda of a compensated root", "exact/sphere_compensated.rs");
    let constant = sphere.limits.lambda_error::<f64>() / 3.0 / U;
    rows.push(Row { what, file, constant, need: compensated, unit: "u lambda" });
    rows.extend(of_sphere);
    rows.push(compensated::plane());
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

/// Returns the errors of the quadratic whose `a`, `h`, `c` and discriminant `run` computes, together with its filter.
fn quadratic(limits: Limits, file: &'static str, run: impl Fn() -> [Bounded; 4]) -> Quadratic {
    begin(Arithmetic::F64, LAMBDA_MIN * limits.lambda_error::<f64>());
    run();
    // Both roots are compared with the smallest lambda from both sides.
    assert_eq!(uses_of_margin(), 4, "{file}: the margin of lambda is not used, or on the wrong side");
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
