//! A number that carries a bound of its exact value and a bound of its rounding error.

use std::cell::RefCell;
use std::collections::HashMap;

use cpu::Vec3;

use super::bounds::{ARITHMETIC, Arithmetic, Bounds, arithmetic};
use super::polynomial::{LENGTH, Polynomial, Variable};

/// A number of the formulas, as the place of its bounds in a table of this thread. Equal operations on equal numbers
/// have the same place, so a lemma about a number holds wherever a formula computes it again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bounded(u32);

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
    places: HashMap<Operation, Bounded>,
    numbers: Vec<(Operation, Bounds)>,
    compared: Vec<[Bounded; 2]>,
    /// The value of the constant whose use in the formulas is followed.
    margin: f64,
}

thread_local! {
    static TABLE: RefCell<Table> = RefCell::new(Table::new(f64::NAN));
}

impl Table {
    fn new(margin: f64) -> Self {
        Self { places: HashMap::new(), numbers: Vec::new(), compared: Vec::new(), margin }
    }
}

/// The variable for the constant of the margin that is proved.
pub const MARGIN: Variable = (u8::MAX, LENGTH);

/// The variable in place of [`MARGIN`] in products of which it is not known how large they are at least.
pub const LOST_MARGIN: Variable = (u8::MAX - 1, LENGTH);
const LOST: [(u8, Option<u8>); 1] = [(MARGIN.0, Some(LOST_MARGIN.0))];

/// Forgets all numbers of this thread, and begins a proof about this arithmetic. Where the formulas use the constant
/// `margin`, the bounds have the variable [`MARGIN`].
pub fn begin(arithmetic: Arithmetic, margin: f64) {
    ARITHMETIC.set(arithmetic);
    TABLE.set(Table::new(margin));
}

/// Returns the pairs of numbers that have been compared, in order.
#[must_use]
pub fn compared() -> Vec<[Bounded; 2]> {
    TABLE.with_borrow(|table| table.compared.clone())
}

/// Returns all numbers, each after those it is computed from.
pub(super) fn numbers() -> impl Iterator<Item = Bounded> {
    (0..TABLE.with_borrow(|table| table.numbers.len() as u32)).map(Bounded)
}

