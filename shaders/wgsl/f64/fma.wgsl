// The fused product and sum of binary64 numbers, which is rounded once.
//
// The exact product has 106 bits. It and the other term are aligned as integers of 128 bits, the lowest word first.

fn u128_add(a: vec4<u32>, b: vec4<u32>) -> vec4<u32> {
    let low = u64_add(a.xy, b.xy);
    let carry = select(0u, 1u, u64_less(low, a.xy));
    return vec4<u32>(low, u64_add(u64_add(a.zw, b.zw), vec2<u32>(carry, 0u)));
}

fn u128_subtract(a: vec4<u32>, b: vec4<u32>) -> vec4<u32> {
    let borrow = select(0u, 1u, u64_less(a.xy, b.xy));
    return vec4<u32>(u64_subtract(a.xy, b.xy), u64_subtract(u64_subtract(a.zw, b.zw), vec2<u32>(borrow, 0u)));
}

fn u128_less(a: vec4<u32>, b: vec4<u32>) -> bool {
    return u64_less(a.zw, b.zw) || (all(a.zw == b.zw) && u64_less(a.xy, b.xy));
}

// Returns a 2^n, modulo 2^128. `n` is at most 127.
fn u128_shift_left(a: vec4<u32>, n: u32) -> vec4<u32> {
    let within = n & 63u;
    let moved = u64_shift_right(u64_shift_right(a.xy, 1u), 63u - within);
    let low = u64_shift_left(a.xy, within);
    let short = vec4<u32>(low, u64_shift_left(a.zw, within) | moved);
    return select(short, vec4<u32>(0u, 0u, low), n >= 64u);
}

// Returns the whole part of a / 2^n, with the last bit set if a bit that is not 0 is lost. `n` may be any number.
fn u128_shift_right_sticky(a: vec4<u32>, n: u32) -> vec4<u32> {
    let amount = min(n, 127u);
    let within = amount & 63u;
    let moved = u64_shift_left(u64_shift_left(a.zw, 1u), 63u - within);
    let high = u64_shift_right(a.zw, within);
    let short = vec4<u32>(u64_shift_right(a.xy, within) | moved, high);
    let kept = select(short, vec4<u32>(high, 0u, 0u), amount >= 64u);
    let is_exact = all(u128_shift_left(kept, amount) == a);
    return vec4<u32>(kept.x | select(1u, 0u, is_exact), kept.yzw);
}

// Returns a b + c.
fn f64_fma(a: vec2<u32>, b: vec2<u32>, c: vec2<u32>) -> vec2<u32> {
    let a_parts = f64_parts(a);
    let b_parts = f64_parts(b);
    let c_parts = f64_parts(c);
    let product_sign = (a.y ^ b.y) & F64_SIGN;
    let c_sign = c.y & F64_SIGN;
    let product_zero = f64_is_zero(a) || f64_is_zero(b);
    // The exponent is that of bit 127. Only the product may have its first bit in bit 126.
    let long = u64_multiply(a_parts.significand, b_parts.significand);
    let is_long = long.w >= 0x80000000u;
    let product = select(u128_shift_left(long, 1u), long, is_long);
    let product_exponent =
        select(a_parts.exponent + b_parts.exponent - F64_BIAS + select(0, 1, is_long), -100000, product_zero);
    let c_exponent = select(c_parts.exponent, -100000, f64_is_zero(c));
    let other = vec4<u32>(0u, 0u, c_parts.significand);
    let is_swapped = c_exponent > product_exponent || (c_exponent == product_exponent && u128_less(product, other));
    let exponent = select(product_exponent, c_exponent, is_swapped);
    let distance = u32(abs(product_exponent - c_exponent));
    // Bit 127 takes a carry.
    let larger = u128_shift_right_sticky(select(product, other, is_swapped), 1u);
    let smaller = u128_shift_right_sticky(select(other, product, is_swapped), min(distance, 1000u) + 1u);
    let subtracts = product_sign != c_sign;
    let sum = select(u128_add(larger, smaller), u128_subtract(larger, smaller), subtracts);
    let zeros = select(u64_leading_zeros(sum.zw), 64u + u64_leading_zeros(sum.xy), !u64_some(sum.zw));
    let shifted = u128_shift_left(sum, min(zeros, 127u));
    let sticky = select(0u, 1u, u64_some(shifted.xy));
    let parts = F64Parts(exponent + 1 - i32(zeros), vec2<u32>(shifted.z | sticky, shifted.w));
    let rounded = f64_round(select(product_sign, c_sign, is_swapped), parts);
    // A sum of zero has a sign only if both terms have it.
    let is_zero = !u64_some(sum.zw) && !u64_some(sum.xy);
    let finite = select(rounded, vec2<u32>(0u, product_sign & c_sign), is_zero);
    let product_special = max(f64_stored_exponent(a), f64_stored_exponent(b)) == F64_SPECIAL;
    let c_special = f64_stored_exponent(c) == F64_SPECIAL;
    if product_special || c_special {
        let is_nan = f64_is_nan(a) || f64_is_nan(b) || f64_is_nan(c) || (product_special && product_zero)
            || (product_special && c_special && subtracts);
        let infinity = f64_infinity(select(c_sign, product_sign, product_special));
        return select(infinity, f64_nan(), is_nan);
    }
    return finite;
}
