// The parts of a binary64 number (IEEE 754), and the rounding of a result.
//
// A number is a vec2<u32>, the low word first. The high word has the sign in bit 31, the biased exponent in bits 20 to
// 30, and the first 20 bits of the fraction.

const F64_SIGN: u32 = 0x80000000u;
const F64_EXPONENT: u32 = 0x7ff00000u;
// The bit of a normal number's significand that is not stored.
const F64_IMPLICIT: u32 = 0x00100000u;
// The biased exponent of infinity and NaN.
const F64_SPECIAL: u32 = 0x7ffu;
// The biased exponent of 1.
const F64_BIAS: i32 = 1023;

fn f64_infinity(sign: u32) -> vec2<u32> {
    return vec2<u32>(0u, sign | F64_EXPONENT);
}

fn f64_nan() -> vec2<u32> {
    return vec2<u32>(0u, 0x7ff80000u);
}

fn f64_magnitude(a: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(a.x, a.y & ~F64_SIGN);
}

fn f64_is_nan(a: vec2<u32>) -> bool {
    return u64_less(vec2<u32>(0u, F64_EXPONENT), f64_magnitude(a));
}

fn f64_is_zero(a: vec2<u32>) -> bool {
    return !u64_some(f64_magnitude(a));
}

// Returns the biased exponent as it is stored.
fn f64_stored_exponent(a: vec2<u32>) -> u32 {
    return (a.y >> 20u) & F64_SPECIAL;
}

// Returns the significand as an integer of up to 53 bits.
fn f64_significand(a: vec2<u32>) -> vec2<u32> {
    let implicit = select(F64_IMPLICIT, 0u, f64_stored_exponent(a) == 0u);
    return vec2<u32>(a.x, (a.y & 0xfffffu) | implicit);
}

// A finite number other than 0 without its sign: `significand` 2^(exponent - 1086), where bit 63 of the significand is
// set. `exponent` is the biased exponent, and for a subnormal number what it would be without a lower limit.
struct F64Parts {
    exponent: i32,
    significand: vec2<u32>,
}

fn f64_parts(a: vec2<u32>) -> F64Parts {
    let significand = f64_significand(a);
    let zeros = u64_leading_zeros(significand);
    let exponent = i32(max(f64_stored_exponent(a), 1u)) + 11 - i32(zeros);
    return F64Parts(exponent, u64_shift_left(significand, min(zeros, 63u)));
}

// Returns the number nearest to the value of the parts, with the given sign bit; of two that are as near, the even one.
// The last bit of the significand may stand for any number of lower bits (u64_shift_right_sticky).
fn f64_round(sign: u32, parts: F64Parts) -> vec2<u32> {
    // A subnormal number has fewer bits: the exponent is raised to 1, and the significand is shifted.
    let shift = u32(max(1 - parts.exponent, 0));
    let shifted = u64_shift_right_sticky(parts.significand, shift);
    let kept = vec2<u32>((shifted.x >> 11u) | (shifted.y << 21u), shifted.y >> 11u);
    let lost = shifted.x & 0x7ffu;
    let up = lost > 0x400u || (lost == 0x400u && (kept.x & 1u) != 0u);
    // The implicit bit of a normal number adds 1 to the exponent, and so does a significand that is rounded up to a
    // power of two. From the largest number this leads to infinity.
    let exponent = u32(max(parts.exponent, 1) - 1) << 20u;
    let rounded = u64_add(vec2<u32>(kept.x, kept.y + exponent), vec2<u32>(select(0u, 1u, up), 0u));
    let overflows = parts.exponent >= i32(F64_SPECIAL);
    return select(vec2<u32>(rounded.x, rounded.y | sign), f64_infinity(sign), overflows);
}
