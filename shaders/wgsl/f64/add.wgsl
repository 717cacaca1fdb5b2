// Sums and differences of binary64 numbers.

fn f64_negate(a: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(a.x, a.y ^ F64_SIGN);
}

fn f64_abs(a: vec2<u32>) -> vec2<u32> {
    return f64_magnitude(a);
}

fn f64_add(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let is_swapped = u64_less(f64_magnitude(a), f64_magnitude(b));
    let large = select(a, b, is_swapped);
    let small = select(b, a, is_swapped);
    let large_exponent = max(f64_stored_exponent(large), 1u);
    let small_exponent = max(f64_stored_exponent(small), 1u);
    // Bit 62 is the first bit of a normal number. Bit 63 takes a carry, and ten bits after the significand are enough
    // to round correctly: if the first bit cancels and more of them follow, the difference is exact.
    let larger = u64_shift_left(f64_significand(large), 10u);
    let smaller =
        u64_shift_right_sticky(u64_shift_left(f64_significand(small), 10u), large_exponent - small_exponent);
    let subtracts = ((a.y ^ b.y) & F64_SIGN) != 0u;
    let sum = select(u64_add(larger, smaller), u64_subtract(larger, smaller), subtracts);
    let zeros = u64_leading_zeros(sum);
    let exponent = i32(large_exponent) + 1 - i32(zeros);
    let rounded = f64_round(large.y & F64_SIGN, F64Parts(exponent, u64_shift_left(sum, min(zeros, 63u))));
    // A sum of zero has a sign only if both terms have it.
    let finite = select(rounded, vec2<u32>(0u, a.y & b.y & F64_SIGN), !u64_some(sum));
    if large_exponent == F64_SPECIAL {
        // The magnitude of NaN is greater than that of infinity, so `large` is NaN if one of the two is.
        let is_nan = f64_is_nan(large) || (subtracts && small_exponent == F64_SPECIAL);
        return select(large, f64_nan(), is_nan);
    }
    return finite;
}

fn f64_subtract(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return f64_add(a, f64_negate(b));
}
