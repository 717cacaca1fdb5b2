//! Rounding to whole numbers, the rounding of sums and products, and signs.

use super::CORRECTLY_ROUNDED;
use crate::conformance::draft::Draft;
use crate::conformance::inputs::{near_whole, random};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::ulp::neighbours;
use crate::conformance::value::{Number, Rounding};

pub fn probes() -> Vec<Probe> {
    let mut probes = vec![
        Draft::new("sum", "a + b", random(-3.0, 3.0), |[a, b]: [f32; 2]| a + b)
            .rule(CORRECTLY_ROUNDED)
            .error("rounded up or down", |[a, b]| Allowed::any_of(neighbours(f64::from(a) + f64::from(b))))
            .done(),
        Draft::new("product", "a * b", random(-3.0, 3.0), |[a, b]: [f32; 2]| a * b)
            .rule(CORRECTLY_ROUNDED)
            .error("rounded up or down", |[a, b]| Allowed::any_of(neighbours(f64::from(a) * f64::from(b))))
            .done(),
        Draft::new("fract", "fract(a)", near_whole(), |[a]: [f32; 1]| a - a.floor())
            .rule("WGSL 15.7.4: as accurate as a - floor(a)")
            .error("rounded up or down", |[a]| Allowed::any_of(neighbours(f64::from(a) - f64::from(a).floor())))
            .done(),
        Draft::new("sign", "sign(a)", near_whole(), |[a]: [f32; 1]| sign(a))
            .rule("WGSL 17.5: -1, 0 or 1. IEEE 754 does not define it; the sign of zero may be ignored")
            .reading("either zero", Kind::Rewriting, |[a]| either_zero(sign(a)))
            .done(),
        Draft::new("step", "step(a, b)", steps(), |[a, b]: [f32; 2]| f32::from(u8::from(a <= b)))
            .rule("WGSL 17.5: 1 if a <= b, and 0 otherwise")
            .done(),
    ];
    probes.extend(generic::<f32>());
    probes.extend([
        Draft::new("sum", "a + b", random(-3.0, 3.0), |[a, b]: [f64; 2]| a + b).rule(NO_RULE).done(),
        Draft::new("product", "a * b", random(-3.0, 3.0), |[a, b]: [f64; 2]| a * b).rule(NO_RULE).done(),
    ]);
    probes.extend(generic::<f64>());
    probes
}

/// Text for `f64`, which WGSL does not have.
const NO_RULE: &str = "IEEE 754: correctly rounded. WGSL has no f64; naga gives it the meaning of IEEE 754";

/// Returns the sign of a number: -1, 0 or 1. The sign of a zero stays.
fn sign(a: f32) -> f32 {
    if a == 0.0 { a } else { a.signum() }
}

fn steps() -> Vec<[f32; 2]> {
    let near = near_whole::<f32>();
    near.iter().zip(near.iter().rev()).map(|([a], [b])| [*a, *b]).chain(near.iter().map(|[a]| [*a; 2])).collect()
}

/// Allows the number, and if it is a zero, the other zero too.
fn either_zero<T: Number>(number: T) -> Allowed {
    if number.wide() == 0.0 { Allowed::any_of([number, -number]) } else { Allowed::only(number) }
}

fn generic<T: Number>() -> Vec<Probe> {
    const RULE: &str = "IEEE 754: exact, the sign of zero stays. WGSL 15.7.4: exact; the sign of zero may be ignored";
    let rounding = |name: &str, result, how| {
        Draft::new(name, result, near_whole(), move |[a]: [T; 1]| a.whole(how))
            .rule(RULE)
            .reading("either zero", Kind::Rewriting, move |[a]| either_zero(a.whole(how)))
            .done()
    };
    vec![
        rounding("floor", "floor(a)", Rounding::Down),
        rounding("ceil", "ceil(a)", Rounding::Up),
        rounding("trunc", "trunc(a)", Rounding::TowardZero),
        rounding("round-half-even", "round(a)", Rounding::HalfToEven),
    ]
}
