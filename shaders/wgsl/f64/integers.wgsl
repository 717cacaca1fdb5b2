// Unsigned integers of 64 bits, as two words: `x` is the low word and `y` is the high word.
//
// WGSL defines no shift by 32 or more, so every shift here has an amount of at most 31.

// Returns a + b, modulo 2^64.
fn u64_add(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let low = a.x + b.x;
    return vec2<u32>(low, a.y + b.y + select(0u, 1u, low < a.x));
}

// Returns a - b, modulo 2^64.
fn u64_subtract(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(a.x - b.x, a.y - b.y - select(0u, 1u, a.x < b.x));
}

// Returns whether a < b.
fn u64_less(a: vec2<u32>, b: vec2<u32>) -> bool {
    return a.y < b.y || (a.y == b.y && a.x < b.x);
}

// Returns whether a is not 0.
fn u64_some(a: vec2<u32>) -> bool {
    return (a.x | a.y) != 0u;
}

// Returns a 2^n, modulo 2^64. `n` is at most 63.
fn u64_shift_left(a: vec2<u32>, n: u32) -> vec2<u32> {
    let within = n & 31u;
    // The bits that move from the low word to the high word. A shift by 1 and a shift by up to 31 replace a shift by
    // up to 32.
    let moved = (a.x >> 1u) >> (31u - within);
    let low = a.x << within;
    return select(vec2<u32>(low, (a.y << within) | moved), vec2<u32>(0u, low), n >= 32u);
}

// Returns the whole part of a / 2^n. `n` is at most 63.
fn u64_shift_right(a: vec2<u32>, n: u32) -> vec2<u32> {
    let within = n & 31u;
    let moved = (a.y << 1u) << (31u - within);
    let high = a.y >> within;
    return select(vec2<u32>((a.x >> within) | moved, high), vec2<u32>(high, 0u), n >= 32u);
}

// Returns the whole part of a / 2^n. If a bit that is not 0 is lost, the last bit of the result is set. That is all
// that rounding must know of the lost bits. `n` may be any number.
fn u64_shift_right_sticky(a: vec2<u32>, n: u32) -> vec2<u32> {
    // A shift by more than 63 gives the result of a shift by 63: the last bit is set, unless a is 0.
    let amount = min(n, 63u);
    let kept = u64_shift_right(a, amount);
    let is_exact = all(u64_shift_left(kept, amount) == a);
    return vec2<u32>(kept.x | select(1u, 0u, is_exact), kept.y);
}

// Returns the number of zero bits before the first bit that is set; 64 for 0.
fn u64_leading_zeros(a: vec2<u32>) -> u32 {
    return select(countLeadingZeros(a.y), 32u + countLeadingZeros(a.x), a.y == 0u);
}

// Returns a b with all 64 bits, from products of 16-bit halves.
fn u32_multiply(a: u32, b: u32) -> vec2<u32> {
    let a_low = a & 0xffffu;
    let a_high = a >> 16u;
    let b_low = b & 0xffffu;
    let b_high = b >> 16u;
    // Neither sum overflows: (2^16 - 1)^2 + 2^16 - 1 < 2^32.
    let first = a_high * b_low + ((a_low * b_low) >> 16u);
    let second = a_low * b_high + (first & 0xffffu);
    return vec2<u32>(a * b, a_high * b_high + (first >> 16u) + (second >> 16u));
}

// Returns the high word of a b.
fn u32_multiply_high(a: u32, b: u32) -> u32 {
    return u32_multiply(a, b).y;
}

// Returns a b, modulo 2^64.
fn u64_multiply_word(a: vec2<u32>, b: u32) -> vec2<u32> {
    let low = u32_multiply(a.x, b);
    return vec2<u32>(low.x, low.y + a.y * b);
}

// Returns a b with all 128 bits, the lowest word first.
fn u64_multiply(a: vec2<u32>, b: vec2<u32>) -> vec4<u32> {
    let low = u32_multiply(a.x, b.x);
    let cross = u32_multiply(a.y, b.x);
    let other = u32_multiply(a.x, b.y);
    let high = u32_multiply(a.y, b.y);
    // Neither sum overflows: (2^32 - 1)^2 + 2^32 - 1 < 2^64.
    let first = u64_add(cross, vec2<u32>(low.y, 0u));
    let second = u64_add(other, vec2<u32>(first.x, 0u));
    let top = u64_add(u64_add(high, vec2<u32>(first.y, 0u)), vec2<u32>(second.y, 0u));
    return vec4<u32>(low.x, second.x, top.x, top.y);
}
