//! Conversions between types, and reinterpretations of bits.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{near_whole, random, words};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::ulp::neighbours;

/// Numbers that are hard to convert to `f32`: ties, neighbours of ties and the largest numbers.
const WORDS: [u32; 10] =
    [0, 1, 0x0100_0001, 0x0100_0003, 0x7fff_ffbf, 0x7fff_ffc0, 0x7fff_ffff, 0x8000_0000, 0x8000_0080, u32::MAX];

/// Text for conversions to integers.
const TO_INTEGER: &str = "IEEE 754: invalid out of range. WGSL 15.7.6: the number of the integer type closest to \
                          trunc(a) that the floating-point type has too";
/// Text for conversions to `f32`.
const TO_FLOAT: &str = "IEEE 754: nearest, ties to even. WGSL 15.7.6: either neighbour";

pub fn probes() -> Vec<Probe> {
    let mut probes = integers();
    probes.extend(bits());
    probes.extend(of_f64());
    probes
}

/// Numbers of `f32` at the ends of the ranges of `i32` and `u32`, and beyond.
fn far() -> Vec<[f32; 1]> {
    let ends = [2_147_483_648.0_f32, 4_294_967_296.0];
    let mut numbers = vec![1e10, 1e20, 3e38, f32::INFINITY, 0.99, 1.0, 3.9];
    numbers.extend(ends.into_iter().flat_map(|end| [end.next_down(), end, end.next_up()]));
    numbers.into_iter().flat_map(|number| [[number], [-number]]).collect()
}

/// Returns `number` rounded toward zero, and limited to the range from `low` to `high`.
fn limited(number: f32, low: f64, high: f64) -> f64 {
    f64::from(number).trunc().clamp(low, high)
}

fn integers() -> Vec<Probe> {
    // The largest numbers of i32 and u32 that f32 has too are 2^31 - 128 and 2^32 - 256.
    let signed = |[a]: [f32; 1]| limited(a, -2_147_483_648.0, 2_147_483_520.0) as i32;
    let unsigned = |[a]: [f32; 1]| limited(a, 0.0, 4_294_967_040.0) as u32;
    let ordinary = || near_whole::<f32>().into_iter().filter(|[a]| a.abs() < 1e9);
    vec![
        Draft::new("f32-to-i32", "i32(a)", ordinary(), move |[a]: [f32; 1]| a as i32).rule(TO_INTEGER).done(),
        Draft::new("f32-to-i32-range", "i32(a)", far(), signed).rule(TO_INTEGER).done(),
        Draft::new("f32-to-u32", "u32(a)", ordinary().filter(|[a]| *a >= 0.0), |[a]: [f32; 1]| a as u32)
            .rule(TO_INTEGER)
            .done(),
        Draft::new("f32-to-u32-range", "u32(a)", far(), unsigned).rule(TO_INTEGER).done(),
        Draft::new("i32-to-f32", "f32(a)", signed_words(), |[a]: [i32; 1]| a as f32)
            .rule(TO_FLOAT)
            .error("either neighbour", |[a]| Allowed::any_of(neighbours(f64::from(a))))
            .done(),
        Draft::new("u32-to-f32", "f32(a)", words(&WORDS), |[a]: [u32; 1]| a as f32)
            .rule(TO_FLOAT)
            .error("either neighbour", |[a]| Allowed::any_of(neighbours(f64::from(a))))
            .done(),
        Draft::new("u32-to-i32", "i32(a)", words(&WORDS), |[a]: [u32; 1]| a as i32)
            .rule("WGSL 17.1: the same bits")
            .done(),
    ]
}

fn signed_words() -> Vec<[i32; 1]> {
    words::<1>(&WORDS).into_iter().map(|[a]| [a as i32]).collect()
}

/// Bits of numbers of `f32`: zeros, subnormal and normal numbers, infinities, quiet and signaling NaN.
const PATTERNS: [u32; 14] = [
    0,
    0x8000_0000,
    1,
    0x807f_ffff,
    0x0080_0000,
    0x3f80_0000,
    0xff7f_ffff,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0xffc0_0000,
    0x7fc1_2345,
    0x7f81_2345,
    0xff80_0001,
];

fn bits() -> Vec<Probe> {
    let is_nan = |a: u32| a & 0x7fff_ffff > 0x7f80_0000;
    let is_subnormal = |a: u32| f32::from_bits(a).is_subnormal();
    vec![
        Draft::new("bits-through-f32", "bitcast<u32>(f32s[a & 1u])", words(&PATTERNS), |[a]: [u32; 1]| a)
            .code("", "var f32s = array<f32, 2>();\nf32s[a & 1u] = bitcast<f32>(a);\n")
            .rule("IEEE 754: a copy keeps all bits. WGSL 15.7.2: NaN may become quiet or any value, bitcast may flush")
            .rewriting("NaN made quiet", move |[a]| if is_nan(a) { a | 0x0040_0000 } else { a })
            .reading("subnormal numbers flushed", Kind::Rewriting, move |[a]| match is_subnormal(a) {
                true => Allowed::any_of([0, 0x8000_0000_u32]),
                false => Allowed::only(a),
            })
            .indeterminate("bits of NaN not kept", move |[a]| is_nan(a))
            .done(),
        Draft::new("bits-of-f32", "bitcast<u32>(a)", numbers(), |[a]: [f32; 1]| a.to_bits())
            .rule("WGSL 17.2: the same bits; 15.7.2: bitcast may flush subnormal numbers")
            .reading("subnormal numbers flushed", Kind::Rewriting, |[a]| match a.is_subnormal() {
                true => Allowed::any_of([0, 0x8000_0000_u32]),
                false => Allowed::only(a.to_bits()),
            })
            .done(),
    ]
}

fn numbers() -> Vec<[f32; 1]> {
    words::<1>(&PATTERNS).into_iter().map(|[a]| [f32::from_bits(a)]).filter(|[a]| !a.is_nan()).collect()
}

fn of_f64() -> Vec<Probe> {
    let wide = || {
        let mut rows = random::<f64, 1>(-30.0, 30.0);
        let tie = 1.0 + f64::from(f32::EPSILON) / 2.0;
        let top = f64::from(f32::MAX);
        rows.extend([tie, tie.next_down(), tie.next_up(), tie + f64::from(f32::EPSILON), top, -0.0].map(|a| [a]));
        rows
    };
    let far = || far().into_iter().map(|[a]| [f64::from(a)]).filter(|[a]| a.is_finite());
    vec![
        Draft::new("f64-to-f32", "f32(a)", wide(), |[a]: [f64; 1]| a as f32)
            .rule(TO_FLOAT)
            .error("either neighbour", |[a]| Allowed::any_of(neighbours(a)))
            .done(),
        Draft::new("f32-to-f64", "f64(a)", random(-30.0, 30.0), |[a]: [f32; 1]| f64::from(a))
            .rule("IEEE 754 and WGSL 15.7.6: exact")
            .done(),
        Draft::new("i32-to-f64", "f64(a)", signed_words(), |[a]: [i32; 1]| f64::from(a))
            .rule("IEEE 754 and WGSL 15.7.6: exact")
            .done(),
        Draft::new("f64-to-i32-range", "i32(a)", far(), |[a]: [f64; 1]| a as i32).rule(TO_INTEGER).done(),
        Draft::new("f64-to-u32-range", "u32(a)", far(), |[a]: [f64; 1]| a as u32).rule(TO_INTEGER).done(),
    ]
}
