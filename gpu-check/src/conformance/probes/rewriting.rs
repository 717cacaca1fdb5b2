//! Formulas that drivers simplify by the laws of real numbers.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, finite, of_every_kind, positive, random};
use crate::conformance::probe::Probe;
use crate::conformance::value::Number;

/// Text for formulas whose operations may be reordered.
const REASSOCIATION: &str = "IEEE 754: each operation rounds. WGSL 15.7.5: operations may be reordered such that the \
                             exact result stays";
/// Text for formulas whose operations may be fused.
const FUSION: &str = "IEEE 754: each operation rounds. WGSL 15.7.5: operations may be fused if the result is at least \
                      as accurate, and reordered";
/// Text for the square of a root.
const ROOT: &str = "IEEE 754: each operation rounds. WGSL 15.7.4: the error of sqrt is several ulp, so a is allowed";
/// Text for products with zero.
const PRODUCT: &str = "IEEE 754: NaN for infinities and NaN, and a sign. WGSL 15.7.2: neither is required";
/// Text for formulas that depend on the sign of zero.
const ZERO: &str = "IEEE 754: the sign of zero is fixed. WGSL 15.7.2: the sign of zero may be ignored";

pub fn probes() -> Vec<Probe> {
    generic::<f32>().into_iter().chain(generic::<f64>()).collect()
}

fn generic<T: Number>() -> Vec<Probe> {
    let mut probes = sums::<T>();
    probes.extend(products::<T>());
    probes.extend(zeros::<T>());
    probes
}

fn sums<T: Number>() -> Vec<Probe> {
    // The compiler of Rust must not add the two constants.
    let [tenth, fifth] = [0.1, 0.2].map(|number| T::of(std::hint::black_box(number)));
    vec![
        Draft::new("cancel-term", "(a + b) - a", REASSOCIATION, positive(-3.0, 3.0), |[a, b]: [T; 2]| (a + b) - a)
            .rewriting("b", |[_, b]| b)
            .done(),
        Draft::new("cancel-difference", "a - (a - b)", REASSOCIATION, positive(-3.0, 3.0), {
            |[a, b]: [T; 2]| a - (a - b)
        })
        .rewriting("b", |[_, b]| b)
        .done(),
        Draft::new("reorder-sum", "(a + b) + c", REASSOCIATION, random(-3.0, 3.0), |[a, b, c]: [T; 3]| (a + b) + c)
            .rewriting("a + (b + c)", |[a, b, c]| a + (b + c))
            .rewriting("(a + c) + b", |[a, b, c]| (a + c) + b)
            .done(),
        Draft::new("merge-constants", "(a + 0.1) + 0.2", REASSOCIATION, random(-3.0, 3.0), move |[a]: [T; 1]| {
            (a + tenth) + fifth
        })
        .rewriting("a + (0.1 + 0.2)", move |[a]| a + (tenth + fifth))
        .done(),
        Draft::new("error-of-sum", "(a - (s - t)) + (b - t)", REASSOCIATION, random(-3.0, 3.0), |[a, b]: [T; 2]| {
            error_of_sum(a, b)
        })
        .statements("let s = a + b;\nlet t = s - a;\n")
        .rewriting("0", |_| T::of(0.0))
        .done(),
    ]
}

/// Returns the rounding error of `a + b`, which is exact (Knuth, TAOCP 4.2.2, theorem B).
fn error_of_sum<T: Number>(a: T, b: T) -> T {
    let s = a + b;
    let t = s - a;
    (a - (s - t)) + (b - t)
}

fn products<T: Number>() -> Vec<Probe> {
    vec![
        Draft::new("contract", "a * b + c", FUSION, random(-1.0, 1.0), |[a, b, c]: [T; 3]| a * b + c)
            .rewriting("fma(a, b, c)", |[a, b, c]| a.fused(b, c))
            .done(),
        Draft::new("factor-out", "a * b + a * c", FUSION, random(-3.0, 3.0), |[a, b, c]: [T; 3]| a * b + a * c)
            .rewriting("a * (b + c)", |[a, b, c]| a * (b + c))
            .rewriting("fma(a, b, a * c)", |[a, b, c]| a.fused(b, a * c))
            .rewriting("fma(a, c, a * b)", |[a, b, c]| a.fused(c, a * b))
            .done(),
        Draft::new("square-of-root", "sqrt(a) * sqrt(a)", ROOT, positive(-3.0, 3.0), |[a]: [T; 1]| a.sqrt() * a.sqrt())
            .rewriting("a", |[a]| a)
            .done(),
    ]
}

/// Formulas that are trivial for real numbers, and not for zeros of either sign, infinities and NaN.
fn zeros<T: Number>() -> Vec<Probe> {
    let is_negative = |a: T| a.bits() >> (8 * size_of::<T>() - 1) != 0;
    let every = of_every_kind::<T>().into_iter().map(|a| [a]);
    let single = finite::<T>().into_iter().map(|a| [a]);
    vec![
        Draft::new("multiply-by-zero", "a * 0.0", PRODUCT, every, |[a]: [T; 1]| a * T::of(0.0))
            .rewriting("0", |_| T::of(0.0))
            .rewriting("0 with the sign of a", move |[a]| T::select(is_negative(a), -T::of(0.0), T::of(0.0)))
            .done(),
        Draft::new("add-zero", "a + 0.0", ZERO, single, |[a]: [T; 1]| a + T::of(0.0)).rewriting("a", |[a]| a).done(),
        Draft::new("negate-difference", "-(a - b)", ZERO, all(&finite()), |[a, b]: [T; 2]| -(a - b))
            .rewriting("b - a", |[a, b]| b - a)
            .done(),
    ]
}
