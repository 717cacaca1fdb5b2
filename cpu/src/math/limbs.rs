//! Whole numbers of any length, as lists of 64-bit limbs. The lowest limb is first. The last limb is not zero, so the
//! number zero is an empty list.

use std::ops::{Deref, DerefMut};

/// Lists of up to this many limbs are stored in place, which takes no allocation. More places would make each copy call
/// a function. The coefficients of ordinary objects have up to 5 limbs, and their discriminants up to 8.
const FEW: usize = 8;

/// A list of limbs.
#[derive(Clone, Debug)]
pub enum Limbs {
    /// The limbs in place, and their number. All other places are zero.
    Few([u64; FEW], usize),
    /// More limbs, or a list that once had more.
    Many(Vec<u64>),
}

impl Deref for Limbs {
    type Target = [u64];
    #[inline(always)]
    fn deref(&self) -> &[u64] {
        match self {
            Self::Few(limbs, count) => &limbs[..*count],
            Self::Many(limbs) => limbs,
        }
    }
}

impl DerefMut for Limbs {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [u64] {
        match self {
            Self::Few(limbs, count) => &mut limbs[..*count],
            Self::Many(limbs) => limbs,
        }
    }
}

impl Limbs {
    /// Returns the list of one limb, or the empty list for zero.
    pub(crate) fn of(limb: u64) -> Self {
        let mut limbs = [0; FEW];
        limbs[0] = limb;
        Self::Few(limbs, usize::from(limb != 0))
    }

    /// Returns `count` zeros, which are to be replaced.
    fn zeros(count: usize) -> Self {
        if count <= FEW { Self::Few([0; FEW], count) } else { Self::Many(vec![0; count]) }
    }

    /// Returns `limbs`, followed by zeros up to `count` limbs.
    fn widened(limbs: &[u64], count: usize) -> Self {
        let mut wide = Self::zeros(count);
        wide[..limbs.len()].copy_from_slice(limbs);
        wide
    }

    /// Returns the list without the zero limbs at its end.
    fn trimmed(mut self) -> Self {
        let left = self.iter().rposition(|&limb| limb != 0).map_or(0, |last| last + 1);
        match &mut self {
            Self::Few(_, count) => *count = left,
            Self::Many(limbs) => limbs.truncate(left),
        }
        self
    }
}

/// Applies `step` to each limb of `limbs`, the one of `other` and the carry. Returns the last carry.
fn carry_through(limbs: &mut [u64], other: &[u64], step: impl Fn(u64, u64) -> (u64, bool)) -> bool {
    let mut carry = false;
    for (index, limb) in limbs.iter_mut().enumerate() {
        let (part, first) = step(*limb, other.get(index).copied().unwrap_or(0));
        let (whole, second) = step(part, u64::from(carry));
        (*limb, carry) = (whole, first || second);
    }
    carry
}

/// Returns `a + b`.
pub(crate) fn sum(a: &[u64], b: &[u64]) -> Limbs {
    let mut limbs = Limbs::widened(a, a.len().max(b.len()) + 1);
    carry_through(&mut limbs, b, u64::overflowing_add);
    limbs.trimmed()
}

/// Returns `|a - b|`, and whether `a` is less than `b`.
pub(crate) fn difference(a: &[u64], b: &[u64]) -> (Limbs, bool) {
    let mut limbs = Limbs::widened(a, a.len().max(b.len()));
    let is_less = carry_through(&mut limbs, b, u64::overflowing_sub);
    if is_less {
        // The limbs hold `a - b` modulo a power of two, so the number is negated.
        let mut carry = true;
        for limb in &mut *limbs {
            (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
        }
    }
    (limbs.trimmed(), is_less)
}

/// Returns the product of `a` and `b`. Zero limbs of `a` take no time: sums of numbers with very different exponents
/// have many.
pub(crate) fn product(a: &[u64], b: &[u64]) -> Limbs {
    let mut limbs = Limbs::zeros(a.len() + b.len());
    for (shift, &x) in a.iter().enumerate().filter(|&(_, &x)| x != 0) {
        let mut carry = 0;
        for (limb, &y) in limbs[shift..].iter_mut().zip(b.iter().chain([&0])) {
            let total = u128::from(x) * u128::from(y) + u128::from(*limb) + carry;
            *limb = total as u64;
            carry = total >> 64;
        }
    }
    limbs.trimmed()
}

/// Returns the 64 bits of `a` from `bit` on, the lowest first. Bits outside of `a` are 0.
pub(crate) fn window(a: &[u64], bit: i64) -> u64 {
    let limb = |index: i64| usize::try_from(index).ok().and_then(|index| a.get(index)).copied().unwrap_or(0);
    let (index, shift) = (bit.div_euclid(64), bit.rem_euclid(64));
    // Two shifts, because a shift by 64 bits is not defined.
    limb(index) >> shift | limb(index + 1) << 1 << (63 - shift)
}

/// Returns `a / 2^shift`, truncated.
pub(crate) fn shifted_right(a: &[u64], shift: usize) -> Limbs {
    let mut limbs = Limbs::zeros(a.len().saturating_sub(shift / 64));
    for (index, limb) in limbs.iter_mut().enumerate() {
        *limb = window(a, (64 * index + shift) as i64);
    }
    limbs.trimmed()
}

/// Returns `a / divisor`, truncated, for a divisor that is not zero.
pub(crate) fn quotient(a: &[u64], divisor: u64) -> Limbs {
    let mut remainder = 0;
    let mut limbs = Limbs::widened(a, a.len());
    for limb in limbs.iter_mut().rev() {
        let total = u128::from(remainder) << 64 | u128::from(*limb);
        *limb = (total / u128::from(divisor)) as u64;
        remainder = (total % u128::from(divisor)) as u64;
    }
    limbs.trimmed()
}

/// Returns `a 2^shift`.
pub(crate) fn shifted(a: &[u64], shift: u64) -> Limbs {
    let (zeros, shift) = ((shift / 64) as usize, shift % 64);
    let mut limbs = Limbs::zeros(zeros + a.len() + 1);
    let mut carry = 0;
    for (shifted, &limb) in limbs[zeros..].iter_mut().zip(a) {
        *shifted = limb << shift | carry;
        carry = limb >> 1 >> (63 - shift);
    }
    limbs[zeros + a.len()] = carry;
    limbs.trimmed()
}
