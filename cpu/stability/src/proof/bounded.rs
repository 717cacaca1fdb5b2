//! A number that carries a bound of its exact value and a bound of its rounding error.

use std::cell::RefCell;
use std::collections::HashMap;

use cpu::Vec3;

use super::polynomial::{LENGTH, Polynomial, Variable};

/// A number of the formulas, as the place of its bounds in a table of this thread. Equal operations on equal numbers
/// have the same place, so a lemma about a number holds wherever a formula computes it again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bounded(u32);

/// What is known of a number: `|exact| <= size` and `|computed - exact| <= u error`.
#[derive(Clone, Debug, Default)]
pub struct Bounds {
    /// Bounds the magnitude of the exact value.
    pub size: Polynomial,
    /// Bounds the rounding error, in units of the unit roundoff.
    pub error: Polynomial,
    /// Bounds the part of the error that the operands bring, without the last rounding. `None` for inputs and
    /// constants.
    pub(super) before: Option<Polynomial>,
}

/// The rounding of an arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Arithmetic {
    /// The unit roundoff `u`.
    pub roundoff: f64,
    /// The largest error of a product by underflow, half of the smallest number, in units of `u`.
    pub underflow: f64,
}

impl Arithmetic {
    /// The arithmetic of `f64`.
    pub const F64: Self = Self { roundoff: f64::EPSILON / 2.0, underflow: f64::MIN_POSITIVE };
    /// The arithmetic of `f32`.
    pub const F32: Self = Self { roundoff: f32::EPSILON as f64 / 2.0, underflow: f32::MIN_POSITIVE as f64 };
}

/// How a number has been computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    Input(Variable),
    Constant(u64),
    Sum(Bounded, Bounded),
    Difference(Bounded, Bounded),
    Product(Bounded, Bounded),
    Fused(Bounded, Bounded, Bounded),
    Quotient(Bounded, Bounded),
    Negative(Bounded),
    Magnitude(Bounded),
    Flipped(Bounded, Bounded),
    Root(Bounded),
}

struct Table {
    arithmetic: Arithmetic,
    places: HashMap<Operation, Bounded>,
    bounds: Vec<Bounds>,
    compared: Vec<[Bounded; 2]>,
    /// The value of the constant whose use in the formulas is followed.
    margin: f64,
}

thread_local! {
    static TABLE: RefCell<Table> = RefCell::new(Table::new(Arithmetic::F64, f64::NAN));
}

impl Table {
    fn new(arithmetic: Arithmetic, margin: f64) -> Self {
        Self { arithmetic, places: HashMap::new(), bounds: Vec::new(), compared: Vec::new(), margin }
    }
}

/// The variable for the constant of the margin that is proved.
pub const MARGIN: Variable = (u8::MAX, LENGTH);

/// Forgets all numbers of this thread, and begins a proof about this arithmetic. Where the formulas use the constant
/// `margin`, the bounds have the variable [`MARGIN`].
pub fn begin(arithmetic: Arithmetic, margin: f64) {
    TABLE.set(Table::new(arithmetic, margin));
}

/// Returns the pairs of numbers that have been compared, in order.
#[must_use]
pub fn compared() -> Vec<[Bounded; 2]> {
    TABLE.with_borrow(|table| table.compared.clone())
}

pub(super) fn arithmetic() -> Arithmetic {
    TABLE.with_borrow(|table| table.arithmetic)
}

impl Bounds {
    /// Returns the bounds of a result with this exact size, into which the operands bring the error `before`, and which
    /// is then rounded once.
    pub(super) fn rounded(size: Polynomial, before: Polynomial) -> Self {
        let rounding = size.clone().plus(&before.clone().scaled(arithmetic().roundoff));
        Self { size, error: before.clone().plus(&rounding), before: Some(before) }
    }

    /// Returns the bounds with lengths of vectors in place of products of components.
    #[must_use]
    pub fn in_lengths(&self) -> Self {
        let before = self.before.as_ref().map(Polynomial::in_lengths);
        Self { size: self.size.in_lengths(), error: self.error.in_lengths(), before }
    }
}

impl Bounded {
    /// Returns an input whose exact magnitude is the variable, and whose relative error is at most `error u`.
    #[must_use]
    pub fn input(variable: Variable, error: f64) -> Self {
        Self::known(variable, Polynomial::of([variable]), error)
    }

