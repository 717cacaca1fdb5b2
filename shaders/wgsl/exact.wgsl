// Sums with their rounding error, for formulas that need more than one rounded operation; after Knuth, TAOCP 4.2.2,
// theorem B.
//
// WGSL allows a driver to replace (a + b) - a by b, and then the rounding error is lost. So these formulas need a
// driver that calculates as written (shaders/src/as_written.rs), or integers (shaders/src/lower.rs).

// A rounded sum and its error: `sum + error` is exactly `a + b`, unless the sum overflows.
struct ExactSum {
    sum: real,
    error: real,
}

// Returns what two_sum in gpu-check/src/first_difference/twins.rs returns.
fn exact_two_sum(a: real, b: real) -> ExactSum {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    return ExactSum(sum, (a - a_part) + (b - b_part));
}
