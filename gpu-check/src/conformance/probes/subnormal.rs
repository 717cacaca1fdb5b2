//! Subnormal numbers, which arithmetic may replace by zeros, and which copies must keep.

use std::ops::RangeInclusive;

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, finite, subnormal};
use crate::conformance::probe::Probe;
use crate::conformance::reading::Allowed;
use crate::conformance::value::Number;

/// Text for operations of section 15.7.4.
const MAY_FLUSH: &str = "IEEE 754: subnormal numbers are kept. WGSL 15.7.2: inputs and results of operations of 15.7.4 \
                         may be flushed to zero";
/// Text for operations that are not in section 15.7.4.
const MUST_KEEP: &str =
    "IEEE 754: kept. WGSL 15.7.2: operations that are not in 15.7.4 must preserve subnormal numbers";
/// Text for a choice by a comparison.
const SELECT: &str = "WGSL 15.7.2: the comparison may flush its inputs; the chosen number must be preserved";

pub fn probes() -> Vec<Probe> {
    generic::<f32>().into_iter().chain(generic::<f64>()).collect()
}

/// Returns the number, or a zero of its sign if it is subnormal and `flush` is set.
fn flushed<T: Number>(number: T, flush: bool) -> T {
    match (flush && number.abs().less(T::TINY), number.wide() < 0.0) {
        (false, _) => number,
        (true, false) => T::of(0.0),
        (true, true) => -T::of(0.0),
    }
}

/// Returns the results that an operation may have for the given choices. The bits of a choice say whether the first
/// input, the second input and the result are flushed. A zero that replaces a number may have either sign.
fn results<T: Number>([a, b]: [T; 2], formula: fn(T, T) -> T, choices: RangeInclusive<u8>) -> Allowed {
    let exact = formula(a, b);
    Allowed::any_of(choices.flat_map(|choice| {
        let [first, second, result] = [1, 2, 4].map(|bit| choice & bit != 0);
        let number = flushed(formula(flushed(a, first), flushed(b, second)), result);
        // The sign of a zero counts only if the formula as written gives a zero too.
        let other = if number.wide() == 0.0 && exact.wide() != 0.0 { -number } else { number };
        [number, other]
    }))
}

/// Returns a probe of an operation that may flush its inputs and its result.
fn flushing<T: Number>(name: &str, result: &'static str, cases: Vec<[T; 2]>, formula: fn(T, T) -> T) -> Probe {
    Draft::new(name, result, MAY_FLUSH, cases, move |[a, b]| formula(a, b))
        .rewritings("inputs flushed", move |case| results(case, formula, 3..=3))
        .rewritings("results flushed", move |case| results(case, formula, 4..=4))
        .rewritings("inputs and results flushed", move |case| results(case, formula, 7..=7))
        .rewritings("some numbers flushed", move |case| results(case, formula, 0..=7))
        .done()
}

fn generic<T: Number>() -> Vec<Probe> {
    // Subnormal results of normal inputs, normal results of subnormal inputs, and both subnormal.
    let normal = [1.5, -1.25, 1.0, 3.0].map(|factor| T::TINY * T::of(factor));
    let of_sum = all(&[&subnormal::<T>()[..], &normal].concat());
    let mut of_product: Vec<[T; 2]> = [0.7, 0.3, -0.01, 1.0, 2.0].map(|part| [T::TINY, T::of(part)]).to_vec();
    for small in subnormal::<T>() {
        of_product.extend([[small, T::of(0.5)], [small, T::of(1e10)], [T::of(-3.0), small], [T::of(1.0), small]]);
    }
    let single = subnormal::<T>().into_iter().chain(finite()).map(|a| [a]);
    let pairs = || all::<T, 2>(&[&subnormal::<T>()[..], &[T::of(0.0), T::TINY]].concat());
    let less = |a: T, b: T| u32::from(a.less(b));
    vec![
        flushing("subnormal-sum", "a + b", of_sum, |a, b| a + b),
        flushing("subnormal-product", "a * b", of_product, |a, b| a * b),
        Draft::new("subnormal-copy", "a", MUST_KEEP, single, |[a]: [T; 1]| a).done(),
        Draft::new("subnormal-less", "select(0u, 1u, a < b)", MAY_FLUSH, pairs(), move |[a, b]: [T; 2]| less(a, b))
            .rewriting("inputs flushed", move |[a, b]| less(flushed(a, true), flushed(b, true)))
            .done(),
        Draft::new("subnormal-select", "select(a, b, b < a)", SELECT, pairs(), |[a, b]: [T; 2]| {
            T::select(b.less(a), b, a)
        })
        .rewriting("inputs of < flushed", |[a, b]| T::select(flushed(b, true).less(flushed(a, true)), b, a))
        .done(),
    ]
}
