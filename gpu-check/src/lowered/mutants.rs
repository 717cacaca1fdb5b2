//! Deliberate errors of the arithmetic, which the comparison of the operations must notice.

use shaders::lower::Arithmetic;

use super::operands::{Operands, draw};
use super::operations;
use crate::mutants::Mutant;
use crate::{Error, Gpu};

macro_rules! mutants {
    ($($file:literal: $($from:literal => $to:literal,)*;)*) => {
        /// All mutants that the comparison must notice.
        pub const MUTANTS: &[Mutant] = &[$($(Mutant { module: $file, from: $from, to: $to },)*)*];
    };
}

mutants! {
    "integers":
        "select(0u, 1u, low < a.x)" => "select(0u, 1u, low <= a.x)",
        "- select(0u, 1u, a.x < b.x)" => "",
        "a.y < b.y || (a.y == b.y && a.x < b.x)" => "a.y < b.y || a.x < b.x",
        "(a.x >> 1u) >> (31u - within)" => "(a.x >> 1u) >> (30u - within)",
        "(a.y << 1u) << (31u - within)" => "a.y << (31u - within)",
        "vec2<u32>(high, 0u), n >= 32u)" => "vec2<u32>(high, 0u), n > 32u)",
        "min(n, 63u)" => "n & 63u",
        "select(1u, 0u, is_exact)" => "select(0u, 0u, is_exact)",
        "32u + countLeadingZeros(a.x)" => "31u + countLeadingZeros(a.x)",
        "+ ((a_low * b_low) >> 16u)" => "",
        "(first & 0xffffu)" => "first",
        "low.y + a.y * b" => "low.y",
        "vec2<u32>(low.y, 0u)" => "vec2<u32>(0u, 0u)",
    ;
    "parts":
        "select(F64_IMPLICIT, 0u," => "select(F64_IMPLICIT, F64_IMPLICIT,",
        "F64_BIAS: i32 = 1023" => "F64_BIAS: i32 = 1022",
        "max(1 - parts.exponent, 0)" => "max(-parts.exponent, 0)",
        "lost > 0x400u ||" => "lost >= 0x400u ||",
        "(kept.x & 1u) != 0u" => "(kept.x & 1u) == 0u",
        "lost == 0x400u &&" => "lost == 0x401u &&",
        "parts.exponent >= i32(F64_SPECIAL)" => "parts.exponent > i32(F64_SPECIAL)",
    ;
    "add":
        "u64_less(f64_magnitude(a), f64_magnitude(b))" => "u64_less(a, b)",
        "max(f64_stored_exponent(small), 1u)" => "f64_stored_exponent(small)",
        "u64_shift_right_sticky(u64_shift_left" => "u64_shift_right(u64_shift_left",
        "a.y & b.y & F64_SIGN" => "large.y & F64_SIGN",
        "|| (subtracts && small_exponent == F64_SPECIAL)" => "",
        "i32(large_exponent) + 1" => "i32(large_exponent)",
    ;
    "multiply":
        "select(0u, 1u, u64_some(product.xy))" => "0u",
        "product.w >= 0x80000000u" => "product.w > 0x80000000u",
        "|| f64_is_nan(b) || is_zero;" => "|| f64_is_nan(b);",
        "(a.y ^ b.y) & F64_SIGN" => "(a.y | b.y) & F64_SIGN",
    ;
    "divide":
        "92521u" => "95000u",
        "correction << 1u) - 2u" => "correction << 1u) + 2u",
        "let is_short = !u64_less(last, divisor);" => "let is_short = false;",
        "select(0u, 1u, u64_some(end))" => "0u",
        "- select(0, 1, is_small)" => "",
        "(a_zero && b_zero)" => "false",
        "a_zero || b_infinite" => "a_zero",
    ;
    "square_root":
        "87518u" => "90000u",
        "(parts.exponent & 1) == 0" => "(parts.exponent & 1) == 1",
        "let is_short = estimate_rest > 2u * estimate;" => "let is_short = false;",
        "let one_more = !u64_less(remainder, step);" => "let one_more = false;",
        "select(0u, 1u, u64_some(remainder))" => "0u",
        ">> 1u) + F64_BIAS" => "/ 2) + F64_BIAS",
        "|| a.y >= F64_SIGN" => "",
    ;
    "fma":
        "let carry = select(0u, 1u, u64_less(low, a.xy));" => "let carry = 0u;",
        "let borrow = select(0u, 1u, u64_less(a.xy, b.xy));" => "let borrow = 0u;",
        "u64_some(shifted.xy)" => "false",
        "product_sign & c_sign" => "product_sign",
        "(product_special && c_special && subtracts)" => "false",
    ;
    "whole":
        "clamp(52 - exponent, 0, 52)" => "clamp(51 - exponent, 0, 52)",
        "select(f64_trunc(a), f64_away(a), a.y >= F64_SIGN)" => "f64_trunc(a)",
        "is_odd && u64_some(below_point)" => "u64_some(below_point)",
        "vec2<u32>(0u, 0x3fe00000u)" => "vec2<u32>(0u, 0x3fdfffffu)",
        "select(one, a, f64_is_zero(a))" => "one",
    ;
    "compare":
        "!f64_is_nan(a) && !f64_is_nan(b) && (all(a == b)" => "(all(a == b)",
        "&& !are_zeros && f64_before" => "&& f64_before",
        "u64_less(b, a), a_negative)" => "u64_less(a, b), a_negative)",
        "(are_zeros || !f64_before(b, a))" => "!f64_before(b, a)",
        "(!f64_is_nan(b) && f64_before(b, a))" => "f64_before(b, a)",
    ;
    "convert":
        "exponent - 1u" => "exponent",
        "select(0u, F64_SIGN, is_negative)" => "0u",
        "1023u - 149u" => "1023u - 150u",
        "(lost == 0x80u && (kept & 1u) != 0u)" => "lost == 0x80u",
        "exponent >= 255)" => "exponent >= 254)",
        "(significand.x >> 21u)" => "0u",
        "exponent > 31)" => "exponent > 30)",
        "min(whole, 0x7fffffffu)" => "whole",
        "select(1u, 0u, (shifted << shift) == significand)" => "0u",
    ;
}