/// Forgets all comparisons, and all numbers that were computed after this one. So a formula that runs again takes the
/// lemmas about this number, and about those before it.
pub fn forget_later(number: Bounded) {
    TABLE.with_borrow_mut(|table| {
        table.numbers.truncate(number.0 as usize + 1);
        table.places.retain(|_, place| place.0 <= number.0);
        table.compared.clear();
    });
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
        let bounds = Bounds::of_value(size, error);
        let number = Self::of_operation(Operation::Input(variable), || bounds.clone());
        assert_eq!(number.raw().error, bounds.error, "another input has this name");
        number
    }

    /// Returns a constant of the code with a relative error of at most `error u`, or the margin that is proved.
    #[must_use]
    pub fn constant(value: f64, error: f64) -> Self {
        let is_margin = TABLE.with_borrow(|table| table.margin == value.abs());
        let size = if is_margin { Polynomial::of([MARGIN]) } else { Polynomial::constant(value.abs()) };
        // A power of two has no bits after the leading one. A margin is not multiplied exactly, as it may change.
        let is_power_of_two = !is_margin && error == 0.0 && value.to_bits() << 12 == 0 && value != 0.0;
        let (is_positive, is_exact) = (value >= 0.0, true);
        let bounds = Bounds { is_positive, is_exact, is_power_of_two, ..Bounds::of_value(size, error) };
        Self::of_operation(Operation::Constant(value.to_bits()), || bounds)
    }

    /// Returns the vector with the components of a family, with a relative error of at most `error u` each.
    pub fn vector(family: u8, error: f64) -> Vec3<Self> {
        Vec3::new(0, 1, 2).map(|component| Self::input((family, component), error))
    }

    /// Returns a number such as a radius, which is the length of its `family`. Its relative error is at most `error u`.
    #[must_use]
    pub fn number(family: u8, error: f64) -> Self {
        Self::input((family, LENGTH), error).of_squares()
    }

    /// Returns what is known of the number, in lengths of vectors.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        self.raw().in_lengths()
    }

    /// Returns what is known of the number, in the components of vectors.
    #[must_use]
    pub fn raw(self) -> Bounds {
        TABLE.with_borrow(|table| table.numbers[self.0 as usize].1.clone())
    }

    /// Returns the number, of which `size` is the value itself: a length, or a sum of squares.
    #[must_use]
    pub fn of_squares(self) -> Self {
        self.change(|bounds| (bounds.is_positive, bounds.is_exact) = (true, true));
        self
    }

    /// Returns the one of two numbers that was computed later.
    #[must_use]
    pub fn later(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    /// Returns the place of the number in the table.
    pub(super) fn place(self) -> usize {
        self.0 as usize
    }

    /// Returns the formula of the number, down to this depth. An input has its family and component.
    pub(super) fn formula(self, depth: u32) -> String {
        let of = |number: Self| number.formula(depth.saturating_sub(1));
        match self.operation() {
            Operation::Input((family, component)) => format!("x{family}.{component}"),
            Operation::Constant(bits) => format!("{:e}", f64::from_bits(bits)),
            _ if depth == 0 => "..".to_owned(),
            Operation::Sum(a, b) => format!("({} + {})", of(a), of(b)),
            Operation::Difference(a, b) => format!("({} - {})", of(a), of(b)),
            Operation::Product(a, b) => format!("{} * {}", of(a), of(b)),
            Operation::Fused(a, b, c) => format!("({} * {} + {})", of(a), of(b), of(c)),
            Operation::Quotient(a, b) => format!("{} / {}", of(a), of(b)),
            Operation::Negative(a) => format!("-{}", of(a)),
            Operation::Magnitude(a) | Operation::Flipped(a, _) => format!("|{}|", of(a)),
            Operation::Root(a) => format!("sqrt({})", of(a)),
        }
    }

    /// Returns how the number has been computed.
    pub(super) fn operation(self) -> Operation {
        TABLE.with_borrow(|table| table.numbers[self.0 as usize].0)
    }

    fn change(self, change: impl FnOnce(&mut Bounds)) {
        TABLE.with_borrow_mut(|table| change(&mut table.numbers[self.0 as usize].1));
    }

    /// Applies a lemma: the exact magnitude of the number is at most `size`. If `size` is one product of variables, it
    /// is the magnitude. Numbers that were computed from it before keep their bounds.
    ///
    /// # Panics
    /// If the number is an input.
    pub fn assume(self, size: Polynomial) {
        let Bounds { before, relative, is_positive, .. } = self.raw();
        if relative.is_finite() {
            return self.assume_relative(size, relative);
        }
        let is_exact = size.is_monomial();
        let bounds = Bounds::rounded(size, before.expect("only a computed number has a lemma"));
        self.change(|old| *old = Bounds { is_positive, is_exact, ..bounds });
    }

    /// Applies a lemma: the exact magnitude of the number is at most `size`, and its relative error at most `error u`.
    pub fn assume_relative(self, size: Polynomial, error: f64) {
        self.assume_error(size.clone(), size.scaled(error));
        self.change(|bounds| bounds.relative = error);
    }

    /// Applies a lemma: the exact magnitude of the number is at most `size`, and its error at most `u error`.
    pub fn assume_error(self, size: Polynomial, error: Polynomial) {
        let (is_exact, relative) = (size.is_monomial(), f64::INFINITY);
        self.change(|bounds| *bounds = Bounds { error, size, relative, is_exact, ..bounds.clone() });
    }

    /// Returns the number that an operation makes, with these bounds if the operation is new.
    pub(super) fn of_operation(operation: Operation, bounds: impl FnOnce() -> Bounds) -> Self {
        if let Some(place) = TABLE.with_borrow(|table| table.places.get(&operation).copied()) {
            return place;
        }
        let bounds = bounds();
        TABLE.with_borrow_mut(|table| {
            let place = Self(table.numbers.len() as u32);
            table.numbers.push((operation, bounds));
            table.places.insert(operation, place);
            place
        })
    }

    /// Returns the number that `operation` makes of a sum.
    pub(super) fn sum(self, other: Self, operation: Operation) -> Self {
        Self::of_operation(operation, || {
            let (a, b) = (self.raw(), other.raw());
            let are_positive = a.is_positive && b.is_positive && matches!(operation, Operation::Sum(..));
            let relative = if are_positive { a.relative.max(b.relative) } else { f64::INFINITY };
            let rounded = Bounds::rounded(a.size.plus(&b.size), a.error.plus(&b.error));
            rounded.with_relative(relative, are_positive, are_positive && a.is_exact && b.is_exact)
        })
    }

    /// Returns the size of an exact product of the computed operands, and its error, which includes underflow.
    pub(super) fn product(self, other: Self) -> [Polynomial; 2] {
        let (a, b) = (self.bounds(), other.bounds());
        let both = a.error.times(&b.error).scaled(arithmetic().roundoff);
        let error = a.size.times(&b.error).plus(&b.size.times(&a.error)).plus(&both);
        // The size of the other operand may be far above its magnitude. Then nothing is known of the margin.
        let margin =
            |of: &Bounds, other: &Bounds| if other.is_exact { of.size.clone() } else { of.size.enlarged(&LOST) };
        [margin(&a, &b).times(&margin(&b, &a)), error.plus(&Polynomial::constant(arithmetic().underflow))]
    }

    /// Returns the number with another sign, which has the same bounds.
    pub(super) fn with_sign(self, is_positive: bool, operation: Operation) -> Self {
        Self::of_operation(operation, || Bounds { is_positive, ..self.raw() })
    }

    /// Notes that the code compares two numbers.
    pub(super) fn compare(self, other: Self) {
        TABLE.with_borrow_mut(|table| table.compared.push([self, other]));
    }

    /// Returns a number of which only the relative error, without the last rounding, is known.
    pub(super) fn relative(before: f64, is_positive: bool, operation: Operation) -> Self {
        let infinite = Polynomial::constant(f64::INFINITY);
        let bounds = || Bounds::rounded(infinite.clone(), infinite).with_relative(before, is_positive, false);
        Self::of_operation(operation, bounds)
    }
}
