// Sums with their rounding error, for formulas that need more than one rounded operation; after Knuth, TAOCP 4.2.2,
// theorem B.
//
// WGSL allows a driver to replace (a + b) - a by b, and lavapipe does so: the rounding error would be lost. The barrier
// against it is `one`, a factor 1 that is loaded at run time. The driver then finds the product `a * one` where it
// looks for `a`, so it keeps the operations. Multiplying by one is exact. A self-test (gpu_check::rewrites) finds out
// whether the barrier works with a driver.

// A rounded sum and its error: `sum + error` is exactly `a + b`, unless the sum overflows.
struct ExactSum {
    sum: real,
    error: real,
}

// Returns what two_sum in gpu-check/src/kernels/barrier.rs returns, but computes it with the barrier.
fn exact_two_sum(a: real, b: real, one: real) -> ExactSum {
    let sum = a * one + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    return ExactSum(sum, (a - a_part) + (b - b_part));
}
