//! Logarithms, exponentials and quotients of small integers, computed by the compiler in integers of 128 bits.

use crate::math::double_double::DoubleDouble;

/// Number of fraction bits of the fixed-point integers in this file: an integer `i` represents the number `i / 2^BITS`.
const BITS: u32 = 120;

/// The smallest index of [`ln_128_over`].
const FIRST: usize = 90;

/// The entry at index `i` is `ln((FIRST + i) / FIRST)`, as a fixed-point integer.
///
/// Each entry adds `ln((k + 1) / k) = 2 atanh(1 / (2 k + 1))` to the one before. The series has at most 9 terms, and
/// each is wrong by less than 2 units. So an entry is wrong by less than `92 * 18` units, or `2^-109`.
const SUMS: [i128; 92] = {
    let mut sums = [0; 92];
    let mut i = 1;
    while i < sums.len() {
        let odd = 2 * (FIRST + i) as i128 - 1;
        let (mut power, mut total, mut divisor) = ((2 << BITS) / odd, 0, 1);
        while power > 0 {
            total += power / divisor;
            power /= odd * odd;
            divisor += 2;
        }
        sums[i] = sums[i - 1] + total;
        i += 1;
    }
    sums
};

/// Returns `ln(128 / k)` for `k` from 90 to 181, wrong by less than `2^-108`. It is exactly 0 for 128.
#[inline(always)]
pub const fn ln_128_over(k: usize) -> DoubleDouble {
    number(SUMS[128 - FIRST] - SUMS[k - FIRST])
}

/// `ln 2`, wrong by less than `2^-106`.
pub const LN_2: DoubleDouble = number(SUMS[180 - FIRST]);

/// The largest magnitude of the index of [`exponential`].
const LAST: i128 = 23;

/// `e^(j / 64)` for `j` from `-LAST` to `LAST`, each wrong by less than `2^-105`.
const EXPONENTIALS: [DoubleDouble; 47] = {
    let mut table = [number(0); 47];
    let mut at = 0;
    while at < table.len() {
        let j = at as i128 - LAST;
        let (mut term, mut total, mut divisor) = (1 << BITS, 0, 1);
        while term != 0 {
            total += term;
            term = term * j / (64 * divisor);
            divisor += 1;
        }
        table[at] = number(total);
        at += 1;
    }
    table
};

/// Returns `e^(j / 64)` for `j` from -23 to 23, wrong by less than `2^-105`.
#[inline(always)]
pub const fn exponential(j: i64) -> DoubleDouble {
    EXPONENTIALS[(j + LAST as i64) as usize]
}

/// Returns `1 / divisor`, to 106 bits.
pub const fn reciprocal(divisor: i128) -> DoubleDouble {
    number((1 << BITS) / divisor)
}

/// Returns the integer times `2^-BITS`, to 106 bits.
const fn number(integer: i128) -> DoubleDouble {
    const UNIT: f64 = 1.0 / (1_i128 << BITS) as f64;
    let high = integer as f64;
    DoubleDouble { high: high * UNIT, low: (integer - high as i128) as f64 * UNIT }
}
