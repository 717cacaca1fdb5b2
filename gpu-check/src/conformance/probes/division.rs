//! Quotients, square roots and remainders.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, finite, positive, random};
use crate::conformance::probe::Probe;
use crate::conformance::reading::Allowed;
use crate::conformance::ulp::{ulp, within};
use crate::conformance::value::Number;

/// Text for quotients.
const QUOTIENT: &str = "IEEE 754: correctly rounded. WGSL 15.7.4: 2.5 ulp if |b| is from 2^-126 to 2^126; f64: no rule";
/// Text for quotients by zero and roots of negative numbers.
const OUTSIDE: &str = "IEEE 754: infinity or NaN. WGSL 15.7.2: an indeterminate value";

pub fn probes() -> Vec<Probe> {
    let mut probes = of_f32();
    probes.extend(generic::<f32>());
    probes.extend(of_f64());
    probes.extend(generic::<f64>());
    probes
}

fn of_f32() -> Vec<Probe> {
    let exact = |[a, b]: [f32; 2]| f64::from(a) / f64::from(b);
    vec![
        quotient::<f32>().error("2.5 ulp", move |case| within(exact(case), 2.5)).done(),
        reciprocal::<f32>().error("2.5 ulp", move |[a]| within(exact([1.0, a]), 2.5)).done(),
        root::<f32>().error("1 / inverseSqrt(a)", |[a]| root_by_inverse(a)).done(),
        Draft::new("inverse-root", "inverseSqrt(a)", positive(-20.0, 20.0), |[a]: [f32; 1]| {
            // The second rounding could matter only within 2^-29 ulp of a tie, and no input is so close to one.
            (1.0 / f64::from(a).sqrt()) as f32
        })
        .rule("IEEE 754: correctly rounded (recommended). WGSL 15.7.4: 2 ulp")
        .rewriting("1 / sqrt(a)", |[a]| 1.0 / a.sqrt())
        .error("2 ulp", |[a]| within(1.0 / f64::from(a).sqrt(), 2.0))
        .done(),
        Draft::new(
            "divide-by-literal-zero",
            "select(a, a / 0.0, b < 0.0)",
            all::<f32, 2>(&finite()),
            |[a, b]: [f32; 2]| {
                if b < 0.0 { a / std::hint::black_box(0.0) } else { a }
            },
        )
        .rule(OUTSIDE)
        .rewriting("a / 0.0 is a", |[a, _]| a)
        .rewriting("a / 0.0 is 0", |[a, b]| if b < 0.0 { 0.0 } else { a })
        .finite_math(|[_, b]| b < 0.0)
        .done(),
    ]
}

fn of_f64() -> Vec<Probe> {
    vec![quotient::<f64>().done(), reciprocal::<f64>().done(), root::<f64>().done()]
}

fn quotient<T: Number>() -> Draft<T, T, 2> {
    Draft::new("divide", "a / b", random(-15.0, 15.0), |[a, b]: [T; 2]| a / b)
        .rule(QUOTIENT)
        .rewriting("a * (1 / b)", |[a, b]| a * (T::of(1.0) / b))
}

fn reciprocal<T: Number>() -> Draft<T, T, 1> {
    Draft::new("reciprocal", "1.0 / a", random(-30.0, 30.0), |[a]: [T; 1]| T::of(1.0) / a).rule(QUOTIENT)
}

fn root<T: Number>() -> Draft<T, T, 1> {
    Draft::new("root", "sqrt(a)", positive(-30.0, 30.0), |[a]: [T; 1]| a.sqrt())
        .rule("IEEE 754: correctly rounded. WGSL 15.7.4: as accurate as 1 / inverseSqrt(a); f64: no rule")
}

/// Allows the results of `1 / inverseSqrt(a)`: the inverse root has an error of 2 ulp, and the quotient one of 2.5 ulp.
fn root_by_inverse(a: f32) -> Allowed {
    let inverse = 1.0 / f64::from(a).sqrt();
    let error = 2.0 * ulp(inverse);
    let [low, high] = [1.0 / (inverse + error), 1.0 / (inverse - error)];
    Allowed::Between(low - 2.6 * ulp(low), high + 2.6 * ulp(high))
}

fn generic<T: Number>() -> Vec<Probe> {
    // Some rows have a fixed result: quotients by powers of two, and roots of powers of four.
    let zeros = || all::<T, 2>(&[0.0, -0.0, 1.0, -2.5, 4.0].map(T::of)).into_iter().filter(|[_, b]| b.wide() != -2.5);
    let negative =
        || random(-3.0, 3.0).into_iter().map(|[a]: [T; 1]| [-a.abs()]).chain([0.0, 1.0, 16.0].map(|a| [T::of(a)]));
    vec![
        Draft::new("divide-by-zero", "a / b", zeros(), |[a, b]: [T; 2]| a / b)
            .rule(OUTSIDE)
            .finite_math(|[_, b]| b.wide() == 0.0)
            .done(),
        Draft::new("root-of-negative", "sqrt(a)", negative(), |[a]: [T; 1]| a.sqrt())
            .rule(OUTSIDE)
            .finite_math(|[a]| a.wide() < 0.0)
            .done(),
        Draft::new("remainder", "a % b", random(-1.0, 2.0), |[a, b]: [T; 2]| remainder(a, b))
            .rule("IEEE 754: exact. WGSL 15.7.4: as accurate as a - b * trunc(a / b)")
            .rewriting("a - b * trunc(a / b)", |[a, b]| a - b * whole(a / b))
            .error("a - b * trunc(a / b), quotient within 2.5 ulp", |[a, b]| {
                let quotients = quotients(a / b);
                Allowed::any_of(quotients.into_iter().flat_map(|q| [a - b * whole(q), (-b).fused(whole(q), a)]))
            })
            .done(),
    ]
}

fn whole<T: Number>(number: T) -> T {
    number.whole(crate::conformance::value::Rounding::TowardZero)
}

/// Returns the three nearest numbers on either side of `quotient`, and that number.
fn quotients<T: Number>(quotient: T) -> Vec<T> {
    let down = std::iter::successors(Some(quotient), |number| Some(number.lower())).take(4);
    let up = std::iter::successors(Some(quotient), |number| Some(number.upper())).take(4);
    down.chain(up).collect()
}

/// Returns the remainder of the quotient rounded toward zero, which is exact: it is a multiple of the last place of `b`
/// or of `a`, and smaller than `b`.
fn remainder<T: Number>(a: T, b: T) -> T {
    // `f64` computes the remainder of `f32` exactly too, and then `of` does not round.
    T::of(a.wide() % b.wide())
}
