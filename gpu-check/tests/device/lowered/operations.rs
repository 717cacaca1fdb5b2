//! The operations on f64 that are compared, in WGSL and in Rust.

/// An operation on the numbers `a`, `b` and `c` and the word `word`: its text in WGSL, and its result in Rust.
pub type Operation = (&'static str, fn([f64; 3], u32) -> f64);

/// The operations of the arithmetic, each alone. Results of other types are converted to f64.
pub const BASIC: [Operation; 28] = [
    ("a + b", |[a, b, _], _| a + b),
    ("a - b", |[a, b, _], _| a - b),
    ("a * b", |[a, b, _], _| a * b),
    ("a / b", |[a, b, _], _| a / b),
    ("sqrt(a)", |[a, ..], _| a.sqrt()),
    ("fma(a, b, c)", |[a, b, c], _| a.mul_add(b, c)),
    ("a % b", |[a, b, _], _| a - b * (a / b).trunc()),
    ("-a", |[a, ..], _| -a),
    ("abs(a)", |[a, ..], _| a.abs()),
    ("floor(a)", |[a, ..], _| a.floor()),
    ("ceil(a)", |[a, ..], _| a.ceil()),
    ("trunc(a)", |[a, ..], _| a.trunc()),
    ("round(a)", |[a, ..], _| a.round_ties_even()),
    ("fract(a)", |[a, ..], _| a - a.floor()),
    ("sign(a)", |[a, ..], _| if a == 0.0 || a.is_nan() { a.abs() } else { a.signum() }),
    ("min(a, b)", |[a, b, _], _| smaller(a, b)),
    ("max(a, b)", |[a, b, _], _| -smaller(-a, -b)),
    ("clamp(a, b, c)", |[a, b, c], _| smaller(-smaller(-a, -b), c)),
    ("select(a, b, a < c)", |[a, b, c], _| if a < c { b } else { a }),
    (
        "f64(u32(a < b) + 2u * u32(a <= b) + 4u * u32(a > b) + 8u * u32(a >= b) + 16u * u32(a == b) + 32u * u32(a != b))",
        |[a, b, _], _| {
            let answers = [a < b, a <= b, a > b, a >= b, a == b, a != b];
            (0..).zip(answers).map(|(place, answer)| f64::from(u32::from(answer) << place)).sum()
        },
    ),
    ("f64(f32(a))", |[a, ..], _| f64::from(a as f32)),
    ("f64(i32(a))", |[a, ..], _| f64::from(a as i32)),
    ("f64(u32(a))", |[a, ..], _| f64::from(a as u32)),
    ("f64(u32(bool(a)))", |[a, ..], _| f64::from(a != 0.0)),
    ("f64(bitcast<f32>(word))", |_, word| f64::from(f32::from_bits(word))),
    ("f64(bitcast<i32>(word))", |_, word| f64::from(word as i32)),
    ("f64(word)", |_, word| f64::from(word)),
    ("f64((word & 1u) == 1u)", |_, word| f64::from(word & 1 == 1)),
];

/// Built-in functions that are made of several operations, each rounded.
pub const COMPOSITE: [Operation; 14] = [
    ("saturate(a)", |[a, ..], _| smaller(-smaller(-a, -0.0), 1.0)),
    ("inverseSqrt(a)", |[a, ..], _| 1.0 / a.sqrt()),
    ("dot(vec3<f64>(a, b, c), vec3<f64>(b, c, a))", |[a, b, c], _| a * b + b * c + c * a),
    ("length(vec2<f64>(a, b))", |[a, b, _], _| (a * a + b * b).sqrt()),
    ("distance(a, b)", |[a, b, _], _| (a - b).abs()),
    ("normalize(vec3<f64>(a, b, c)).y", |[a, b, c], _| b / (a * a + b * b + c * c).sqrt()),
    ("cross(vec3<f64>(a, b, c), vec3<f64>(c, a, b)).z", |[a, b, c], _| a * a - b * c),
    ("reflect(vec2<f64>(a, b), vec2<f64>(b, c)).x", |[a, b, c], _| a - b * (2.0 * (b * a + c * b))),
    ("mix(a, b, c)", |[a, b, c], _| a * (1.0 - c) + b * c),
    ("step(a, b)", |[a, b, _], _| f64::from(a <= b)),
    (
        "faceForward(vec2<f64>(a, b), vec2<f64>(b, c), vec2<f64>(c, a)).x",
        |[a, b, c], _| {
            if b * c + c * a < 0.0 { a } else { -a }
        },
    ),
    ("vec4<f64>(a, b, c, a)[word % 4u]", |[a, b, c], word| [a, b, c, a][word as usize % 4]),
    ("(vec3<f64>(a, b, c).zxy * b - a).y", |[a, b, _], _| a * b - a),
    (
        "select(vec2<f64>(a), vec2<f64>(b, c), vec2<f64>(a, b) < vec2<f64>(c)).y",
        |[a, b, c], _| {
            if b < c { c } else { a }
        },
    ),
];

/// Returns the smaller number; of a number and NaN the number; of two zeros -0, if it is one of them.
fn smaller(a: f64, b: f64) -> f64 {
    if a == 0.0 && b == 0.0 {
        return if a.is_sign_negative() { a } else { b };
    }
    a.min(b)
}
