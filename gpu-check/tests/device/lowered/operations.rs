//! The operations on f64 that are compared, in WGSL and in Rust.

use super::operands::Operands;

/// The type of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A number of type f64.
    Number,
    /// A word of type u32.
    Word,
}

impl Outcome {
    /// Returns the number of bytes of a result.
    pub const fn size(self) -> usize {
        match self {
            Self::Number => 8,
            Self::Word => 4,
        }
    }
}

/// An operation on the numbers `a`, `b` and `c` and the word `word`.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    /// The operation in WGSL.
    pub wgsl: &'static str,
    /// The type of the result in WGSL.
    pub outcome: Outcome,
    /// Whether the word has the bits of an f32, so that all NaN are equal.
    pub is_single: bool,
    /// Returns the bits of the result in Rust.
    pub truth: fn(&Operands) -> u64,
}

impl Operation {
    const fn number(wgsl: &'static str, truth: fn(&Operands) -> u64) -> Self {
        Self { wgsl, outcome: Outcome::Number, is_single: false, truth }
    }

    const fn word(wgsl: &'static str, truth: fn(&Operands) -> u64) -> Self {
        Self { wgsl, outcome: Outcome::Word, is_single: false, truth }
    }
}

/// The operations of the arithmetic, each alone.
pub const BASIC: [Operation; 28] = [
    Operation::number("a + b", |c| (c.a + c.b).to_bits()),
    Operation::number("a - b", |c| (c.a - c.b).to_bits()),
    Operation::number("a * b", |c| (c.a * c.b).to_bits()),
    Operation::number("a / b", |c| (c.a / c.b).to_bits()),
    Operation::number("sqrt(a)", |c| c.a.sqrt().to_bits()),
    Operation::number("fma(a, b, c)", |c| c.a.mul_add(c.b, c.c).to_bits()),
    Operation::number("a % b", |c| (c.a - c.b * (c.a / c.b).trunc()).to_bits()),
    Operation::number("-a", |c| (-c.a).to_bits()),
    Operation::number("abs(a)", |c| c.a.abs().to_bits()),
    Operation::number("floor(a)", |c| c.a.floor().to_bits()),
    Operation::number("ceil(a)", |c| c.a.ceil().to_bits()),
    Operation::number("trunc(a)", |c| c.a.trunc().to_bits()),
    Operation::number("round(a)", |c| c.a.round_ties_even().to_bits()),
    Operation::number("fract(a)", |c| (c.a - c.a.floor()).to_bits()),
    Operation::number("sign(a)", |c| sign(c.a).to_bits()),
    Operation::number("min(a, b)", |c| smaller(c.a, c.b).to_bits()),
    Operation::number("max(a, b)", |c| (-smaller(-c.a, -c.b)).to_bits()),
    Operation::number("clamp(a, b, c)", |c| smaller(-smaller(-c.a, -c.b), c.c).to_bits()),
    Operation::number("select(a, b, a < c)", |c| if c.a < c.c { c.b } else { c.a }.to_bits()),
    Operation::word(
        "u32(a < b) + 2u * u32(a <= b) + 4u * u32(a > b) + 8u * u32(a >= b) + 16u * u32(a == b) + 32u * u32(a != b)",
        comparisons,
    ),
    Operation { is_single: true, ..Operation::word("bitcast<u32>(f32(a))", |c| u64::from((c.a as f32).to_bits())) },
    Operation::word("bitcast<u32>(i32(a))", |c| u64::from(c.a as i32 as u32)),
    Operation::word("u32(a)", |c| u64::from(c.a as u32)),
    Operation::word("u32(bool(a))", |c| u64::from(c.a != 0.0)),
    Operation::number("f64(bitcast<f32>(word))", |c| f64::from(f32::from_bits(c.word)).to_bits()),
    Operation::number("f64(bitcast<i32>(word))", |c| f64::from(c.word as i32).to_bits()),
    Operation::number("f64(word)", |c| f64::from(c.word).to_bits()),
    Operation::number("f64((word & 1u) == 1u)", |c| f64::from(c.word & 1 == 1).to_bits()),
];

/// Built-in functions that are made of several operations, each rounded.
pub const COMPOSITE: [Operation; 14] = [
    Operation::number("saturate(a)", |c| smaller(-smaller(-c.a, -0.0), 1.0).to_bits()),
    Operation::number("inverseSqrt(a)", |c| (1.0 / c.a.sqrt()).to_bits()),
    Operation::number("dot(vec3<f64>(a, b, c), vec3<f64>(b, c, a))", |c| (c.a * c.b + c.b * c.c + c.c * c.a).to_bits()),
    Operation::number("length(vec2<f64>(a, b))", |c| (c.a * c.a + c.b * c.b).sqrt().to_bits()),
    Operation::number("distance(a, b)", |c| (c.a - c.b).abs().to_bits()),
    Operation::number("normalize(vec3<f64>(a, b, c)).y", |c| {
        (c.b / (c.a * c.a + c.b * c.b + c.c * c.c).sqrt()).to_bits()
    }),
    Operation::number("cross(vec3<f64>(a, b, c), vec3<f64>(c, a, b)).z", |c| (c.a * c.a - c.b * c.c).to_bits()),
    Operation::number("reflect(vec2<f64>(a, b), vec2<f64>(b, c)).x", |c| {
        (c.a - c.b * (2.0 * (c.b * c.a + c.c * c.b))).to_bits()
    }),
    Operation::number("mix(a, b, c)", |c| (c.a * (1.0 - c.c) + c.b * c.c).to_bits()),
    Operation::number("step(a, b)", |c| f64::from(c.a <= c.b).to_bits()),
    Operation::number("faceForward(vec2<f64>(a, b), vec2<f64>(b, c), vec2<f64>(c, a)).x", |c| {
        if c.b * c.c + c.c * c.a < 0.0 { c.a } else { -c.a }.to_bits()
    }),
    Operation::number("vec4<f64>(a, b, c, a)[word % 4u]", |c| [c.a, c.b, c.c, c.a][c.word as usize % 4].to_bits()),
    Operation::number("(vec3<f64>(a, b, c).zxy * b - a).y", |c| (c.a * c.b - c.a).to_bits()),
    Operation::number("select(vec2<f64>(a), vec2<f64>(b, c), vec2<f64>(a, b) < vec2<f64>(c)).y", |c| {
        if c.b < c.c { c.c } else { c.a }.to_bits()
    }),
];

/// Returns every operation.
pub fn all() -> impl Iterator<Item = &'static Operation> {
    BASIC.iter().chain(&COMPOSITE)
}

/// Returns the smaller number; of a number and NaN the number; of two zeros -0, if it is one of them.
fn smaller(a: f64, b: f64) -> f64 {
    if a == 0.0 && b == 0.0 {
        return if a.is_sign_negative() { a } else { b };
    }
    a.min(b)
}

/// Returns 1, -1, 0 or NaN.
fn sign(a: f64) -> f64 {
    match a {
        _ if a > 0.0 => 1.0,
        _ if a < 0.0 => -1.0,
        _ if a == 0.0 => 0.0,
        _ => f64::NAN,
    }
}

fn comparisons(c: &Operands) -> u64 {
    let answers = [c.a < c.b, c.a <= c.b, c.a > c.b, c.a >= c.b, c.a == c.b, c.a != c.b];
    answers.iter().enumerate().map(|(place, answer)| u64::from(*answer) << place).sum()
}
