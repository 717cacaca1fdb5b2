//! Transcendental functions.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{between, positive};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::ulp::{ulp, within, within_absolute};

/// Text for functions of `f64`. GLSL.std.450 is the set of instructions to which naga translates them.
const F64: &str = "IEEE 754: correctly rounded (recommended). WGSL has no f64, and GLSL.std.450 has these functions for 16 \
                   and 32 bits only, so naga must refuse the program";

/// Largest magnitude of the arguments of `sin` and `cos`. WGSL bounds their error up to pi, and the `f32` nearest to pi
/// is larger than pi.
const HALF_TURN: f64 = std::f64::consts::PI - 1e-5;

pub fn probes() -> Vec<Probe> {
    let mut probes = of_f32();
    probes.push(power());
    probes.extend(of_f64());
    probes
}

/// Returns a probe of a function of one number. `exact` calculates it in `f64`, and `allowed` gives the results within
/// the error of WGSL from the argument and the exact result.
fn function(
    [name, result, rule, error]: [&'static str; 4],
    cases: Vec<[f32; 1]>,
    exact: fn(f64) -> f64,
    allowed: fn(f64, f64) -> Allowed,
) -> Probe {
    Draft::new(name, result, cases, move |[a]: [f32; 1]| exact(f64::from(a)) as f32)
        .rule(rule)
        .error(error, move |[a]| allowed(f64::from(a), exact(f64::from(a))))
        .done()
}

/// Allows the error of `log` and `log2`.
fn of_logarithm(a: f64, exact: f64) -> Allowed {
    if (0.5..=2.0).contains(&a) { within_absolute(exact, 2.0_f64.powi(-21)) } else { within(exact, 3.0) }
}

fn of_f32() -> Vec<Probe> {
    let turn = || between(-HALF_TURN, HALF_TURN);
    let in_turn = |_, exact| within_absolute(exact, 2.0_f64.powi(-11));
    let of_power = |a: f64, exact| within(exact, 3.0 + 2.0 * a.abs());
    const TURN: &str = "WGSL 15.7.4: absolute error 2^-11 from -pi to pi";
    const POWER: &str = "WGSL 15.7.4: 3 + 2 |a| ulp";
    const LOGARITHM: &str = "WGSL 15.7.4: absolute error 2^-21 from 0.5 to 2, and else 3 ulp";
    vec![
        function(["sin", "sin(a)", TURN, "2^-11"], turn(), f64::sin, in_turn),
        function(["cos", "cos(a)", TURN, "2^-11"], turn(), f64::cos, in_turn),
        function(["exp", "exp(a)", POWER, "3 + 2 |a| ulp"], between(-80.0, 80.0), f64::exp, of_power),
        function(["exp2", "exp2(a)", POWER, "3 + 2 |a| ulp"], between(-120.0, 120.0), f64::exp2, of_power),
        function(["log", "log(a)", LOGARITHM, "2^-21 or 3 ulp"], positive(-3.0, 3.0), f64::ln, of_logarithm),
        function(["log2", "log2(a)", LOGARITHM, "2^-21 or 3 ulp"], positive(-3.0, 3.0), f64::log2, of_logarithm),
        function(
            ["atan", "atan(a)", "WGSL 15.7.4: 4096 ulp", "4096 ulp"],
            between(-9.0, 9.0),
            f64::atan,
            |_, exact| within(exact, 4096.0),
        ),
    ]
}

fn power() -> Probe {
    let cases = positive::<f32, 2>(-1.0, 1.0).into_iter().map(|[a, b]| [a, b - 5.0]);
    Draft::new("pow", "pow(a, b)", cases, |[a, b]: [f32; 2]| f64::from(a).powf(f64::from(b)) as f32)
        .rule("WGSL 15.7.4: as accurate as exp2(b * log2(a))")
        .error("exp2(b * log2(a))", |[a, b]| {
            let [a, b] = [a, b].map(f64::from);
            let logarithm = a.log2();
            let of_log = if (0.5..=2.0).contains(&a) { 2.0_f64.powi(-21) } else { 3.0 * ulp(logarithm) };
            // The error of the exponent: that of the logarithm times b, and that of the product's rounding.
            let of_exponent = (b * of_log).abs() + ulp(b * logarithm);
            let [low, high] = [-1.0, 1.0].map(|side| (b * logarithm + side * of_exponent).exp2());
            let of_power = 3.0 + 2.0 * ((b * logarithm).abs() + of_exponent);
            Allowed::Between(low - of_power * ulp(low) * 1.01, high + of_power * ulp(high) * 1.01)
        })
        .done()
}

fn of_f64() -> Vec<Probe> {
    let probe = |name, result, cases: Vec<[f64; 1]>, exact: fn(f64) -> f64| {
        Draft::new(name, result, cases, move |[a]: [f64; 1]| exact(a))
            .rule(F64)
            .reading("4 ulp", Kind::Error, move |[a]| near(exact(a)))
            .may_be_refused()
            .done()
    };
    let powers = positive::<f64, 2>(-1.0, 1.0);
    vec![
        probe("sin", "sin(a)", between(-HALF_TURN, HALF_TURN), f64::sin),
        probe("cos", "cos(a)", between(-HALF_TURN, HALF_TURN), f64::cos),
        probe("exp", "exp(a)", between(-80.0, 80.0), f64::exp),
        probe("log", "log(a)", positive(-3.0, 3.0), f64::ln),
        Draft::new("pow", "pow(a, b)", powers, |[a, b]: [f64; 2]| a.powf(b))
            .rule(F64)
            .reading("4 ulp", Kind::Error, |[a, b]| near(a.powf(b)))
            .may_be_refused()
            .done(),
    ]
}

/// Allows the results within 4 units in the last place of a number of `f64`. The C library's own error is below 1.
fn near(exact: f64) -> Allowed {
    let error = 4.0 * (exact.abs().next_up() - exact.abs());
    Allowed::Between(exact - error, exact + error)
}
