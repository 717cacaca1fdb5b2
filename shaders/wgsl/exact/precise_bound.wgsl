// The bound of error_bound.wgsl for formulas in double-double, whose unit roundoff is 2^-102. WGSL has no generic
// functions, so the formulas are written a second time.

// Decision<Option<DoubleDouble>>
struct PreciseDecision {
    certain: bool,
    some: bool,
    lambda: DoubleDouble,
    part: u32,
}

fn precise_uncertain() -> PreciseDecision {
    return PreciseDecision(false, false, dd_of(real(0.0)), SIDE);
}

fn precise_miss() -> PreciseDecision {
    return PreciseDecision(true, false, dd_of(real(0.0)), SIDE);
}

fn precise_hit(lambda: DoubleDouble, part: u32) -> PreciseDecision {
    return PreciseDecision(true, true, lambda, part);
}

// Limits, and LAMBDA_MIN times the largest relative error of an accepted lambda in the place of its two results.
struct PreciseLimits {
    error: real,
    share: real,
    lambda_error: real,
}

// ErrorBound<DoubleDouble>
struct PreciseBound {
    limits: PreciseLimits,
    size: DoubleDouble,
    error: DoubleDouble,
}

fn precise_bound_new(limits: PreciseLimits, length_squared: DoubleDouble, squares: DoubleDouble) -> PreciseBound {
    let size = dd_mul(length_squared, squares);
    return PreciseBound(limits, size, dd_add(dd_mul(size, dd_of(limits.error)), dd_of(ERROR_UNDERFLOW)));
}

fn precise_bound_misses(bound: PreciseBound, discriminant: DoubleDouble) -> bool {
    return dd_less(bound.error, dd_neg(discriminant));
}

fn precise_in_scale(length_squared: DoubleDouble) -> bool {
    let long_enough = dd_less_equal(dd_of(SHORTEST_SQUARED), length_squared);
    return long_enough && dd_less_equal(length_squared, dd_of(LONGEST_SQUARED));
}

// least_lambda: returns the smallest lambda of a hit that counts, LAMBDA_MIN - 2^-63. It is rounded to LAMBDA_MIN.
fn precise_least_lambda() -> DoubleDouble {
    return DoubleDouble(real(1e-3), real(-1.0842021724855044e-19));
}

// Limits::in_range: returns whether `lambda`, which must be accurate, certainly is at least `least_lambda`.
fn precise_in_range(limits: PreciseLimits, lambda: DoubleDouble) -> bool {
    return dd_less_equal(dd_add(precise_least_lambda(), dd_of(limits.lambda_error)), lambda);
}

fn precise_bound_is_too_small(
    bound: PreciseBound,
    a: DoubleDouble,
    numerator: DoubleDouble,
    root: DoubleDouble,
) -> bool {
    let least = dd_sub(precise_least_lambda(), dd_of(bound.limits.lambda_error));
    return dd_less(bound.error, dd_mul(dd_sub(dd_mul(a, least), numerator), root));
}

// Outcome<DoubleDouble>
struct PreciseOutcome {
    lambda: DoubleDouble,
    hits: bool,
    fails: bool,
}

fn precise_bound_root(
    bound: PreciseBound,
    a: DoubleDouble,
    numerator: DoubleDouble,
    root: DoubleDouble,
) -> PreciseOutcome {
    let lambda = dd_div(numerator, a);
    let share = bound.limits.share;
    let size = dd_add(dd_mul(bound.size, dd_of(share)), dd_of(ERROR_UNDERFLOW));
    let square = dd_mul(dd_mul(numerator, numerator), dd_of(share * real(4.0)));
    let accurate = dd_less(dd_add(size, square), dd_mul(root, numerator));
    let finite = dd_less(bound.size, dd_of(ERROR_OVERFLOW));
    let hits = accurate && finite && precise_in_range(bound.limits, lambda);
    return PreciseOutcome(lambda, hits, precise_bound_is_too_small(bound, a, numerator, root));
}
