//! Whole numbers of any length, as lists of 64-bit limbs. The lowest limb is first. The last limb is not zero, so the
//! number zero is an empty list.

use std::cmp::Ordering;

/// Returns the list without the zero limbs at its end.
fn trimmed(mut limbs: Vec<u64>) -> Vec<u64> {
    while limbs.last() == Some(&0) {
        limbs.pop();
    }
    limbs
}

/// Compares the numbers `a` and `b`.
pub(crate) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

/// Returns `a + b`. If `is_difference` is set, it returns `a - b`, and `b` must be at most `a`.
pub(crate) fn sum(a: &[u64], b: &[u64], is_difference: bool) -> Vec<u64> {
    debug_assert!(!is_difference || compare(a, b) != Ordering::Less);
    let limb = |list: &[u64], index: usize| i128::from(list.get(index).copied().unwrap_or(0));
    let mut carry = 0;
    let limbs = (0..=a.len()).map(|index| {
        let (x, y) = (limb(a, index), limb(b, index));
        let total = carry + if is_difference { x - y } else { x + y };
        carry = total >> 64;
        total as u64
    });
    trimmed(limbs.collect())
}

/// Returns the product of `a` and `b`.
pub(crate) fn product(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut limbs = vec![0; a.len() + b.len()];
    for (shift, &x) in a.iter().enumerate() {
        let mut carry = 0;
        for (limb, &y) in limbs[shift..].iter_mut().zip(b.iter().chain([&0])) {
            let total = u128::from(x) * u128::from(y) + u128::from(*limb) + carry;
            *limb = total as u64;
            carry = total >> 64;
        }
    }
    trimmed(limbs)
}

/// Returns `a / 2^shift`, truncated.
pub(crate) fn shifted_right(a: &[u64], shift: usize) -> Vec<u64> {
    let kept = a.get(shift / 64..).unwrap_or_default();
    let shift = shift % 64;
    let above = kept.iter().skip(1).chain([&0]);
    // Two shifts, because a shift by 64 bits is not defined.
    trimmed(kept.iter().zip(above).map(|(limb, above)| limb >> shift | above << 1 << (63 - shift)).collect())
}

/// Returns `a / divisor`, truncated, for a divisor that is not zero.
pub(crate) fn quotient(a: &[u64], divisor: u64) -> Vec<u64> {
    let mut remainder = 0;
    let mut limbs = a.to_vec();
    for limb in limbs.iter_mut().rev() {
        let total = u128::from(remainder) << 64 | u128::from(*limb);
        *limb = (total / u128::from(divisor)) as u64;
        remainder = (total % u128::from(divisor)) as u64;
    }
    trimmed(limbs)
}

/// Returns `a 2^shift`.
pub(crate) fn shifted(a: &[u64], shift: u64) -> Vec<u64> {
    let mut limbs = vec![0; (shift / 64) as usize];
    let shift = shift % 64;
    let mut carry = 0;
    for &limb in a {
        limbs.push(limb << shift | carry);
        carry = if shift == 0 { 0 } else { limb >> (64 - shift) };
    }
    limbs.push(carry);
    trimmed(limbs)
}
