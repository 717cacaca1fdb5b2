// Sums with their rounding error, for formulas that need more than one rounded operation; after Knuth, TAOCP 4.2.2,
// theorem B.
//
// WGSL gives a driver leave to treat (a + b) - a as b, and lavapipe does. `one` is the barrier: a number that is one, but
// loaded at run time, so that the driver sees a product it cannot remove. Multiplying by one is exact.

// `sum + error` is `a + b` exactly, short of overflow.
struct ExactSum {
    sum: real,
    error: real,
}

fn exact_two_sum(a: real, b: real, one: real) -> ExactSum {
    let sum = a * one + b;
    let b_part = sum * one - a;
    let a_part = sum - b_part * one;
    let a_error = a - a_part * one;
    let b_error = b - b_part * one;
    return ExactSum(sum, a_error + b_error);
}
