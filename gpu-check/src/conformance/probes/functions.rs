//! Transcendental functions of f64, which no specification has. `docs/upstream/naga-f64-functions.md` reports them.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{between, positive};
use crate::conformance::probe::Probe;
use crate::conformance::reading::Allowed;

/// Text for all functions. GLSL.std.450 is the set of instructions to which naga translates them.
const RULE: &str = "IEEE 754: correctly rounded (recommended). WGSL has no f64, and GLSL.std.450 has these functions for \
                    16 and 32 bits only, so naga must refuse the program";

pub fn probes() -> Vec<Probe> {
    let of_one = |name, result, cases: Vec<[f64; 1]>, exact: fn(f64) -> f64| {
        Draft::new(name, result, RULE, cases, move |[a]: [f64; 1]| exact(a))
            .error("4 ulp", move |[a]| near(exact(a)))
            .may_be_refused()
            .done()
    };
    vec![
        of_one("sin", "sin(a)", between(-3.0, 3.0), f64::sin),
        of_one("exp", "exp(a)", between(-80.0, 80.0), f64::exp),
        of_one("log", "log(a)", positive(-3.0, 3.0), f64::ln),
        Draft::new("pow", "pow(a, b)", RULE, positive(-1.0, 1.0), |[a, b]: [f64; 2]| a.powf(b))
            .error("4 ulp", |[a, b]| near(a.powf(b)))
            .may_be_refused()
            .done(),
    ]
}

/// Allows the results within 4 units in the last place of a number of `f64`. The C library's own error is below 1.
fn near(exact: f64) -> Allowed {
    let error = 4.0 * (exact.abs().next_up() - exact.abs());
    Allowed::Between(exact - error, exact + error)
}
