//! Integer arithmetic at the ends of its range, division by zero, and shifts.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::words;
use crate::conformance::probe::Probe;

/// Corners of 32-bit arithmetic.
const CORNERS: [u32; 9] = [0, 1, 2, 7, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, 0xffff_fffe, u32::MAX];

/// Text for arithmetic that overflows.
const WRAP: &str = "WGSL 8.7: arithmetic is modulo 2^32";
/// Text for quotients.
const QUOTIENT: &str = "WGSL 8.7: a / 0 is a, and a % 0 is 0; the smallest number divided by -1 is itself, remainder 0";

pub fn probes() -> Vec<Probe> {
    let mut probes = arithmetic();
    probes.extend(quotients());
    probes.extend(bits());
    probes
}

/// Returns rows of signed numbers: random ones, and then all corners.
fn signed<const N: usize>() -> Vec<[i32; N]> {
    words::<N>(&CORNERS).into_iter().map(|row| row.map(|word| word as i32)).collect()
}

fn arithmetic() -> Vec<Probe> {
    vec![
        Draft::new("i32-sum", "a + b", signed(), |[a, b]: [i32; 2]| a.wrapping_add(b)).rule(WRAP).done(),
        Draft::new("i32-product", "a * b", signed(), |[a, b]: [i32; 2]| a.wrapping_mul(b)).rule(WRAP).done(),
        Draft::new("i32-negate", "-a", signed(), |[a]: [i32; 1]| a.wrapping_neg()).rule(WRAP).done(),
        Draft::new("i32-abs", "abs(a)", signed(), |[a]: [i32; 1]| a.wrapping_abs())
            .rule("WGSL 17.5: the smallest number stays")
            .done(),
        Draft::new("u32-difference", "a - b", words(&CORNERS), |[a, b]: [u32; 2]| a.wrapping_sub(b)).rule(WRAP).done(),
        Draft::new("i32-less-by-difference", "select(0u, 1u, a - b < 0i)", signed(), |[a, b]: [i32; 2]| {
            u32::from(a.wrapping_sub(b) < 0)
        })
        .rule("WGSL 8.7: the difference wraps, so it is not a < b")
        .done(),
    ]
}

fn quotients() -> Vec<Probe> {
    let nonzero = || signed::<2>().into_iter().filter(|[_, b]| *b != 0);
    let by_zero = || signed::<1>().into_iter().map(|[a]| [a, 0]);
    vec![
        Draft::new("i32-divide", "a / b", nonzero(), |[a, b]: [i32; 2]| a.wrapping_div(b)).rule(QUOTIENT).done(),
        Draft::new("i32-remainder", "a % b", nonzero(), |[a, b]: [i32; 2]| a.wrapping_rem(b)).rule(QUOTIENT).done(),
        Draft::new("i32-divide-by-zero", "a / b", by_zero(), |[a, _]: [i32; 2]| a).rule(QUOTIENT).done(),
        Draft::new("i32-remainder-by-zero", "a % b", by_zero(), |_: [i32; 2]| 0).rule(QUOTIENT).done(),
        Draft::new("u32-divide", "a / b", words(&CORNERS), |[a, b]: [u32; 2]| a.checked_div(b).unwrap_or(a))
            .rule(QUOTIENT)
            .done(),
        Draft::new("u32-remainder", "a % b", words(&CORNERS), |[a, b]: [u32; 2]| a.checked_rem(b).unwrap_or(0))
            .rule(QUOTIENT)
            .done(),
    ]
}

fn bits() -> Vec<Probe> {
    const SHIFT: &str = "WGSL 8.9: the shift is modulo 32";
    let shifts = || {
        let numbers = words::<1>(&CORNERS);
        numbers.into_iter().enumerate().map(|(index, [a])| [a, index as u32 % 100])
    };
    let fields = || {
        let rows = words::<3>(&[0, 1, 15, 16, 31, 32, 33, 64]).into_iter();
        rows.map(|[a, offset, count]| [a.wrapping_mul(0x9e37_79b9), offset % 70, count % 70])
    };
    vec![
        Draft::new("shift-left", "a << b", shifts(), |[a, b]: [u32; 2]| a.wrapping_shl(b)).rule(SHIFT).done(),
        Draft::new("shift-right", "a >> b", shifts(), |[a, b]: [u32; 2]| a.wrapping_shr(b)).rule(SHIFT).done(),
        Draft::new("shift-right-signed", "bitcast<i32>(a) >> b", shifts(), |[a, b]: [u32; 2]| {
            (a as i32).wrapping_shr(b)
        })
        .rule(SHIFT)
        .done(),
        Draft::new("leading-zeros", "countLeadingZeros(a)", words(&CORNERS), |[a]: [u32; 1]| a.leading_zeros())
            .rule("WGSL 17.5: 32 for 0")
            .done(),
        Draft::new("first-leading-bit", "firstLeadingBit(a)", signed(), |[a]: [i32; 1]| {
            // The place of the highest bit that differs from the sign; -1 for 0 and -1.
            31 - (a ^ (a >> 31)).leading_zeros() as i32
        })
        .rule("WGSL 17.5: -1 for 0 and -1")
        .done(),
        Draft::new("extract-bits", "extractBits(a, b, c)", fields(), |[a, b, c]: [u32; 3]| {
            let offset = b.min(32);
            let count = c.min(32 - offset);
            ((u64::from(a) >> offset) & ((1 << count) - 1)) as u32
        })
        .rule("WGSL 17.5: offset and count are limited to the 32 bits")
        .done(),
    ]
}
