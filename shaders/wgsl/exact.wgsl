// Sums with their rounding error, for formulas that need more than one rounded operation; after Knuth, TAOCP 4.2.2,
// theorem B.
//
// WGSL gives a driver leave to treat (a + b) - a as b, and lavapipe does. `one` is the barrier: a number that is one,
// but loaded at run time, so that the driver meets a product where it looks for `a`, and keeps the operations.
// Multiplying by one is exact. Whether a driver lets itself be held up so is found out by a self-test
// (gpu_check::rewrites).

// `sum + error` is `a + b` exactly, short of overflow.
struct ExactSum {
    sum: real,
    error: real,
}

fn exact_two_sum(a: real, b: real, one: real) -> ExactSum {
    let sum = a * one + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    return ExactSum(sum, (a - a_part) + (b - b_part));
}
