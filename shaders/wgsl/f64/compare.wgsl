// Comparisons of binary64 numbers. A comparison with NaN is false, except that NaN is not equal to anything.

fn f64_equal(a: vec2<u32>, b: vec2<u32>) -> bool {
    return !f64_is_nan(a) && !f64_is_nan(b) && (all(a == b) || (f64_is_zero(a) && f64_is_zero(b)));
}

fn f64_not_equal(a: vec2<u32>, b: vec2<u32>) -> bool {
    return !f64_equal(a, b);
}

// Returns whether a comes before b, if -0 comes before +0. Neither is NaN.
fn f64_before(a: vec2<u32>, b: vec2<u32>) -> bool {
    let a_negative = a.y >= F64_SIGN;
    let b_negative = b.y >= F64_SIGN;
    // Of two negative numbers, the one with the larger magnitude comes first.
    let of_equal_sign = select(u64_less(a, b), u64_less(b, a), a_negative);
    return select(of_equal_sign, a_negative, a_negative != b_negative);
}

fn f64_less(a: vec2<u32>, b: vec2<u32>) -> bool {
    let are_zeros = f64_is_zero(a) && f64_is_zero(b);
    return !f64_is_nan(a) && !f64_is_nan(b) && !are_zeros && f64_before(a, b);
}

fn f64_less_equal(a: vec2<u32>, b: vec2<u32>) -> bool {
    let are_zeros = f64_is_zero(a) && f64_is_zero(b);
    return !f64_is_nan(a) && !f64_is_nan(b) && (are_zeros || !f64_before(b, a));
}

fn f64_greater(a: vec2<u32>, b: vec2<u32>) -> bool {
    return f64_less(b, a);
}

fn f64_greater_equal(a: vec2<u32>, b: vec2<u32>) -> bool {
    return f64_less_equal(b, a);
}

// Returns the smaller number; of a number and NaN the number; of two zeros -0, if it is one of them.
fn f64_min(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return select(a, b, f64_is_nan(a) || (!f64_is_nan(b) && f64_before(b, a)));
}

// Returns the larger number; of a number and NaN the number; of two zeros +0, if it is one of them.
fn f64_max(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return select(a, b, f64_is_nan(a) || (!f64_is_nan(b) && f64_before(a, b)));
}

fn f64_clamp(a: vec2<u32>, low: vec2<u32>, high: vec2<u32>) -> vec2<u32> {
    return f64_min(f64_max(a, low), high);
}

// Returns 1, -1 or 0; NaN for NaN.
fn f64_sign(a: vec2<u32>) -> vec2<u32> {
    let one = vec2<u32>(0u, 0x3ff00000u | (a.y & F64_SIGN));
    return select(select(one, vec2<u32>(), f64_is_zero(a)), f64_nan(), f64_is_nan(a));
}
