//! Conversions between types, and reinterpretations of bits.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{positive, random, words};
use crate::conformance::probe::Probe;
use crate::conformance::reading::Allowed;
use crate::conformance::ulp::neighbours;

/// Numbers that are hard to convert to `f32`: ties, neighbours of ties and the largest numbers.
const WORDS: [u32; 10] =
    [0, 1, 0x0100_0001, 0x0100_0003, 0x7fff_ffbf, 0x7fff_ffc0, 0x7fff_ffff, 0x8000_0000, 0x8000_0080, u32::MAX];

/// Bits of numbers of `f32`: zeros, subnormal and normal numbers, and infinities.
const PATTERNS: [u32; 9] =
    [0, 0x8000_0000, 1, 0x807f_ffff, 0x0080_0000, 0x3f80_0000, 0xff7f_ffff, 0x7f80_0000, 0xff80_0000];

/// Text for conversions to `f32`.
const TO_FLOAT: &str = "IEEE 754: nearest, ties to even. WGSL 15.7.6: either neighbour";
/// Text for reinterpretations of bits.
const BITS: &str = "WGSL 17.2: the same bits; 15.7.2: bitcast may flush subnormal numbers";

pub fn probes() -> Vec<Probe> {
    let wide = || {
        let mut rows = random::<f64, 1>(-30.0, 30.0);
        let tie = 1.0 + f64::from(f32::EPSILON) / 2.0;
        let top = f64::from(f32::MAX);
        rows.extend([tie, tie.next_down(), tie.next_up(), tie + f64::from(f32::EPSILON), top, -0.0].map(|a| [a]));
        rows
    };
    let numbers = || words::<1>(&PATTERNS).into_iter().map(|[a]| [f32::from_bits(a)]).filter(|[a]| !a.is_nan());
    vec![
        Draft::new("u32-to-f32", "f32(a)", TO_FLOAT, words(&WORDS), |[a]: [u32; 1]| a as f32)
            .error("either neighbour", |[a]| neighbours(f64::from(a)))
            .done(),
        Draft::new("u32-to-f64", "f64(a)", "WGSL 15.7.6: exact", words(&WORDS), |[a]: [u32; 1]| f64::from(a)).done(),
        Draft::new("f32-to-u32", "u32(a)", "WGSL 15.7.6: rounded toward zero", positive(-1.0, 9.0), |[a]: [f32; 1]| {
            a as u32
        })
        .done(),
        Draft::new("f64-to-f32", "f32(a)", TO_FLOAT, wide(), |[a]: [f64; 1]| a as f32)
            .error("either neighbour", |[a]| neighbours(a))
            .done(),
        Draft::new("bits-of-f32", "bitcast<u32>(a)", BITS, numbers(), |[a]: [f32; 1]| a.to_bits())
            .rewritings("subnormal numbers flushed", |[a]| match a.is_subnormal() {
                true => Allowed::any_of([0, 0x8000_0000_u32]),
                false => Allowed::any_of([a.to_bits()]),
            })
            .done(),
    ]
}
