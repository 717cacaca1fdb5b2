// Square roots of binary64 numbers, by two digits of 27 bits each.
//
// Write m for the significand as an integer of 53 or 54 bits, such that the exponent that remains is even. The root
// s = floor(sqrt(2^54 m)) has 54 bits. Its first digit s1 is floor(sqrt(m)), and r = m - s1^2 is what remains. The
// second digit is 2^26 r / sqrt(m), or up to 3 less.

// Returns a number Y of at most 2^31 / sqrt((w + 1) / 2^32), which is smaller than 2^31 / sqrt(w / 2^32) by less than 1
// part in 2^27.2. `w` is at least 2^30. The bound was checked for one in 17 of all w.
fn u32_reciprocal_root(w: u32) -> u32 {
    // A quadratic approximation within 1/41, then a Newton step y (3 - w y^2) / 2, which gives no more than the
    // reciprocal root. Here w and y^2 are a little too large, so that y never is.
    let short = w >> 16u;
    let slope = 107655u - ((53693u * short) >> 16u);
    let y = 87518u - ((slope * short) >> 16u);
    let product = (short + 1u) * (((y * y) >> 16u) + 1u);
    let start = ((y * ((0xc0000000u - product) >> 16u)) >> 15u) << 16u;
    // The last step has 32 bits: y (1 + e/2 + 3/8 e^2), where e = 1 - w y^2 is below 2^-8.
    let e = 0x40000000u - u32_multiply_high(w, u32_multiply_high(start, start));
    let correction = (e >> 1u) + ((3u * (e >> 6u) * (e >> 6u)) >> 21u);
    return start + u32_multiply_high(start, correction << 2u) - 5u;
}

// Returns 2 s + 1, which is (s + 1)^2 - s^2.
fn f64_root_step(s: vec2<u32>) -> vec2<u32> {
    return vec2<u32>((s.x << 1u) | 1u, (s.y << 1u) | (s.x >> 31u));
}

fn f64_sqrt(a: vec2<u32>) -> vec2<u32> {
    let parts = f64_parts(a);
    // The bias is odd, so an even biased exponent is an odd exponent.
    let is_odd = (parts.exponent & 1) == 0;
    let m = u64_shift_right(parts.significand, select(11u, 10u, is_odd));
    let first_bits = (m.x >> 22u) | (m.y << 10u);
    let reciprocal = u32_reciprocal_root(first_bits);
    // The first digit is at most 1 too small. Its remainder is below 2^29, so its low word is all of it.
    let estimate = u32_multiply_high(first_bits, reciprocal) >> 4u;
    let estimate_rest = m.x - estimate * estimate;
    let is_short = estimate_rest > 2u * estimate;
    let first = estimate + select(0u, 1u, is_short);
    let rest = estimate_rest - select(0u, 2u * estimate + 1u, is_short);
    let second = u32_multiply_high(rest, reciprocal);
    // 2^54 r - 2^28 s1 s2 - s2^2, the remainder after both digits. It fits in 64 bits, though 2^54 r does not.
    let cross = u64_shift_left(u32_multiply(first, second), 28u);
    var remainder = u64_subtract(u64_subtract(vec2<u32>(0u, rest << 22u), cross), u32_multiply(second, second));
    var root = u64_add(u64_shift_left(vec2<u32>(first, 0u), 27u), vec2<u32>(second, 0u));
    // The second digit is at most 2 too small.
    let step = f64_root_step(root);
    let one_more = !u64_less(remainder, step);
    remainder = select(remainder, u64_subtract(remainder, step), one_more);
    root = select(root, u64_add(root, vec2<u32>(1u, 0u)), one_more);
    let next_step = f64_root_step(root);
    let two_more = !u64_less(remainder, next_step);
    remainder = select(remainder, u64_subtract(remainder, next_step), two_more);
    root = select(root, u64_add(root, vec2<u32>(1u, 0u)), two_more);
    let shifted = u64_shift_left(root, 10u);
    let sticky = select(0u, 1u, u64_some(remainder));
    // Half of the exponent, rounded down.
    let exponent = ((parts.exponent - F64_BIAS) >> 1u) + F64_BIAS;
    let finite = f64_round(0u, F64Parts(exponent, vec2<u32>(shifted.x | sticky, shifted.y)));
    // The root of a zero is that zero.
    if f64_is_zero(a) || all(a == f64_infinity(0u)) {
        return a;
    }
    return select(finite, f64_nan(), f64_is_nan(a) || a.y >= F64_SIGN);
}
