// The bound of the rounding errors in a quadratic's roots, in one precision; twin of cpu/src/exact/error_bound.rs,
// which names `u`, `M` and the other quantities. docs/accuracy.md derives the bounds.

// Decision: the answer of a floating-point filter. Without `certain` the other fields have no meaning. `some` tells
// whether there is a hit.
struct Decision {
    certain: bool,
    some: bool,
    lambda: real,
    part: u32,
}

fn decision_uncertain() -> Decision {
    return Decision(false, false, real(0.0), SIDE);
}

fn decision_miss() -> Decision {
    return Decision(true, false, real(0.0), SIDE);
}

fn decision_hit(lambda: real, part: u32) -> Decision {
    return Decision(true, true, lambda, part);
}

// Limits: the constants of one kind of surface.
struct Limits {
    // The bound of the discriminant's error in units of `M`.
    error: real,
    // The reciprocal of the condition limit.
    share: real,
    // LAMBDA_MIN, lowered and raised by the largest relative error of an accepted lambda.
    least: real,
    most: real,
}

// in_scale: returns whether the square of a direction's length is from 2^-300 to 2^300.
fn exact_in_scale(length_squared: real) -> bool {
    return SHORTEST_SQUARED <= length_squared && length_squared <= LONGEST_SQUARED;
}

// ErrorBound: the bound for one ray and one object.
struct ErrorBound {
    limits: Limits,
    size: real,
    error: real,
    // No product of the formulas overflows. Otherwise nothing is certain.
    finite: bool,
}

// ErrorBound::of_size: returns the bound of a discriminant whose terms have this size. `whole` is `M`, and `squares` is
// `|O - C|^2 + r^2`.
fn error_bound_of_size(limits: Limits, size: real, whole: real, squares: real) -> ErrorBound {
    let finite = whole < ERROR_OVERFLOW && squares < ERROR_OVERFLOW;
    return ErrorBound(limits, size, size * limits.error + ERROR_UNDERFLOW, finite);
}

// ErrorBound::misses: returns whether the line certainly misses the surface.
fn error_bound_misses(bound: ErrorBound, discriminant: real) -> bool {
    return bound.finite && bound.error < -discriminant;
}

// ErrorBound::is_too_small: returns whether `numerator / a` certainly is below LAMBDA_MIN.
fn error_bound_is_too_small(bound: ErrorBound, a: real, numerator: real, root: real) -> bool {
    return bound.finite && bound.error < (a * bound.limits.least - numerator) * root;
}

// Outcome: what is certain about one root or one disc.
struct Outcome {
    lambda: real,
    hits: bool,
    fails: bool,
}

// ErrorBound::root: returns the lambda `numerator / a`, and what is certain about it. `root` is the square root of the
// discriminant.
fn error_bound_root(bound: ErrorBound, a: real, numerator: real, root: real) -> Outcome {
    let lambda = numerator / a;
    let share = bound.limits.share;
    let least = (bound.size * share + ERROR_UNDERFLOW) + numerator * numerator * (share * real(4.0));
    let accurate = least < root * numerator;
    let hits = accurate && bound.finite && bound.limits.most <= lambda;
    return Outcome(lambda, hits, error_bound_is_too_small(bound, a, numerator, root));
}
