//! Integer arithmetic, of which the lowered form of f64 consists.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::words;
use crate::conformance::probe::Probe;

/// Corners of 32-bit arithmetic.
const CORNERS: [u32; 9] = [0, 1, 2, 7, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, 0xffff_fffe, u32::MAX];

/// Text for arithmetic that overflows.
const WRAP: &str = "WGSL 8.7: arithmetic is modulo 2^32";
/// Text for shifts.
const SHIFT: &str = "WGSL 8.9: the shift is modulo 32";

pub fn probes() -> Vec<Probe> {
    let pairs = || words::<2>(&CORNERS);
    let shifts = || {
        let numbers = words::<1>(&CORNERS);
        numbers.into_iter().enumerate().map(|(index, [a])| [a, index as u32 % 100])
    };
    vec![
        Draft::new("u32-sum", "a + b", WRAP, pairs(), |[a, b]: [u32; 2]| a.wrapping_add(b)).done(),
        Draft::new("u32-difference", "a - b", WRAP, pairs(), |[a, b]: [u32; 2]| a.wrapping_sub(b)).done(),
        Draft::new("u32-product", "a * b", WRAP, pairs(), |[a, b]: [u32; 2]| a.wrapping_mul(b)).done(),
        Draft::new("u32-divide", "a / b", "WGSL 8.7: rounded toward zero, and a / 0 is a", pairs(), {
            |[a, b]: [u32; 2]| a.checked_div(b).unwrap_or(a)
        })
        .done(),
        Draft::new("i32-less", "select(0u, 1u, i32(a) < i32(b))", "WGSL 8.8: as signed numbers", pairs(), {
            |[a, b]: [u32; 2]| u32::from((a as i32) < b as i32)
        })
        .done(),
        Draft::new("shift-left", "a << b", SHIFT, shifts(), |[a, b]: [u32; 2]| a.wrapping_shl(b)).done(),
        Draft::new("shift-right", "a >> b", SHIFT, shifts(), |[a, b]: [u32; 2]| a.wrapping_shr(b)).done(),
        Draft::new("leading-zeros", "countLeadingZeros(a)", "WGSL 17.5: 32 for 0", words(&CORNERS), {
            |[a]: [u32; 1]| a.leading_zeros()
        })
        .done(),
    ]
}