    /// Returns an input whose exact magnitude is at most `size`, and whose error is at most `error u size`. `family`
    /// must have no other input.
    #[must_use]
    pub fn of_size(family: u8, size: Polynomial, error: f64) -> Self {
        Self::known((family, LENGTH), size, error)
    }

    fn known(variable: Variable, size: Polynomial, error: f64) -> Self {
        let bounds = Bounds { error: size.clone().scaled(error), before: None, size };
        let number = Self::of_operation(Operation::Input(variable), || bounds.clone());
        assert_eq!(number.raw().error, bounds.error, "another input has this name");
        number
    }

    /// Returns a constant of the code with a relative error of at most `error u`, or the margin that is proved.
    #[must_use]
    pub fn constant(value: f64, error: f64) -> Self {
        let is_margin = TABLE.with_borrow(|table| table.margin == value.abs());
        let size = if is_margin { Polynomial::of([MARGIN]) } else { Polynomial::constant(value.abs()) };
        let bounds = Bounds { error: size.clone().scaled(error), before: None, size };
        Self::of_operation(Operation::Constant(value.to_bits()), || bounds)
    }

    /// Returns the vector with the components of a family, with a relative error of at most `error u` each.
    pub fn vector(family: u8, error: f64) -> Vec3<Self> {
        Vec3::new(0, 1, 2).map(|component| Self::input((family, component), error))
    }

    /// Returns the number whose magnitude is the length of a family, with a relative error of at most `error u`.
    #[must_use]
    pub fn number(family: u8, error: f64) -> Self {
        Self::input((family, LENGTH), error)
    }

    /// Returns what is known of the number, in lengths of vectors.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        self.raw().in_lengths()
    }

    /// Returns what is known of the number, in the components of vectors.
    #[must_use]
    pub fn raw(self) -> Bounds {
        TABLE.with_borrow(|table| table.bounds[self.0 as usize].clone())
    }

    /// Applies a lemma: the exact magnitude of the number is at most `size`. Numbers that were computed from it before
    /// keep their bounds.
    ///
    /// # Panics
    /// If the number is an input.
    pub fn assume(self, size: Polynomial) {
        let bounds = Bounds::rounded(size, self.raw().before.expect("only a computed number has a lemma"));
        TABLE.with_borrow_mut(|table| table.bounds[self.0 as usize] = bounds);
    }

    /// Returns the number that an operation makes, with these bounds if the operation is new.
    pub(super) fn of_operation(operation: Operation, bounds: impl FnOnce() -> Bounds) -> Self {
        if let Some(place) = TABLE.with_borrow(|table| table.places.get(&operation).copied()) {
            return place;
        }
        let bounds = bounds();
        TABLE.with_borrow_mut(|table| {
            let place = Self(table.bounds.len() as u32);
            table.bounds.push(bounds);
            table.places.insert(operation, place);
            place
        })
    }

    /// Returns the number that `operation` makes of a sum.
    pub(super) fn sum(self, other: Self, operation: Operation) -> Self {
        Self::of_operation(operation, || {
            let (a, b) = (self.raw(), other.raw());
            Bounds::rounded(a.size.plus(&b.size), a.error.plus(&b.error))
        })
    }

    /// Returns the size of an exact product of the computed operands, and its error, which includes underflow.
    pub(super) fn product(self, other: Self) -> [Polynomial; 2] {
        let (a, b) = (self.bounds(), other.bounds());
        let both = a.error.times(&b.error).scaled(arithmetic().roundoff);
        let error = a.size.times(&b.error).plus(&b.size.times(&a.error)).plus(&both);
        [a.size.times(&b.size), error.plus(&Polynomial::constant(arithmetic().underflow))]
    }

    /// Returns the number with another sign, which has the same bounds.
    pub(super) fn with_sign(self, operation: Operation) -> Self {
        Self::of_operation(operation, || self.raw())
    }

    /// Notes that the code compares two numbers.
    pub(super) fn compare(self, other: Self) {
        TABLE.with_borrow_mut(|table| table.compared.push([self, other]));
    }

    /// Returns a number of which nothing is known.
    pub(super) fn unknown(operation: Operation) -> Self {
        let infinite = Polynomial::constant(f64::INFINITY);
        Self::of_operation(operation, || Bounds::rounded(infinite.clone(), infinite))
    }
}
