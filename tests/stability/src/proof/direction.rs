//! The side on which a margin acts. Some comparisons make a result certain, or discard an object. A larger margin must
//! make it harder for such a comparison to hold.

use super::bounded::{Bounded, MARGIN, Operation};

/// Returns 1 if the comparison `left < right` is harder with a larger margin, -1 if it is easier, 0 if the margin takes
/// no part, and `None` if that is not known.
#[must_use]
pub fn hardens([left, right]: [Bounded; 2]) -> Option<i8> {
    both(growth(left), growth(right).map(|right| -right))
}

/// Returns the direction of a sum of terms with these directions.
fn both(a: Option<i8>, b: Option<i8>) -> Option<i8> {
    match (a?, b?) {
        (0, any) | (any, 0) => Some(any),
        (a, b) => (a == b).then_some(a),
    }
}

/// Returns 1 if the number grows with the margin, -1 if it shrinks, 0 if the margin takes no part, or `None`.
#[must_use]
pub fn growth(number: Bounded) -> Option<i8> {
    match number.operation() {
        Operation::Input(_) => Some(0),
        Operation::Constant(_) => Some(if number.raw().size.0.contains_key(&vec![MARGIN]) { sign(number)? } else { 0 }),
        Operation::Sum(a, b) => both(growth(a), growth(b)),
        Operation::Difference(a, b) => hardens([a, b]),
        Operation::Product(a, b) => of_product(a, b),
        Operation::Fused(a, b, c) => both(of_product(a, b), growth(c)),
        Operation::Negative(a) => growth(a).map(|growth| -growth),
        Operation::Root(a) => growth(a),
        Operation::Quotient(a, b) | Operation::Flipped(a, b) => {
            (growth(a) == Some(0) && growth(b) == Some(0)).then_some(0)
        }
        Operation::Magnitude(a) => growth(a).filter(|growth| *growth == 0),
    }
}

fn of_product(a: Bounded, b: Bounded) -> Option<i8> {
    let part = |growing: Bounded, factor: Bounded| match growth(growing)? {
        0 => Some(0),
        growth => Some(growth * sign(factor)?),
    };
    both(part(a, b), part(b, a))
}

/// Returns the sign of a number, 1 or -1, if it is known.
fn sign(number: Bounded) -> Option<i8> {
    if number.raw().is_positive {
        return Some(1);
    }
    match number.operation() {
        Operation::Constant(bits) => Some(f64::from_bits(bits).signum() as i8),
        Operation::Negative(a) => sign(a).map(|sign| -sign),
        // The smallest lambda is computed as a difference of constants.
        Operation::Difference(a, b) => match [a, b].map(Bounded::operation) {
            [Operation::Constant(a), Operation::Constant(b)] => {
                Some((f64::from_bits(a) - f64::from_bits(b)).signum() as i8)
            }
            _ => None,
        },
        _ => None,
    }
}
