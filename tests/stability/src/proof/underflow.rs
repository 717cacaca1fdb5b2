//! What underflow adds to the numbers of a formula.
//!
//! Each product has an error of at most 2^-1075 beside its relative one, and sums have none. So the computed number is
//! that of the bounds, which leave underflow out, with a part that each operation passes on. Rounding multiplies this
//! part by less than two. The error of a sum or product, computed by more operations, is such a number too.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use super::bounded::{Bounded, LOST_MARGIN, MARGIN, Operation, numbers};
use super::bounds::{Arithmetic, Bounds};
use super::logarithm::{Corner, Log, sum};
use super::row::{U, family::AXIS};
use super::signed::two_sum;

/// Bounds of the magnitudes of numbers, kept because they hold in all parts of a domain. A bound is a list of
/// monomials: the logarithm of the coefficient, and the families.
pub type Known = RefCell<HashMap<Bounded, Rc<Vec<(Log, Vec<u8>)>>>>;

/// The parts that underflow adds, for numbers of these magnitudes.
pub struct Underflow<'a> {
    known: &'a Known,
    /// For each family the largest magnitude, which is infinite if it has no limit.
    most: [Log; 256],
    /// Numbers of which roots are taken, with their smallest magnitudes.
    radicands: &'a [(Bounded, Log)],
    /// For each number what underflow adds, or NaN if that is not known yet.
    added: Vec<Log>,
}

impl<'a> Underflow<'a> {
    /// Returns the parts, of which none is known yet.
    pub fn new(known: &'a Known, corner: Corner, radicands: &'a [(Bounded, Log)]) -> Self {
        let mut most = [f64::INFINITY; 256];
        for (family, limit) in corner.iter().copied().chain([AXIS, MARGIN.0, LOST_MARGIN.0].map(|family| (family, 0.0)))
        {
            most[usize::from(family)] = limit;
        }
        Self { known, most, radicands, added: vec![f64::NAN; numbers().count()] }
    }

    /// Returns the largest part that underflow adds to a number.
    pub fn of(&mut self, number: Bounded) -> Log {
        let known = self.added[number.place()];
        if !known.is_nan() {
            return known;
        }
        let least = Arithmetic::F64.underflow.log2() + U.log2();
        let added = match number.operation() {
            Operation::Input(_) | Operation::Constant(_) => f64::NEG_INFINITY,
            Operation::Sum(a, b) | Operation::Difference(a, b) => sum(self.of(a), self.of(b)),
            Operation::Product(a, b) => sum(self.of_product(a, b), least),
            Operation::Fused(a, b, c) => sum(sum(self.of_product(a, b), self.of(c)), least),
            Operation::Negative(a) | Operation::Magnitude(a) | Operation::Flipped(a, _) => self.of(a),
            // `sqrt(x + e)` differs from `sqrt(x)` by at most `sqrt(e)`, and by at most `e / sqrt(x)`.
            Operation::Root(a) => {
                let (added, known) = (self.of(a), self.radicands.iter().find(|(of, _)| *of == a));
                (added / 2.0).min(known.map_or(f64::INFINITY, |(_, least)| added - least / 2.0))
            }
            Operation::Quotient(..) => f64::INFINITY,
        };
        self.added[number.place()] = added;
        added
    }

    fn of_product(&mut self, a: Bounded, b: Bounded) -> Log {
        let [of_a, of_b] = [a, b].map(|number| self.of(number));
        let parts = [(a, of_b), (b, of_a)].into_iter().filter(|(_, of)| of.is_finite());
        parts.fold(of_a + of_b, |all, (number, of)| sum(all, self.size(number) + of))
    }

    /// Returns the largest magnitude of a number without underflow. A rounding error is at most `u` times the result.
    pub fn size(&self, number: Bounded) -> Log {
        let monomials = self.known.borrow_mut().entry(number).or_insert_with(|| Rc::new(monomials(number))).clone();
        let of = |(coefficient, families): &(Log, Vec<u8>)| {
            coefficient + families.iter().map(|&family| self.most[usize::from(family)]).sum::<Log>()
        };
        let size = monomials.iter().map(of).fold(f64::NEG_INFINITY, f64::max) + (monomials.len() as f64).log2();
        if size < f64::INFINITY {
            return size;
        }
        let of = |number: Bounded| self.size(number);
        match number.operation() {
            Operation::Sum(x, y) => match two_sum(x, y) {
                Some([.., rounded]) => of(rounded) + U.log2(),
                None => sum(of(x), of(y)),
            },
            Operation::Difference(x, y) => sum(of(x), of(y)),
            Operation::Product(x, y) => of(x) + of(y),
            Operation::Fused(x, y, z) => sum(of(x) + of(y), of(z)),
            Operation::Negative(a) | Operation::Magnitude(a) => of(a),
            _ => f64::INFINITY,
        }
    }
}

/// Returns the monomials that bound a number. The terms of a discriminant are positive, so their errors are at most the
/// terms, even where their bound is infinite.
fn monomials(number: Bounded) -> Vec<(Log, Vec<u8>)> {
    let Bounds { size, error, .. } = number.bounds();
    let [is_known, has_size] = [&error, &size].map(|bound| bound.0.values().all(|factor| factor.is_finite()));
    let error = if is_known || !has_size { error.scaled(U) } else { size.clone() };
    let both = size.plus(&error).0.into_iter();
    both.map(|(monomial, factor)| (factor.log2(), monomial.iter().map(|variable| variable.0).collect())).collect()
}

/// Returns the binary logarithms from the first to the last one of a range, as pairs of neighbours.
pub fn steps(first: Log, last: Log, step: Log) -> impl Iterator<Item = [Log; 2]> + Clone {
    let count = ((last - first) / step).ceil() as u32;
    (0..count).map(move |number| [0, 1].map(|more| first + step * f64::from(number + more)))
}
