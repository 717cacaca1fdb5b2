//! Loops with many iterations. `docs/upstream/lavapipe-loop-limit.md` reports a driver that leaves them early.

use crate::conformance::draft::Draft;
use crate::conformance::probe::Probe;

/// Text for all loops.
const RULE: &str = "WGSL 9.4: a loop runs until its condition is false; no number of iterations is too large";

const ONE: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) {\n    sum = (sum ^ i) * 0x01000193u;\n}\n";
const NESTED: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) {\n    for (var j = 0u; j < b; j++) {\n        sum = (sum \
                      ^ (i + j)) * 3u;\n    }\n}\n";
const CONSECUTIVE: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) { sum = (sum ^ i) * 3u; }\nfor (var i = 0u; i < \
                           b; i++) { sum = (sum ^ i) * 5u; }\n";

pub fn probes() -> Vec<Probe> {
    let counts = [0, 1, 1000, 65_534, 65_535, 65_536, 65_537, 70_000, 100_000, 200_000];
    let nested = [[1, 1], [200, 300], [300, 200], [255, 257], [256, 256], [400, 400], [70_000, 1], [1, 70_000]];
    let consecutive = [[40_000, 20_000], [40_000, 40_000], [9, 90_000]];
    // Each step depends on the sum before it, so that no compiler replaces the loop by a formula.
    let steps = |sum: u32, count: u32, factor: u32| (0..count).fold(sum, |sum, i| (sum ^ i).wrapping_mul(factor));
    vec![
        Draft::new("loop-limit", "sum", RULE, counts.map(|count| [count]), move |[a]: [u32; 1]| {
            steps(1, a, 0x0100_0193)
        })
        .statements(ONE)
        .done(),
        Draft::new("loop-limit-nested", "sum", RULE, nested, |[a, b]: [u32; 2]| {
            (0..a).fold(1_u32, |sum, i| (0..b).fold(sum, |sum, j| (sum ^ (i + j)).wrapping_mul(3)))
        })
        .statements(NESTED)
        .done(),
        Draft::new("loop-limit-consecutive", "sum", RULE, consecutive, move |[a, b]: [u32; 2]| {
            steps(steps(1, a, 3), b, 5)
        })
        .statements(CONSECUTIVE)
        .done(),
    ]
}
