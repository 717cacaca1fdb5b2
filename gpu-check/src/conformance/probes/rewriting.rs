//! Formulas that drivers simplify by the laws of real numbers.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{finite, of_every_kind, positive, random};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::value::Number;

/// Text for formulas whose operations may be reordered.
const REASSOCIATION: &str = "IEEE 754: each operation rounds. WGSL 15.7.5: operations may be reordered such that the \
                             exact result stays";
/// Text for formulas whose operations may be fused.
const FUSION: &str = "IEEE 754: each operation rounds. WGSL 15.7.5: operations may be fused if the result is at least \
                      as accurate, and reordered";
/// Text for formulas that depend on the sign of zero.
const ZERO: &str = "IEEE 754: the sign of zero is fixed. WGSL 15.7.2: the sign of zero may be ignored";
/// Text for formulas that depend on infinities or NaN.
const FINITE: &str = "IEEE 754: NaN for infinities and NaN. WGSL 15.7.2: numbers may be assumed to be finite";

pub fn probes() -> Vec<Probe> {
    let mut probes = generic::<f32>();
    probes.push(constants());
    probes.extend(generic::<f64>());
    probes
}

fn generic<T: Number>() -> Vec<Probe> {
    let mut probes = sums::<T>();
    probes.extend(products::<T>());
    probes.extend(trivial::<T>());
    probes
}

fn sums<T: Number>() -> Vec<Probe> {
    vec![
        Draft::new("cancel-term", "(a + b) - a", positive(-3.0, 3.0), |[a, b]: [T; 2]| (a + b) - a)
            .rule(REASSOCIATION)
            .rewriting("b", |[_, b]| b)
            .done(),
        Draft::new("cancel-difference", "a - (a - b)", positive(-3.0, 3.0), |[a, b]: [T; 2]| a - (a - b))
            .rule(REASSOCIATION)
            .rewriting("b", |[_, b]| b)
            .done(),
        Draft::new("reorder-sum", "(a + b) + c", random(-3.0, 3.0), |[a, b, c]: [T; 3]| (a + b) + c)
            .rule(REASSOCIATION)
            .rewriting("a + (b + c)", |[a, b, c]| a + (b + c))
            .rewriting("(a + c) + b", |[a, b, c]| (a + c) + b)
            .done(),
        Draft::new("error-of-sum", "(a - (s - t)) + (b - t)", random(-3.0, 3.0), |[a, b]: [T; 2]| error(a, b))
            .code("", "let s = a + b;\nlet t = s - a;\n")
            .rule(REASSOCIATION)
            .rewriting("0", |_| T::of(0.0))
            .done(),
        Draft::new("error-of-sum-barrier", "(a - (s - t)) + (b - t)", with_one(), |[a, b, _]: [T; 3]| error(a, b))
            .code("", "let s = a * c + b;\nlet t = s - a;\n")
            .rule("The number c is 1, which the driver cannot know. Otherwise as error-of-sum")
            .rewriting("0", |_| T::of(0.0))
            .done(),
    ]
}

/// Returns the rounding error of `a + b`, which is exact (Knuth, TAOCP 4.2.2, theorem B).
fn error<T: Number>(a: T, b: T) -> T {
    let s = a + b;
    let t = s - a;
    (a - (s - t)) + (b - t)
}

/// Returns numbers whose squares are around the smallest normal number.
fn small_squares<T: Number>() -> Vec<[T; 1]> {
    random(-3.0, 3.0).into_iter().map(|[a]: [T; 1]| [a * T::TINY.sqrt()]).collect()
}

fn with_one<T: Number>() -> Vec<[T; 3]> {
    random(-3.0, 3.0).into_iter().map(|[a, b]: [T; 2]| [a, b, T::of(1.0)]).collect()
}

