//! The rounding errors of a number with their signs, for formulas that subtract the errors of their own operations.
//!
//! Here a number is a polynomial of the inputs and of the rounding errors of its operations. An error that is added and
//! later subtracted is no longer in the polynomial. A wrong sign in the code leaves it there, or changes the exact
//! value.

use std::collections::HashMap;

use super::bounded::{Bounded, Operation};
use super::bounds::arithmetic;
use super::polynomial::{Monomial, Polynomial, Variable};

/// The family of the variables that are rounding errors. The component is the number of the error.
const ERROR: u8 = u8::MAX - 2;

/// The polynomials of numbers.
pub struct Signed<'a> {
    /// Inputs that are written as polynomials of other variables.
    inputs: &'a [(Variable, Polynomial)],
    /// Exact polynomials, with bounds of their magnitudes.
    known: &'a [(Polynomial, Polynomial)],
    values: HashMap<Bounded, Polynomial>,
    /// A bound of each rounding error, and whether it is a floating-point number. Those of sums and products are, short
    /// of underflow.
    errors: Vec<(Polynomial, bool)>,
}

/// Returns the sum, without terms that cancel.
fn sum(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut sum = a.clone().plus(b);
    sum.0.retain(|_, coefficient| *coefficient != 0.0);
    sum
}

/// Returns the difference, without terms that cancel.
#[must_use]
pub fn difference(a: &Polynomial, b: &Polynomial) -> Polynomial {
    sum(a, &b.clone().scaled(-1.0))
}

/// Returns `a`, `b` and their rounded sum, if `x + y` is the rounding error of that sum by Knuth's theorem.
pub(super) fn two_sum(x: Bounded, y: Bounded) -> Option<[Bounded; 3]> {
    use Operation::{Difference, Sum};
    let (Difference(a, a_part), Difference(b, b_part)) = (x.operation(), y.operation()) else { return None };
    let Difference(sum, same) = a_part.operation() else { return None };
    let is_error = sum.operation() == Sum(a, b) && same == b_part && b_part.operation() == Difference(sum, a);
    is_error.then_some([a, b, sum])
}

impl<'a> Signed<'a> {
    /// Returns the polynomials of numbers whose inputs may be polynomials of other variables. `known` has bounds of the
    /// magnitudes of exact polynomials.
    #[must_use]
    pub fn new(inputs: &'a [(Variable, Polynomial)], known: &'a [(Polynomial, Polynomial)]) -> Self {
        Self { inputs, known, values: HashMap::new(), errors: Vec::new() }
    }

    /// Returns the exact value of a number, and a bound of its error in units of `u`.
    ///
    /// # Panics
    /// If the number is no polynomial of inputs.
    pub fn of(&mut self, number: Bounded) -> [Polynomial; 2] {
        let value = self.value(number);
        let exact = exact(&value);
        let errors = self.magnitude(&difference(&value, &exact));
        [exact, errors.scaled(1.0 / arithmetic().roundoff)]
    }

    /// Writes the exact value of a number as `name` from now on.
    pub fn rename(&mut self, number: Bounded, name: &Polynomial) {
        let value = self.value(number);
        let renamed = sum(name, &difference(&value, &exact(&value)));
        self.values.insert(number, renamed);
    }

    /// Takes a number as `name`, with a relative error of at most `relative u`.
    pub fn take(&mut self, number: Bounded, name: &Polynomial, relative: f64) {
        let error = self.error(name.clone().scaled(relative * arithmetic().roundoff), true);
        self.values.insert(number, name.clone().plus(&error));
    }

    fn value(&mut self, number: Bounded) -> Polynomial {
        if let Some(value) = self.values.get(&number) {
            return value.clone();
        }
        let value = match number.operation() {
            Operation::Input(variable) => {
                let given = self.inputs.iter().find(|(input, _)| *input == variable);
                given.map_or_else(|| Polynomial::of([variable]), |(_, polynomial)| polynomial.clone())
            }
            Operation::Constant(bits) => Polynomial::constant(f64::from_bits(bits)),
            Operation::Negative(of) => self.value(of).scaled(-1.0),
            Operation::Sum(a, b) if a == b => self.value(a).scaled(2.0),
            Operation::Sum(x, y) => match two_sum(x, y) {
                Some([a, b, rounded]) => difference(&sum(&self.value(a), &self.value(b)), &self.value(rounded)),
                None => {
                    let exact = sum(&self.value(x), &self.value(y));
                    self.rounded(exact, true)
                }
            },
            Operation::Difference(a, b) => {
                let exact = difference(&self.value(a), &self.value(b));
                self.rounded(exact, true)
            }
            Operation::Product(a, b) => {
                let exact = sum(&Polynomial::default(), &self.value(a).times(&self.value(b)));
                if a.raw().is_power_of_two || b.raw().is_power_of_two { exact } else { self.rounded(exact, true) }
            }
            Operation::Fused(a, b, c) => {
                let exact = sum(&self.value(a).times(&self.value(b)), &self.value(c));
                self.rounded(exact, false)
            }
            operation => panic!("{operation:?} makes no polynomial"),
        };
        self.values.insert(number, value.clone());
        value
    }

    /// Returns the value after rounding: itself if it is the rounding error of a sum or product.
    fn rounded(&mut self, value: Polynomial, is_number: bool) -> Polynomial {
        if let Some((monomial, 1.0 | -1.0)) = value.0.first_key_value().map(|(monomial, &factor)| (monomial, factor))
            && value.0.len() == 1
            && let [(ERROR, index)] = monomial[..]
            && self.errors[usize::from(index)].1
        {
            return value;
        }
        let bound = self.magnitude(&value).scaled(arithmetic().roundoff);
        value.plus(&self.error(bound, is_number))
    }

    /// Returns a new rounding error with this bound.
    fn error(&mut self, bound: Polynomial, is_number: bool) -> Polynomial {
        let index = u8::try_from(self.errors.len()).expect("there are few operations");
        self.errors.push((bound, is_number));
        Polynomial::of([(ERROR, index)])
    }

    /// Returns a bound of the magnitude.
    fn magnitude(&self, value: &Polynomial) -> Polynomial {
        let exact = exact(value);
        let is = |known: &Polynomial| *known == exact || known.clone().scaled(-1.0) == exact;
        let known = self.known.iter().find(|(known, _)| is(known));
        let mut bound = known.map(|(_, bound)| bound.clone()).unwrap_or_default();
        for (monomial, coefficient) in value.0.iter().filter(|(monomial, _)| known.is_none() || has_error(monomial)) {
            let factors = monomial.iter().map(|&variable| match variable {
                (ERROR, index) => self.errors[usize::from(index)].0.clone(),
                _ => Polynomial::of([variable]),
            });
            let start = Polynomial::constant(coefficient.abs());
            bound = bound.plus(&factors.fold(start, |product, factor| product.times(&factor)));
        }
        bound
    }
}

/// Returns the terms without rounding errors.
fn exact(value: &Polynomial) -> Polynomial {
    Polynomial(value.0.clone().into_iter().filter(|(monomial, _)| !has_error(monomial)).collect())
}

fn has_error(monomial: &Monomial) -> bool {
    monomial.iter().any(|variable| variable.0 == ERROR)
}
