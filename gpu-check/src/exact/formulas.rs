//! The results that the exact kernels must give, by the functions of `cpu`.

use cpu::internals::exact::error_bound::Decision;
use cpu::internals::exact::order::is_certainly_closer;
use cpu::internals::exact::{cylinder, sphere, sphere_compensated};
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::double_double::DoubleDouble;
use cpu::internals::math::error_free::two_product;
use cpu::internals::math::real::Real;
use cpu::internals::math::rounding::Rounding;
use cpu::{Ray, intersect};

use crate::kernel::Reader;

/// A decision of one of the steps, in the order of the steps. Both parts of a lambda in double-double are compared.
struct Steps {
    plain: Decision<Option<(f64, CylinderPart)>>,
    compensated: Decision<Option<(f64, CylinderPart)>>,
    doubled: Decision<Option<(DoubleDouble, CylinderPart)>>,
}

/// Writes the product of two numbers with its rounding error, and the multiply-add.
pub fn mul_add(case: &[f64], result: &mut [f64]) {
    let mut case = Reader(case);
    let (a, b, c) = (case.number(), case.number(), case.number());
    let (product, error) = two_product(a, b);
    result.copy_from_slice(&[product, error, a.mul_add(b, c)]);
}

/// Writes the answers of all steps for a ray and a sphere.
pub fn sphere(case: &[f64], result: &mut [f64]) {
    let mut case = Reader(case);
    let ray = Ray { origin: case.vector(), direction: case.vector() };
    let record = SphereRecord::new(case.vector(), case.number());
    let compensated = sphere_compensated::compensated(&record, &ray);
    let precise = SphereRecord::new(record.center.map(DoubleDouble::of), DoubleDouble::of(record.radius));
    let steps = Steps {
        plain: on_the_side(sphere::filtered(&record, &ray)),
        compensated: on_the_side(compensated),
        doubled: on_the_side(sphere::filtered(&precise, &ray.lanes())),
    };
    let answer = || intersect::sphere(&record, &ray).map(|lambda| (lambda, CylinderPart::Side));
    write(&steps, answer, result);
}

/// Writes the answers of all steps for a ray and a cylinder.
pub fn cylinder(case: &[f64], result: &mut [f64]) {
    let mut case = Reader(case);
    let ray = Ray { origin: case.vector(), direction: case.vector() };
    let (center, radius, axis) = (case.vector(), case.number(), case.vector());
    let record = CylinderRecord::new(center, radius, axis);
    let of = DoubleDouble::of;
    let precise = CylinderRecord::new(center.map(of), of(radius), axis.map(of));
    let steps = Steps {
        plain: cylinder::filtered(&record, &ray),
        compensated: cylinder::compensated(&record, &axis, &ray),
        doubled: cylinder::filtered(&precise, &ray.lanes()),
    };
    write(&steps, || intersect::cylinder(&record, &axis, &ray), result);
}

/// Writes which of two spheres a ray hits first, by the two steps that compare lambdas: 1 or 2, or 0 if that is
/// uncertain. It writes 3 if the step does not find two hits.
pub fn order(case: &[f64], result: &mut [f64]) {
    let mut case = Reader(case);
    let ray = Ray { origin: case.vector(), direction: case.vector() };
    let spheres = [(); 2].map(|()| SphereRecord::new(case.vector(), case.number()));
    let of = DoubleDouble::of;
    let precise = spheres.map(|sphere| SphereRecord::new(sphere.center.map(of), of(sphere.radius)));
    result[0] = closer(spheres.map(|sphere| sphere::filtered(&sphere, &ray)));
    result[1] = closer(precise.map(|sphere| sphere::filtered(&sphere, &ray.lanes())));
}

fn closer<T: Rounding<Mask = bool>>(hits: [Decision<Option<T>>; 2]) -> f64 {
    match hits {
        [Decision::Certain(Some(first)), Decision::Certain(Some(second))] => {
            match [is_certainly_closer(first, second), is_certainly_closer(second, first)] {
                [true, _] => 1.0,
                [_, true] => 2.0,
                _ => 0.0,
            }
        }
        _ => 3.0,
    }
}

fn on_the_side<T>(decision: Decision<Option<T>>) -> Decision<Option<(T, CylinderPart)>> {
    match decision {
        Decision::Certain(hit) => Decision::Certain(hit.map(|lambda| (lambda, CylinderPart::Side))),
        Decision::Uncertain => Decision::Uncertain,
    }
}

/// Writes a report. If a step is certain, `answer` is called for the result of the function that the programs call.
fn write(steps: &Steps, answer: impl Fn() -> Option<(f64, CylinderPart)>, result: &mut [f64]) {
    let certain = [
        steps.plain != Decision::Uncertain,
        steps.compensated != Decision::Uncertain,
        steps.doubled != Decision::Uncertain,
    ];
    let step = certain.into_iter().position(|certain| certain).map_or(0, |index| index + 1);
    let hit = if step == 0 { None } else { answer() };
    let (lambda, part) = hit.map_or((0.0, 0.0), |(lambda, part)| (lambda, f64::from(part as u32)));
    result[..4].copy_from_slice(&[step as f64, f64::from(u8::from(hit.is_some())), lambda, part]);
    let (plain, compensated, doubled) = (code(&steps.plain), code(&steps.compensated), code(&steps.doubled));
    let of = |lambda: Option<DoubleDouble>| lambda.unwrap_or_default();
    result[4..].copy_from_slice(&[
        plain.0,
        plain.1.unwrap_or(0.0),
        compensated.0,
        compensated.1.unwrap_or(0.0),
        doubled.0,
        of(doubled.1).high,
        of(doubled.1).low,
    ]);
}

/// Returns the number of `exact_code` in `kernels/exact_report.wgsl` for a decision, and the lambda of a hit.
fn code<T: Copy>(decision: &Decision<Option<(T, CylinderPart)>>) -> (f64, Option<T>) {
    match decision {
        Decision::Uncertain => (0.0, None),
        Decision::Certain(None) => (1.0, None),
        Decision::Certain(Some((lambda, part))) => (2.0 + f64::from(*part as u32), Some(*lambda)),
    }
}
