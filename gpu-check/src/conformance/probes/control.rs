//! Loops, branches, functions, barriers and atomic operations.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::words;
use crate::conformance::probe::Probe;

/// Text for loops.
const LOOP: &str = "WGSL 9.4: a loop runs until its condition is false; no number of iterations is too large";

pub fn probes() -> Vec<Probe> {
    let mut probes = loops();
    probes.extend(branches());
    probes.extend(workgroups());
    probes
}

fn loops() -> Vec<Probe> {
    let counts = [0, 1, 1000, 65_534, 65_535, 65_536, 65_537, 70_000, 100_000, 200_000];
    // The step depends on the sum, so that no compiler replaces the loop by a formula.
    let steps = |count: u32| (0..count).fold(1_u32, |sum, step| (sum ^ step).wrapping_mul(0x0100_0193));
    let nested = [[1, 1], [200, 300], [300, 200], [255, 257], [256, 256], [400, 400], [70_000, 1], [1, 70_000]];
    vec![
        Draft::new("loop-limit", "sum", counts.map(|count| [count]), move |[a]: [u32; 1]| steps(a))
            .code("", "var sum = 1u;\nfor (var i = 0u; i < a; i++) {\n    sum = (sum ^ i) * 0x01000193u;\n}\n")
            .rule(LOOP)
            .done(),
        Draft::new("loop-limit-nested", "sum", nested, |[a, b]: [u32; 2]| {
            (0..a).fold(1_u32, |sum, i| (0..b).fold(sum, |sum, j| (sum ^ (i + j)).wrapping_mul(3)))
        })
        .code("", NESTED)
        .rule(LOOP)
        .done(),
        Draft::new("loop-limit-consecutive", "sum", [[40_000, 20_000], [40_000, 40_000], [9, 90_000]], {
            |[a, b]: [u32; 2]| {
                let sum = (0..a).fold(1_u32, |sum, step| (sum ^ step).wrapping_mul(3));
                (0..b).fold(sum, |sum, step| (sum ^ step).wrapping_mul(5))
            }
        })
        .code("", CONSECUTIVE)
        .rule(LOOP)
        .done(),
        Draft::new("loop-continuing", "sum", (0..60).map(|a| [a]), |[a]: [u32; 1]| {
            // Odd numbers are left out, and the loop ends after the first number from a on.
            (0..=a).filter(|i| i % 2 == 0).sum::<u32>()
        })
        .code("", CONTINUING)
        .rule("WGSL 9.4: continue goes to continuing, and break if ends the loop after it")
        .done(),
    ]
}

const NESTED: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) {\n    for (var j = 0u; j < b; j++) {\n        sum = (sum \
                      ^ (i + j)) * 3u;\n    }\n}\n";
const CONSECUTIVE: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) { sum = (sum ^ i) * 3u; }\nfor (var i = 0u; i < \
                           b; i++) { sum = (sum ^ i) * 5u; }\n";
const CONTINUING: &str = "var sum = 0u;\nvar i = 0u;\nloop {\n    if i % 2u == 1u { continue; }\n    sum += i;\n    \
                          continuing {\n        i++;\n        break if i > a;\n    }\n}\n";

fn branches() -> Vec<Probe> {
    let pairs = || words::<2>(&[0, 1]).into_iter().map(|[a, b]| [a % 12, b % 12]);
    vec![
        Draft::new("switch", "found", (0..64).map(|a| [a]), |[a]: [u32; 1]| match a {
            1 | 2 => 10_u32,
            3 => 30,
            u32::MAX => 40,
            _ => 20,
        })
        .code(
            "",
            "var found = 0u;\nswitch a {\n    case 1u, 2u: { found += 10u; }\n    default: { found += 20u; }\n    case \
             3u: { found += 30u; }\n    case 0xffffffffu: { found += 40u; }\n}\n",
        )
        .rule("WGSL 9.4: one case runs, without falling through to the next")
        .done(),
        Draft::new("early-return", "first(a, b)", pairs(), |[a, b]: [u32; 2]| {
            let places = (0..10).flat_map(|i| (0..10).map(move |j| (i, j)));
            places.into_iter().find(|(i, j)| i + j == a && j * i >= b).map_or(999, |(i, j)| 10 * i + j)
        })
        .code(EARLY, "")
        .rule("WGSL 9.4: return leaves all loops of the function")
        .done(),
        Draft::new("short-circuit", "calls + select(0u, 100u, both) + select(0u, 1000u, either)", pairs(), {
            |[a, b]: [u32; 2]| {
                let calls = u32::from(a > 5) + u32::from(a <= 5);
                calls + 100 * u32::from(a > 5 && b > 5) + 1000 * u32::from(a > 5 || b > 5)
            }
        })
        .code(COUNTED, "let both = a > 5u && is_large(b);\nlet either = a > 5u || is_large(b);\n")
        .rule("WGSL 8.6: && and || call the right side only if it decides")
        .done(),
        Draft::new("order-of-arguments", "a + 10u * two(next(), next())", (0..64).map(|a| [a]), |[a]: [u32; 1]| {
            a + 120
        })
        .code(ORDER, "")
        .rule("WGSL 15.1: arguments are evaluated from left to right")
        .done(),
    ]
}

const EARLY: &str = "fn first(a: u32, b: u32) -> u32 {\n    for (var i = 0u; i < 10u; i++) {\n        for (var j = 0u; j < \
                     10u; j++) {\n            if i + j == a && j * i >= b { return 10u * i + j; }\n        }\n    }\n    \
                     return 999u;\n}\n";
const COUNTED: &str = "var<private> calls: u32 = 0u;\nfn is_large(b: u32) -> bool {\n    calls += 1u;\n    return b > \
                       5u;\n}\n";
const ORDER: &str = "var<private> calls: u32 = 0u;\nfn next() -> u32 {\n    calls += 1u;\n    return calls;\n}\nfn \
                     two(x: u32, y: u32) -> u32 { return 10u * x + y; }\n";

fn workgroups() -> Vec<Probe> {
    // One workgroup with a case for each invocation.
    let cases = || (0..64).map(|a| [a * 3]);
    vec![
        Draft::new("workgroup-barrier", "shared_numbers[63u - id.x]", cases(), |[a]: [u32; 1]| 189 - a)
            .code(
                "var<workgroup> shared_numbers: array<u32, 64>;\n",
                "shared_numbers[id.x] = a;\nworkgroupBarrier();\n",
            )
            .rule("WGSL 17.11: all stores before the barrier are visible after it")
            .uniform()
            .done(),
        Draft::new("workgroup-zero", "a + shared_numbers[63u - id.x]", cases(), |[a]: [u32; 1]| a)
            .code("var<workgroup> shared_numbers: array<u32, 64>;\n", "")
            .rule("WGSL 7.3: variables of a workgroup are zero at the start")
            .uniform()
            .done(),
        Draft::new("atomic-add", "a + 1000u * atomicLoad(&total)", cases(), |[a]: [u32; 1]| a + 1000 * 6048)
            .code("var<workgroup> total: atomic<u32>;\n", "atomicAdd(&total, a);\nworkgroupBarrier();\n")
            .rule("WGSL 17.8: no addition is lost")
            .uniform()
            .done(),
        Draft::new("atomic-max", "a + 1000u * atomicLoad(&most)", cases(), |[a]: [u32; 1]| a + 1000 * 189)
            .code("var<workgroup> most: atomic<u32>;\n", "atomicMax(&most, a);\nworkgroupBarrier();\n")
            .rule("WGSL 17.8: no maximum is lost")
            .uniform()
            .done(),
    ]
}
