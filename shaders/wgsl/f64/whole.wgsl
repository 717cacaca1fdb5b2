// Whole numbers near a binary64 number.
//
// The bits after the binary point are the last 52 - E bits, where E is the exponent. To add one of the whole number's
// last bit, the bits of the number are taken as an integer: a carry leads to the next exponent, as it must.

// The bits of a number after the binary point, for magnitudes of at least 1.
struct F64Fraction {
    // Whether the magnitude is below 1, so that no bit is before the point.
    is_below_one: bool,
    // The bits before the point, and sign and exponent. All bits if the magnitude is 2^52 or more, or for NaN.
    whole_bits: vec2<u32>,
}

fn f64_fraction(a: vec2<u32>) -> F64Fraction {
    let exponent = i32(f64_stored_exponent(a)) - F64_BIAS;
    let count = u32(clamp(52 - exponent, 0, 52));
    return F64Fraction(exponent < 0, u64_shift_left(vec2<u32>(0xffffffffu, 0xffffffffu), count));
}

fn f64_trunc(a: vec2<u32>) -> vec2<u32> {
    let fraction = f64_fraction(a);
    return select(a & fraction.whole_bits, vec2<u32>(0u, a.y & F64_SIGN), fraction.is_below_one);
}

// Returns the next whole number of the same sign whose magnitude is not smaller.
fn f64_away(a: vec2<u32>) -> vec2<u32> {
    let fraction = f64_fraction(a);
    let next = u64_add(a, ~fraction.whole_bits) & fraction.whole_bits;
    let one = vec2<u32>(0u, 0x3ff00000u | (a.y & F64_SIGN));
    return select(next, select(one, a, f64_is_zero(a)), fraction.is_below_one);
}

fn f64_floor(a: vec2<u32>) -> vec2<u32> {
    return select(f64_trunc(a), f64_away(a), a.y >= F64_SIGN);
}

fn f64_ceil(a: vec2<u32>) -> vec2<u32> {
    return select(f64_away(a), f64_trunc(a), a.y >= F64_SIGN);
}

// Returns the nearest whole number; of two that are as near, the even one.
fn f64_round_even(a: vec2<u32>) -> vec2<u32> {
    let fraction = f64_fraction(a);
    let below_point = ~fraction.whole_bits;
    // The last bit before the point. For magnitudes in [1, 2) it is the last bit of the exponent 1023, which is set as
    // the implicit bit is.
    let unit = u64_add(below_point, vec2<u32>(1u, 0u));
    let is_odd = u64_some(a & unit);
    // Just below half of a unit, and half of a unit if the number before the point is odd.
    let half = u64_shift_right(below_point, 1u);
    let added = u64_add(half, vec2<u32>(select(0u, 1u, is_odd && u64_some(below_point)), 0u));
    let rounded = u64_add(a, added) & fraction.whole_bits;
    let sign = a.y & F64_SIGN;
    let is_over_half = u64_less(vec2<u32>(0u, 0x3fe00000u), f64_magnitude(a));
    let small = select(vec2<u32>(0u, sign), vec2<u32>(0u, sign | 0x3ff00000u), is_over_half);
    return select(rounded, small, fraction.is_below_one);
}

// Returns a - floor(a).
fn f64_fract(a: vec2<u32>) -> vec2<u32> {
    return f64_subtract(a, f64_floor(a));
}
