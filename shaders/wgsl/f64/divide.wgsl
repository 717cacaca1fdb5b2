// Quotients of binary64 numbers, by two digits of 28 bits each.
//
// Write a and b for the significands as integers of 53 bits, and n for a or 2a, whichever is in [b, 2b). The quotient
// floor(2^54 n / b) has 55 bits. Its digits are 2^27 n / b and 2^27 r / b, where r is the remainder of the first. A
// digit is taken too small rather than too large, and by less than 2. So the remainder stays below 2 b, and only the second
// digit is corrected.

// Returns a number R of at most 2^63 / (b + 1), which is smaller than 2^63 / b by less than 1 part in 2^28.6. `b` has
// its first bit set. The bound was checked for a third of all b.
fn u32_reciprocal(b: u32) -> u32 {
    // The first value is a linear approximation of 2^47 / b within 1/17. Each of the two Newton steps x (2 - d x)
    // squares the error, and gives less than 1/d. Here d is a little too large, so that x never is.
    let d = b >> 16u;
    var x = 92521u - ((d * 61681u) >> 16u);
    x = (x * ((0u - (d + 1u) * x) >> 16u)) >> 15u;
    x = (x * ((0u - (d + 1u) * x) >> 16u)) >> 15u;
    // The last step has 32 bits: x (1 + e + e^2), where e = 1 - b x is below 2^-13.
    let start = x << 16u;
    let e = 0x7fffffffu - u32_multiply_high(b, start);
    let correction = e + (((e >> 2u) * (e >> 2u)) >> 27u);
    return start + u32_multiply_high(start, correction << 1u) - 2u;
}

// Returns a digit of the quotient: 2^27 n / b, or up to 2 less. `reciprocal` belongs to the first 32 bits of b.
fn f64_quotient_digit(n: vec2<u32>, reciprocal: u32) -> u32 {
    let first = (n.x >> 22u) | (n.y << 10u);
    return u32_multiply_high(first, reciprocal) >> 3u;
}

// Returns 2^27 n - digit b, the remainder after a digit. It fits in 64 bits, though 2^27 n may not.
fn f64_quotient_rest(n: vec2<u32>, digit: u32, b: vec2<u32>) -> vec2<u32> {
    return u64_subtract(u64_shift_left(n, 27u), u64_multiply_word(b, digit));
}

fn f64_divide(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let sign = (a.y ^ b.y) & F64_SIGN;
    let a_parts = f64_parts(a);
    let b_parts = f64_parts(b);
    let dividend = u64_shift_right(a_parts.significand, 11u);
    let divisor = u64_shift_right(b_parts.significand, 11u);
    let is_small = u64_less(dividend, divisor);
    let n = u64_shift_left(dividend, select(0u, 1u, is_small));
    let reciprocal = u32_reciprocal(b_parts.significand.y);
    let first = f64_quotient_digit(n, reciprocal);
    let rest = f64_quotient_rest(n, first, divisor);
    let second = f64_quotient_digit(rest, reciprocal);
    let last = f64_quotient_rest(rest, second, divisor);
    let is_short = !u64_less(last, divisor);
    let end = select(last, u64_subtract(last, divisor), is_short);
    let quotient = u64_add(u64_shift_left(vec2<u32>(first, 0u), 27u), vec2<u32>(second + select(0u, 1u, is_short), 0u));
    let shifted = u64_shift_left(quotient, 9u);
    let sticky = select(0u, 1u, u64_some(end));
    let exponent = a_parts.exponent - b_parts.exponent + F64_BIAS - select(0, 1, is_small);
    let finite = f64_round(sign, F64Parts(exponent, vec2<u32>(shifted.x | sticky, shifted.y)));
    // What remains: NaN, infinity and zero, in either place.
    let a_infinite = f64_stored_exponent(a) == F64_SPECIAL;
    let b_infinite = f64_stored_exponent(b) == F64_SPECIAL;
    let a_zero = f64_is_zero(a);
    let b_zero = f64_is_zero(b);
    if f64_is_nan(a) || f64_is_nan(b) || (a_infinite && b_infinite) || (a_zero && b_zero) {
        return f64_nan();
    }
    let with_zero = select(finite, vec2<u32>(0u, sign), a_zero || b_infinite);
    return select(with_zero, f64_infinity(sign), a_infinite || b_zero);
}

// Returns the remainder as WGSL defines it: a - b trunc(a / b), where every operation is rounded.
fn f64_remainder(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return f64_subtract(a, f64_multiply(b, f64_trunc(f64_divide(a, b))));
}
