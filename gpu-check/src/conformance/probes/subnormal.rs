//! Subnormal numbers, which arithmetic may replace by zeros, and which copies must keep.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, finite, subnormal};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::value::{Number, Type};

/// Text for operations of section 15.7.4.
const MAY_FLUSH: &str = "IEEE 754: subnormal numbers are kept. WGSL 15.7.2: inputs and results of operations of 15.7.4 \
                         may be flushed to zero";
/// Text for operations that are not in section 15.7.4.
const MUST_KEEP: &str =
    "IEEE 754: kept. WGSL 15.7.2: operations that are not in 15.7.4 must preserve subnormal numbers";

pub fn probes() -> Vec<Probe> {
    let mut probes = generic::<f32>();
    probes.extend(generic::<f64>());
    probes
}

/// Returns the number, or a zero of its sign if it is subnormal and `flush` is set.
fn flushed<T: Number>(number: T, flush: bool) -> T {
    match (flush && number.is_tiny(), number.wide() < 0.0) {
        (false, _) => number,
        (true, false) => T::of(0.0),
        (true, true) => -T::of(0.0),
    }
}

/// Returns the results that an operation may have: `choices` lists whether each of the two inputs and the result is
/// flushed. A zero that replaces a number may have either sign.
fn results<T: Number>(inputs: [T; 2], formula: fn(T, T) -> T, choices: &[[bool; 3]]) -> Allowed {
    let exact = formula(inputs[0], inputs[1]);
    Allowed::any_of(choices.iter().flat_map(|[first, second, result]| {
        let [a, b] = [flushed(inputs[0], *first), flushed(inputs[1], *second)];
        let number = flushed(formula(a, b), *result);
        // The sign of a zero counts only if the formula as written gives a zero too.
        let other = if number.wide() == 0.0 && exact.wide() != 0.0 { -number } else { number };
        [number, other]
    }))
}

/// Adds the readings of an operation that may flush its inputs and its result.
fn flushing<T: Number>(draft: Draft<T, T, 2>, formula: fn(T, T) -> T) -> Probe {
    let reading = move |choices: &'static [[bool; 3]]| move |inputs| results(inputs, formula, choices);
    const SOME: [[bool; 3]; 8] = [
        [false, false, false],
        [false, false, true],
        [false, true, false],
        [false, true, true],
        [true, false, false],
        [true, false, true],
        [true, true, false],
        [true, true, true],
    ];
    draft
        .rule(MAY_FLUSH)
        .reading("inputs flushed", Kind::Rewriting, reading(&[[true, true, false]]))
        .reading("results flushed", Kind::Rewriting, reading(&[[false, false, true]]))
        .reading("inputs and results flushed", Kind::Rewriting, reading(&[[true, true, true]]))
        .reading("some numbers flushed", Kind::Rewriting, reading(&SOME))
        .done()
}

fn generic<T: Number>() -> Vec<Probe> {
    // Subnormal results of normal inputs, normal results of subnormal inputs, and both subnormal.
    let of_sum = || {
        let normal = [1.5, -1.25, 1.0, 3.0].map(|factor| T::TINY * T::of(factor));
        all::<T, 2>(&[&subnormal::<T>()[..], &normal].concat())
    };
    let of_product = || {
        let mut rows = Vec::new();
        for small in subnormal::<T>() {
            rows.extend([[small, T::of(0.5)], [small, T::of(1e10)], [T::of(-3.0), small], [T::of(1.0), small]]);
        }
        for part in [0.7, 0.3, -0.01, 1.0, 2.0] {
            rows.push([T::TINY, T::of(part)]);
        }
        rows
    };
    let single = || subnormal::<T>().into_iter().chain(finite()).map(|a| [a]);
    let pairs = || all::<T, 2>(&[&subnormal::<T>()[..], &[T::of(0.0), T::TINY]].concat());
    let below = |a: T, b: T| u32::from(a.less(b));
    vec![
        flushing(Draft::new("subnormal-sum", "a + b", of_sum(), |[a, b]: [T; 2]| a + b), |a, b| a + b),
        flushing(Draft::new("subnormal-product", "a * b", of_product(), |[a, b]: [T; 2]| a * b), |a, b| a * b),
        Draft::new("subnormal-negate", "-a", single(), |[a]: [T; 1]| -a)
            .rule(MAY_FLUSH)
            .reading("results flushed", Kind::Rewriting, |[a]| match a.is_tiny() {
                true => Allowed::any_of([T::of(0.0), -T::of(0.0)]),
                false => Allowed::only(-a),
            })
            .done(),
        Draft::new("subnormal-abs", "abs(a)", single(), |[a]: [T; 1]| a.abs())
            .rule(MAY_FLUSH)
            .reading("results flushed", Kind::Rewriting, |[a]| match a.is_tiny() {
                true => Allowed::any_of([T::of(0.0), -T::of(0.0)]),
                false => Allowed::only(a.abs()),
            })
            .done(),
        Draft::new("subnormal-less", "select(0u, 1u, a < b)", pairs(), move |[a, b]: [T; 2]| below(a, b))
            .rule(MAY_FLUSH)
            .rewriting("inputs flushed", move |[a, b]| below(flushed(a, true), flushed(b, true)))
            .done(),
        Draft::new("subnormal-copy", "a", single(), |[a]: [T; 1]| a).rule(MUST_KEEP).done(),
        Draft::new("subnormal-variable", "kept[1]", single(), |[a]: [T; 1]| a)
            .code("", if T::TYPE == Type::F64 { ARRAY_F64 } else { ARRAY_F32 })
            .rule(MUST_KEEP)
            .done(),
        Draft::new("subnormal-select", "select(a, b, b < a)", pairs(), |[a, b]: [T; 2]| T::select(b.less(a), b, a))
            .rule("WGSL 15.7.2: the comparison may flush its inputs; the chosen number must be preserved")
            .rewriting("inputs of < flushed", |[a, b]| T::select(flushed(b, true).less(flushed(a, true)), b, a))
            .done(),
    ]
}

const ARRAY_F32: &str = "var kept = array<f32, 2>();\nkept[1] = a;\n";
const ARRAY_F64: &str = "var kept = array<f64, 2>();\nkept[1] = a;\n";