/// Number of cases of each operation.
const CASES: u64 = 120_000;

/// Returns the arithmetic with the error of `mutant`, whose module is a file in `shaders/wgsl/f64`.
///
/// # Panics
/// If there is no such file, or if the text to replace does not occur exactly once in it.
#[must_use]
pub fn arithmetic(mutant: &Mutant) -> Arithmetic {
    let mut arithmetic = Arithmetic::standard();
    let source = arithmetic.source(mutant.module).unwrap_or_else(|| panic!("there is no {}", mutant.module));
    let changed = mutant.changed(source);
    arithmetic.replace(mutant.module, changed);
    arithmetic
}

/// Returns the cases with which [`notice`] looks for errors.
#[must_use]
pub fn cases() -> Vec<Operands> {
    (0..CASES).map(|index| draw(31, index)).collect()
}

/// Returns a description of the first operation whose results differ from Rust's with `arithmetic`, or `None` if no
/// operation notices an error.
///
/// # Errors
/// An error of the device, or of the text of the arithmetic.
pub fn notice(gpu: &Gpu, arithmetic: &Arithmetic, cases: &[Operands]) -> Result<Option<String>, Error> {
    for operation in &operations::BASIC {
        let pipeline = super::compile(gpu, operation, Some(arithmetic))?;
        let mut tally = super::Tally::new(operation);
        super::compare(gpu, &pipeline, operation, cases, &mut tally)?;
        if tally.differing > 0 {
            return Ok(Some(format!("{}, {} of {} cases", tally.operation, tally.differing, tally.cases)));
        }
    }
    Ok(None)
}
