//! Compares the exact intersections in WGSL with those of `cpu`: for every ray the decision of each step, and the bits
//! of its lambda.
//!
//! The programs intersect by a plain formula with an error bound, then by a compensated formula, and then in more
//! digits. The first two steps exist in WGSL too (`shaders/wgsl/exact`). A kernel computes both for every ray, also
//! if the first one is certain. If both are uncertain, the kernel reports that, and the comparison demands that exactly
//! these rays are uncertain in Rust. It needs f64: in f32 the constants of the bounds have no proof.
//!
//! `RENDER_CASES` sets the number of cases of each kind.

mod rays;

use cpu::internals::exact::error_bound::Decision;
use cpu::internals::exact::order::is_certainly_closer;
use cpu::internals::math::error_free::two_product;
use gpu_check::first_difference::twins::{Numbers, Twin};
use gpu_check::reader::Reader;
use shaders::Library;
use stability::record::{Found, Record};
use test_support::number_of;

use crate::common;
use crate::kernels::kernel::Kernel;
use crate::kernels::{cylinder, sphere};

/// Number of cases of each kind, unless the variable sets another one.
const CASES: usize = 20_000;

/// Returns the exact kernels: the product and sum with one rounding (fused multiply-add) and products with their
/// rounding errors, the intersections with a sphere and with a cylinder, and which of two spheres a ray hits first.
pub fn all() -> [Kernel<f64>; 4] {
    let of = |module, inputs, twin: Twin<f64>, cases| Kernel { module, inputs, twin, cases };
    [
        of("kernels/mul_add", 3, |_, row| mul_add(row), rays::products),
        of("kernels/exact_sphere", 10, |_, row| steps(row, sphere), rays::spheres),
        of("kernels/exact_cylinder", 13, |_, row| steps(row, cylinder), rays::cylinders),
        of("kernels/exact_order", 14, |_, row| order(row), rays::two_spheres),
    ]
}

fn mul_add(mut row: Reader<'_, f64>) -> Option<Numbers<f64>> {
    let (a, b, c) = (row.number(), row.number(), row.number());
    let (product, error) = two_product(a, b);
    Some([product, error, a.mul_add(b, c)].map(Some).to_vec())
}

/// Returns the answers of all steps, as an `ExactReport` of `kernels/exact_report.wgsl`. If a step is certain, its hit
/// is that of the function that the programs call.
fn steps(mut row: Reader<'_, f64>, record: fn(&mut Reader<'_, f64>) -> Record) -> Option<Numbers<f64>> {
    let (ray, record) = (row.ray(), record(&mut row));
    let (plain, compensated) = (record.filtered(&ray), record.compensated(&ray));
    let step = match (plain, compensated) {
        (Decision::Certain(_), _) => 1.0,
        (_, Decision::Certain(_)) => 2.0,
        _ => 0.0,
    };
    let hit = if step == 0.0 { None } else { record.exact(&ray) };
    let (lambda, part) = hit.map_or((0.0, 0.0), |(lambda, part)| (lambda, part.number()));
    let head = [step, f64::from(u8::from(hit.is_some())), lambda, part];
    Some([&head[..], &code(plain), &code(compensated)].concat().into_iter().map(Some).collect())
}

/// Returns the number of `exact_code` in `kernels/exact_report.wgsl` for a decision, and the lambda of a hit or 0.
fn code(decision: Decision<Found>) -> [f64; 2] {
    match decision {
        Decision::Uncertain => [0.0, 0.0],
        Decision::Certain(None) => [1.0, 0.0],
        // The hits have the numbers after that of a miss, in the order of the parts.
        Decision::Certain(Some((lambda, part))) => [2.0 + part.number::<f64>(), lambda],
    }
}

/// Returns which of two spheres a ray hits first, by the lambdas of the plain formula: 1 or 2, or 0 if that is
/// uncertain. The result is 3 if the formula does not find two hits.
fn order(mut row: Reader<'_, f64>) -> Option<Numbers<f64>> {
    let ray = row.ray();
    let order = match [(); 2].map(|()| sphere(&mut row).filtered(&ray)) {
        [Decision::Certain(Some((first, _))), Decision::Certain(Some((second, _)))] => {
            match [is_certainly_closer(first, second), is_certainly_closer(second, first)] {
                [true, _] => 1.0,
                [_, true] => 2.0,
                _ => 0.0,
            }
        }
        _ => 3.0,
    };
    Some(vec![Some(order)])
}

#[test]
fn every_step_has_the_bits_of_cpu() {
    let gpu = common::gpu();
    let count = number_of("RENDER_CASES").map_or(CASES, |count| count as usize);
    for kernel in all() {
        let cases = kernel.rows(count, 30);
        let pipeline = kernel.compile(&gpu, &Library::standard()).unwrap_or_else(|error| panic!("{error}"));
        let tally = kernel.check(&gpu, &pipeline, &cases).unwrap_or_else(|error| panic!("{error}"));
        println!("{tally}");
        assert_eq!(tally.differing, 0, "{tally}");
        assert!(tally.cases > count, "{tally}");
        if kernel.module != "kernels/mul_add" {
            // Each step decides some rays or pairs, and some are left for dyadic arithmetic.
            let mut answers = [0; 4];
            let first = |case: &[f64]| kernel.expected(case)[0].unwrap_or_default() as usize;
            cases.chunks(kernel.inputs).for_each(|case| answers[first(case)] += 1);
            println!("uncertain, first, second, not two hits: {answers:?}");
            assert!(answers[..3].iter().all(|&count| count > 1000), "{answers:?}");
        }
    }
}
