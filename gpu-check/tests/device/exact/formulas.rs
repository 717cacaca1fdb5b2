//! The results that the exact kernels must give, by the functions of `cpu`.

use cpu::internals::exact::error_bound::Decision;
use cpu::internals::exact::order::is_certainly_closer;
use cpu::internals::exact::{cylinder, sphere, sphere_compensated};
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::error_free::two_product;
use cpu::intersect;

use gpu_check::reader::Reader;

/// The lambda and the part of a hit, or `None` for a miss.
type Hit = Option<(f64, CylinderPart)>;

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
    let ray = case.ray();
    let record = SphereRecord::new(case.vector(), case.number());
    let plain = on_the_side(sphere::filtered(&record, &ray));
    let compensated = on_the_side(sphere_compensated::compensated(&record, &ray));
    let answer = || intersect::sphere(&record, &ray).map(|lambda| (lambda, CylinderPart::Side));
    write(&plain, &compensated, answer, result);
}

/// Writes the answers of all steps for a ray and a cylinder.
pub fn cylinder(case: &[f64], result: &mut [f64]) {
    let mut case = Reader(case);
    let ray = case.ray();
    let (center, radius, axis) = (case.vector(), case.number(), case.vector());
    let record = CylinderRecord::new(center, radius, axis);
    let (plain, compensated) = (cylinder::filtered(&record, &ray), cylinder::compensated(&record, &axis, &ray));
    write(&plain, &compensated, || intersect::cylinder(&record, &axis, &ray), result);
}

/// Writes which of two spheres a ray hits first, by the lambdas of the plain formula: 1 or 2, or 0 if that is
/// uncertain. It writes 3 if the formula does not find two hits.
pub fn order(case: &[f64], result: &mut [f64]) {
    let mut case = Reader(case);
    let ray = case.ray();
    let spheres = [(); 2].map(|()| SphereRecord::new(case.vector(), case.number()));
    result[0] = match spheres.map(|sphere| sphere::filtered(&sphere, &ray)) {
        [Decision::Certain(Some(first)), Decision::Certain(Some(second))] => {
            match [is_certainly_closer(first, second), is_certainly_closer(second, first)] {
                [true, _] => 1.0,
                [_, true] => 2.0,
                _ => 0.0,
            }
        }
        _ => 3.0,
    };
}

fn on_the_side(decision: Decision<Option<f64>>) -> Decision<Hit> {
    match decision {
        Decision::Certain(hit) => Decision::Certain(hit.map(|lambda| (lambda, CylinderPart::Side))),
        Decision::Uncertain => Decision::Uncertain,
    }
}

/// Writes a report. If a step is certain, `answer` is called for the result of the function that the programs call.
fn write(plain: &Decision<Hit>, compensated: &Decision<Hit>, answer: impl Fn() -> Hit, result: &mut [f64]) {
    let step = match (plain, compensated) {
        (Decision::Certain(_), _) => 1.0,
        (_, Decision::Certain(_)) => 2.0,
        _ => 0.0,
    };
    let hit = if step == 0.0 { None } else { answer() };
    let (lambda, part) = hit.map_or((0.0, 0.0), |(lambda, part)| (lambda, f64::from(part as u32)));
    result[..4].copy_from_slice(&[step, f64::from(u8::from(hit.is_some())), lambda, part]);
    result[4..6].copy_from_slice(&code(plain));
    result[6..].copy_from_slice(&code(compensated));
}

/// Returns the number of `exact_code` in `kernels/exact_report.wgsl` for a decision, and the lambda of a hit or 0.
fn code(decision: &Decision<Hit>) -> [f64; 2] {
    match decision {
        Decision::Uncertain => [0.0, 0.0],
        Decision::Certain(None) => [1.0, 0.0],
        Decision::Certain(Some((lambda, part))) => [2.0 + f64::from(*part as u32), *lambda],
    }
}
