// Products of binary64 numbers.

fn f64_multiply(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let sign = (a.y ^ b.y) & F64_SIGN;
    let a_parts = f64_parts(a);
    let b_parts = f64_parts(b);
    let product = u64_multiply(a_parts.significand, b_parts.significand);
    // The product of two numbers in [1, 2) is in [1, 4), so its first bit is bit 127 or bit 126.
    let is_long = product.w >= 0x80000000u;
    let high = select(u64_shift_left(product.zw, 1u), product.zw, is_long);
    let sticky = select(0u, 1u, u64_some(product.xy));
    let exponent = a_parts.exponent + b_parts.exponent - F64_BIAS + select(0, 1, is_long);
    let finite = f64_round(sign, F64Parts(exponent, vec2<u32>(high.x | sticky, high.y)));
    let is_zero = f64_is_zero(a) || f64_is_zero(b);
    if max(f64_stored_exponent(a), f64_stored_exponent(b)) == F64_SPECIAL {
        // Zero times infinity is NaN.
        let is_nan = f64_is_nan(a) || f64_is_nan(b) || is_zero;
        return select(f64_infinity(sign), f64_nan(), is_nan);
    }
    return select(finite, vec2<u32>(0u, sign), is_zero);
}
