//! Comparisons: of ordinary numbers, and of NaN.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, finite, of_every_kind};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::value::Number;

/// Text for comparisons with NaN.
const NAN: &str = "IEEE 754: NaN is unordered, and not equal to itself. WGSL 15.7.2: NaN may be assumed absent";
/// Name of the reading that allows any result of a comparison with NaN.
const ABSENT: &str = "indeterminate value (assumes finite numbers)";

pub fn probes() -> Vec<Probe> {
    let mut probes = generic::<f32>();
    probes.extend(generic::<f64>());
    probes
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
    let with_nan = || {
        let has_nan = |row: &[T; 2]| row.iter().any(|number| number.wide().is_nan());
        all::<T, 2>(&of_every_kind()).into_iter().filter(has_nan)
    };
    let single = || of_every_kind::<T>().into_iter().map(|a| [a]);
    vec![
        Draft::new("compare", "bits", ordered(), six::<T>)
            .code("", SIX)
            .rule("IEEE 754 and WGSL 15.7.4: the correct result; zeros are equal")
            .done(),
        Draft::new("compare-nan", "bits", with_nan(), six::<T>)
            .code("", SIX)
            .rule(NAN)
            .rewriting("a != b is false for NaN", |row| six(row) & !32)
            .rewriting("unordered comparisons are true", |_| 0b10_1111)
            .reading(ABSENT, Kind::Rewriting, |_| Allowed::any_of(0..64_u32))
            .done(),
        Draft::new("not-less", "select(0u, 1u, !(a < b))", with_nan(), |[a, b]: [T; 2]| u32::from(!a.less(b)))
            .rule(NAN)
            .rewriting("a >= b", |[a, b]| u32::from(a >= b))
            .reading(ABSENT, Kind::Rewriting, |_| Allowed::any_of([0, 1_u32]))
            .done(),
        Draft::new("not-equal-itself", "select(0u, 1u, a != a)", single(), move |[a]: [T; 1]| u32::from(is_nan(a)))
            .rule(NAN)
            .rewriting("false", |_| 0)
            .done(),
        Draft::new("equal-itself", "select(0u, 1u, a == a)", single(), move |[a]: [T; 1]| u32::from(!is_nan(a)))
            .rule(NAN)
            .rewriting("true", |_| 1)
            .done(),
    ]
}