fn products<T: Number>() -> Vec<Probe> {
    vec![
        Draft::new("reorder-product", "(a * b) * c", random(-3.0, 3.0), |[a, b, c]: [T; 3]| (a * b) * c)
            .rule(REASSOCIATION)
            .rewriting("a * (b * c)", |[a, b, c]| a * (b * c))
            .rewriting("(a * c) * b", |[a, b, c]| (a * c) * b)
            .done(),
        Draft::new("factor-out", "a * b + a * c", random(-3.0, 3.0), |[a, b, c]: [T; 3]| a * b + a * c)
            .rule(FUSION)
            .rewriting("a * (b + c)", |[a, b, c]| a * (b + c))
            .rewriting("fma(a, b, a * c)", |[a, b, c]| a.fused(b, a * c))
            .rewriting("fma(a, c, a * b)", |[a, b, c]| a.fused(c, a * b))
            .done(),
        Draft::new("contract", "a * b + c", random(-1.0, 1.0), |[a, b, c]: [T; 3]| a * b + c)
            .rule(FUSION)
            .rewriting("fma(a, b, c)", |[a, b, c]| a.fused(b, c))
            .done(),
        Draft::new("contract-difference", "c - a * b", random(-1.0, 1.0), |[a, b, c]: [T; 3]| c - a * b)
            .rule(FUSION)
            .rewriting("fma(-a, b, c)", |[a, b, c]| (-a).fused(b, c))
            .done(),
        Draft::new("fma", "fma(a, b, c)", random(-1.0, 1.0), |[a, b, c]: [T; 3]| a.fused(b, c))
            .rule("IEEE 754: one rounding. WGSL 15.7.2: may be a product and a sum, with two roundings")
            .rewriting("a * b + c", |[a, b, c]| a * b + c)
            .done(),
        Draft::new("square-of-root", "sqrt(a) * sqrt(a)", positive(-3.0, 3.0), |[a]: [T; 1]| a.sqrt() * a.sqrt())
            .rule("IEEE 754: each operation rounds. WGSL 15.7.4: the error of sqrt is several ulp, so a is allowed")
            .rewriting("a", |[a]| a)
            .done(),
        Draft::new("root-of-square", "sqrt(a * a)", small_squares(), |[a]: [T; 1]| (a * a).sqrt())
            .rule("Some squares are subnormal. IEEE 754: they round. WGSL 15.7.2: they may be flushed; 15.7.5: abs(a)")
            .rewriting("abs(a)", |[a]| a.abs())
            .rewriting("a * a flushed", |[a]| if (a * a).is_tiny() { T::of(0.0) } else { (a * a).sqrt() })
            .done(),
    ]
}

/// Formulas that are trivial for real numbers, and not for zeros of either sign, infinities and NaN.
fn trivial<T: Number>() -> Vec<Probe> {
    let is_special = |a: T| !a.wide().is_finite();
    let every = || of_every_kind::<T>().into_iter().map(|a| [a]);
    let finite = || finite::<T>().into_iter().map(|a| [a]);
    vec![
        Draft::new("subtract-itself", "a - a", every(), |[a]: [T; 1]| {
            let same = a;
            a - same
        })
        .rule(FINITE)
        .rewriting("0", |_| T::of(0.0))
        .finite_math(move |[a]| is_special(a))
        .done(),
        Draft::new("divide-by-itself", "a / a", every(), |[a]: [T; 1]| {
            let same = a;
            a / same
        })
        .rule(FINITE)
        .rewriting("1", |_| T::of(1.0))
        .finite_math(move |[a]| is_special(a) || a.wide() == 0.0)
        .done(),
        Draft::new("multiply-by-zero", "a * 0.0", every(), |[a]: [T; 1]| a * T::of(0.0))
            .rule("IEEE 754: NaN for infinities and NaN, and a sign. WGSL 15.7.2: neither is required")
            .rewriting("0", |_| T::of(0.0))
            .rewriting("0 with the sign of a", |[a]| T::select(a.bits() >> sign::<T>() == 0, T::of(0.0), -T::of(0.0)))
            .finite_math(move |[a]| is_special(a))
            .done(),
        Draft::new("add-zero", "a + 0.0", finite(), |[a]: [T; 1]| a + T::of(0.0))
            .rule(ZERO)
            .rewriting("a", |[a]| a)
            .done(),
        Draft::new("zero-minus", "0.0 - a", finite(), |[a]: [T; 1]| T::of(0.0) - a)
            .rule(ZERO)
            .rewriting("-a", |[a]| -a)
            .done(),
        Draft::new("negate-difference", "-(a - b)", pairs(), |[a, b]: [T; 2]| -(a - b))
            .rule(ZERO)
            .rewriting("b - a", |[a, b]| b - a)
            .done(),
        Draft::new("multiply-by-one", "a * 1.0", finite(), |[a]: [T; 1]| a)
            .rule(ZERO)
            .reading("sign of zero lost", Kind::Rewriting, |[a]| match a.wide() == 0.0 {
                true => Allowed::any_of([a, -a]),
                false => Allowed::only(a),
            })
            .done(),
    ]
}

/// Returns the place of the sign among the bits of a number.
const fn sign<T>() -> usize {
    8 * size_of::<T>() - 1
}

/// Returns pairs of numbers, some of them equal.
fn pairs<T: Number>() -> Vec<[T; 2]> {
    let numbers = finite::<T>();
    numbers.iter().flat_map(|a| numbers.iter().map(move |b| [*a, *b])).collect()
}

fn constants() -> Probe {
    // The compiler of Rust must not add the two constants.
    let parts = || (std::hint::black_box(0.1_f32), std::hint::black_box(0.2_f32));
    Draft::new("merge-constants", "(a + 0.1) + 0.2", random(-3.0, 3.0), move |[a]: [f32; 1]| {
        let (tenth, fifth) = parts();
        (a + tenth) + fifth
    })
    .rule(REASSOCIATION)
    .rewriting("a + (0.1 + 0.2)", move |[a]| {
        let (tenth, fifth) = parts();
        a + (tenth + fifth)
    })
    .done()
}
