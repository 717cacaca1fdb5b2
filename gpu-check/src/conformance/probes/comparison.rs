//! Comparisons of ordinary numbers and of NaN, and the choice between two numbers.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, finite, of_every_kind};
use crate::conformance::probe::Probe;
use crate::conformance::reading::Allowed;
use crate::conformance::value::Number;

/// Text for comparisons with NaN.
const NAN: &str = "IEEE 754: NaN is unordered, and not equal to itself. WGSL 15.7.2: NaN may be assumed absent";

pub fn probes() -> Vec<Probe> {
    generic::<f32>().into_iter().chain(generic::<f64>()).collect()
}

/// Statements that put the six comparisons into six bits.
const SIX: &str = "var bits = select(0u, 1u, a < b) + select(0u, 2u, a <= b);\n\
                   bits += select(0u, 4u, a > b) + select(0u, 8u, a >= b);\n\
                   bits += select(0u, 16u, a == b) + select(0u, 32u, a != b);\n";

/// Returns the six comparisons as six bits.
fn six<T: Number>([a, b]: [T; 2]) -> u32 {
    let bits = [a < b, a <= b, a > b, a >= b, a == b, a != b];
    bits.into_iter().enumerate().map(|(place, holds)| u32::from(holds) << place).sum()
}

fn generic<T: Number>() -> Vec<Probe> {
    let is_nan = |number: T| number.wide().is_nan();
    let ordered = || all::<T, 2>(&[&finite::<T>()[..], &[T::of(f64::INFINITY), T::of(f64::NEG_INFINITY)]].concat());
    let with_nan = || all::<T, 2>(&of_every_kind()).into_iter().filter(move |row| row.iter().any(|a| is_nan(*a)));
    let single = || of_every_kind::<T>().into_iter().map(|a| [a]);
    let choices = || {
        let pairs = all::<T, 2>(&of_every_kind()).into_iter();
        pairs.flat_map(|[a, b]| [-1.0, 1.0].map(|c| [a, b, T::of(c)]))
    };
    vec![
        Draft::new("compare", "bits", "IEEE 754 and WGSL 15.7.4: correct, and zeros are equal", ordered(), six::<T>)
            .statements(SIX)
            .done(),
        Draft::new("compare-nan", "bits", NAN, with_nan(), six::<T>)
            .statements(SIX)
            .rewriting("a != b is false for NaN", |row| six(row) & !32)
            .rewriting("unordered comparisons are true", |_| 0b10_1111)
            .rewritings("indeterminate value (assumes finite numbers)", |_| Allowed::any_of(0..64_u32))
            .done(),
        Draft::new("not-equal-itself", "select(0u, 1u, a != a)", NAN, single(), move |[a]: [T; 1]| {
            u32::from(is_nan(a))
        })
        .rewriting("false", |_| 0)
        .done(),
        Draft::new(
            "select",
            "select(a, b, c < 0.0)",
            "WGSL 17.3: b if the condition holds, and else a, whatever the other number is",
            choices(),
            |[a, b, c]: [T; 3]| T::select(c.less(T::of(0.0)), b, a),
        )
        .done(),
    ]
}
