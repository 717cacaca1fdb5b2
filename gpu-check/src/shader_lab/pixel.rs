//! Formats one pixel's path by the CPU and by WGSL side by side, and marks the first bit that differs.

use std::fmt::Write as _;

use crate::Float;
use crate::steps::{NAMES, Step, first_difference};

/// Returns the indices in [`NAMES`] of those numbers of a step that are printed. `hit` is the step's `is_hit`: 1 for a
/// hit, 0 for an escape, -1 after the end of the path. For a hit, all numbers except the background's colour are
/// printed. For an escape, `is_hit`, origin, direction and the background's colour are printed. After the end of the
/// path, the result is empty.
fn shown(hit: f64) -> Vec<usize> {
    match hit {
        1.0 => (0..18).collect(),
        0.0 => [0].into_iter().chain(6..12).chain(18..21).collect(),
        _ => Vec::new(),
    }
}

/// Returns the steps of both paths as text in two columns.
#[must_use]
pub fn side_by_side<T: Float>(cpu: &[Step<T>], wgsl: &[Step<T>]) -> String {
    let mut text = String::new();
    let mut first = None;
    for (depth, (a, b)) in cpu.iter().zip(wgsl).enumerate() {
        let mut places = shown(a.is_hit().wide());
        places.extend(shown(b.is_hit().wide()));
        places.sort_unstable();
        places.dedup();
        if places.is_empty() {
            break;
        }
        let _ = writeln!(text, "step {depth:<10} {:<26} WGSL", "CPU");
        for place in places {
            let (a, b) = (a.0[place], b.0[place]);
            let mark = if a.same(b) { "" } else { "  <- differs" };
            let columns = (number(place, a), number(place, b));
            let _ = writeln!(text, "  {:<13} {:<26} {}{mark}", NAMES[place], columns.0, columns.1);
        }
        first = first.or_else(|| first_difference(a, b).map(|place| (depth, place, a.0[place], b.0[place])));
    }
    match first {
        None => text.push_str("no bit differs\n"),
        Some((depth, place, a, b)) => {
            let _ = writeln!(text, "first difference: step {depth}, {}", NAMES[place]);
            text.push_str(&bits(a, b));
        }
    }
    text
}

/// Returns a number as text. Indices and flags have no decimal point.
fn number<T: Float>(place: usize, value: T) -> String {
    let is_name = matches!(NAMES[place], "is_hit" | "object" | "part" | "front" | "material");
    if is_name && value.wide().fract() == 0.0 { format!("{:.0}", value.wide()) } else { format!("{value:?}") }
}

/// Returns the pixel's colour by the CPU and by WGSL as text, with one line for each channel.
#[must_use]
pub fn colors<T: Float>(cpu: [T; 3], wgsl: [T; 3]) -> String {
    let mut text = String::from("colour\n");
    for (name, (a, b)) in ["red", "green", "blue"].into_iter().zip(cpu.into_iter().zip(wgsl)) {
        let mark = if a.same(b) { "" } else { "  <- differs" };
        let _ = writeln!(text, "  {name:<13} {:<26} {b:?}{mark}", format!("{a:?}"));
    }
    text
}

/// Returns both numbers in binary on two lines and a caret below, with blanks between sign, exponent and fraction. A
/// caret marks the first bit that differs.
pub fn bits<T: Float>(a: T, b: T) -> String {
    let (width, exponent) = if size_of::<T>() == 8 { (64, 11) } else { (32, 8) };
    let binary = |number: T| {
        let digits = format!("{:0width$b}", number.bits());
        format!("{} {} {}", &digits[..1], &digits[1..1 + exponent], &digits[1 + exponent..])
    };
    let (one, other) = (binary(a), binary(b));
    let place = one.bytes().zip(other.bytes()).position(|(a, b)| a != b).unwrap_or(0);
    format!("  CPU   {one}\n  WGSL  {other}\n        {:place$}^\n", "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_stand_channel_by_channel() {
        let text = colors([0.5, 0.25, 1.0], [0.5, 0.25, 0.75]);
        assert!(text.starts_with("colour\n  red           0.5                        0.5\n"), "{text}");
        assert!(text.ends_with("  blue          1.0                        0.75  <- differs\n"), "{text}");
    }
}
