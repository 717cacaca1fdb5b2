//! Whole numbers of any length, as lists of 64-bit limbs. The lowest limb is first. The last limb is not zero, so the
//! number zero is an empty list.

/// Returns the list without the zero limbs at its end.
fn trimmed(mut limbs: Vec<u64>) -> Vec<u64> {
    while limbs.last() == Some(&0) {
        limbs.pop();
    }
    limbs
}

/// Applies `step` to each limb of `limbs`, the one of `other` and the carry. Returns the last carry.
fn carry_through(limbs: &mut Vec<u64>, other: &[u64], step: impl Fn(u64, u64) -> (u64, bool)) -> bool {
    limbs.resize(limbs.len().max(other.len()), 0);
    let mut carry = false;
    for (index, limb) in limbs.iter_mut().enumerate() {
        let (part, first) = step(*limb, other.get(index).copied().unwrap_or(0));
        let (whole, second) = step(part, u64::from(carry));
        (*limb, carry) = (whole, first || second);
    }
    carry
}

/// Returns `a + b`.
pub(crate) fn sum(mut a: Vec<u64>, b: &[u64]) -> Vec<u64> {
    let carry = carry_through(&mut a, b, u64::overflowing_add);
    a.extend(carry.then_some(1));
    a
}

/// Returns `|a - b|`, and whether `a` is less than `b`.
pub(crate) fn difference(mut a: Vec<u64>, b: &[u64]) -> (Vec<u64>, bool) {
    let is_less = carry_through(&mut a, b, u64::overflowing_sub);
    if is_less {
        // The limbs hold `a - b` modulo a power of two, so the number is negated.
        let mut carry = true;
        for limb in &mut a {
            (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
        }
    }
    (trimmed(a), is_less)
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
    let zeros = (shift / 64) as usize;
    // One limb more than needed, so that a carry of a sum needs no new memory.
    let mut limbs = Vec::with_capacity(zeros + a.len() + 2);
    limbs.resize(zeros, 0);
    let shift = shift % 64;
    let mut carry = 0;
    for &limb in a {
        limbs.push(limb << shift | carry);
        carry = if shift == 0 { 0 } else { limb >> (64 - shift) };
    }
    limbs.push(carry);
    trimmed(limbs)
}
