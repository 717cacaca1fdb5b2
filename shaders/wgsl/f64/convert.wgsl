// Conversions between binary64 numbers and numbers of 32 bits.

// Returns `sign` and n 2^(exponent - 1054), where bit 31 of n is set. The value has a binary64 number.
fn f64_from_word(sign: u32, exponent: u32, n: u32) -> vec2<u32> {
    return vec2<u32>(n << 21u, sign | (((exponent - 1u) << 20u) + (n >> 11u)));
}

fn f64_from_u32(a: u32) -> vec2<u32> {
    let zeros = countLeadingZeros(a);
    return select(f64_from_word(0u, 1054u - zeros, a << (zeros & 31u)), vec2<u32>(), a == 0u);
}

fn f64_from_i32(a: i32) -> vec2<u32> {
    let word = u32(a);
    let is_negative = a < 0;
    let magnitude = f64_from_u32(select(word, 0u - word, is_negative));
    return vec2<u32>(magnitude.x, magnitude.y | select(0u, F64_SIGN, is_negative));
}

fn f64_from_f32(a: f32) -> vec2<u32> {
    let word = bitcast<u32>(a);
    let sign = word & F64_SIGN;
    let exponent = (word >> 23u) & 0xffu;
    let fraction = word & 0x7fffffu;
    if exponent == 0xffu {
        return vec2<u32>(fraction << 29u, sign | F64_EXPONENT | (fraction >> 3u));
    }
    if exponent == 0u {
        // A subnormal number is fraction 2^-149.
        let zeros = countLeadingZeros(fraction);
        let number = f64_from_word(sign, 1023u - 149u + 31u - zeros, fraction << (zeros & 31u));
        return select(number, vec2<u32>(0u, sign), fraction == 0u);
    }
    return f64_from_word(sign, exponent + 1023u - 127u, (fraction | 0x800000u) << 8u);
}

fn f64_from_bool(a: bool) -> vec2<u32> {
    return vec2<u32>(0u, select(0u, 0x3ff00000u, a));
}

// Returns the nearest f32; of two that are as near, the even one.
fn f64_to_f32(a: vec2<u32>) -> f32 {
    let sign = a.y & F64_SIGN;
    let parts = f64_parts(a);
    let exponent = parts.exponent - F64_BIAS + 127;
    let significand = parts.significand.y | select(0u, 1u, parts.significand.x != 0u);
    // A subnormal number has fewer bits. Without any bits it is 0.
    let shift = u32(clamp(1 - exponent, 0, 31));
    let shifted = significand >> shift;
    let sticky = select(1u, 0u, (shifted << shift) == significand);
    let kept = shifted >> 8u;
    let lost = (shifted & 0xffu) | sticky;
    let up = lost > 0x80u || (lost == 0x80u && (kept & 1u) != 0u);
    let rounded = (u32(clamp(exponent, 1, 255) - 1) << 23u) + kept + select(0u, 1u, up);
    let finite = select(rounded, 0x7f800000u, exponent >= 255);
    let special = select(0x7f800000u, 0x7fc00000u, f64_is_nan(a));
    return bitcast<f32>(sign | select(finite, special, f64_stored_exponent(a) == F64_SPECIAL));
}

// Returns the whole part of the magnitude, or 2^32 - 1 if it is larger. NaN gives 0.
fn f64_whole_word(a: vec2<u32>) -> u32 {
    let exponent = i32(f64_stored_exponent(a)) - F64_BIAS;
    // The first 32 bits of the significand.
    let significand = f64_significand(a);
    let first_bits = (significand.y << 11u) | (significand.x >> 21u);
    let whole = select(first_bits >> u32(clamp(31 - exponent, 0, 31)), 0u, exponent < 0);
    return select(select(whole, 0xffffffffu, exponent > 31), 0u, f64_is_nan(a));
}

// Returns the whole part, or the nearest u32. NaN gives 0.
fn f64_to_u32(a: vec2<u32>) -> u32 {
    return select(f64_whole_word(a), 0u, a.y >= F64_SIGN);
}

// Returns the whole part, or the nearest i32. NaN gives 0.
fn f64_to_i32(a: vec2<u32>) -> i32 {
    let whole = f64_whole_word(a);
    let positive = min(whole, 0x7fffffffu);
    let negative = 0u - min(whole, 0x80000000u);
    return i32(select(positive, negative, a.y >= F64_SIGN));
}

fn f64_to_bool(a: vec2<u32>) -> bool {
    return !f64_is_zero(a);
}
