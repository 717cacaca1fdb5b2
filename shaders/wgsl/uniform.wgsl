// Random numbers from the words of a generator; twin of cpu/src/sampling/uniform.rs.
//
// A word is a number of 64 bits of std::mt19937_64. WGSL has no such integer, so `x` holds its lower and `y` its upper
// 32 bits.

// uniform::canonical: converts a word to a number in [0, 1): the word divided by 2^64, or the largest number below 1 if
// the quotient rounds to 1. In f64 both halves and the product are exact, so only the sum rounds. In f32 the conversion
// of a half rounds too.
fn uniform_canonical(word: vec2<u32>) -> real {
    let whole = real(word.y) * real(4294967296.0) + real(word.x);
    let quotient = whole / real(18446744073709551616.0);
    return select(BELOW_ONE, quotient, quotient < BELOW_ONE);
}

// Uniform::draw: converts a word to a number in [low, high).
fn uniform_draw(word: vec2<u32>, low: real, high: real) -> real {
    return uniform_canonical(word) * (high - low) + low;
}
