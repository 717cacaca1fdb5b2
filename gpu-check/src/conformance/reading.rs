//! One way to calculate a program that IEEE 754 or WGSL allows, with the results that it allows.

use std::fmt;

use super::value::{Bits, Type};

/// The results that a reading allows for one case.
#[derive(Clone, Debug, PartialEq)]
pub enum Allowed {
    /// Any of these numbers, given as bits.
    OneOf(Vec<u64>),
    /// Any number from the first to the second, but not NaN.
    Between(f64, f64),
}

impl Allowed {
    /// Allows this number alone.
    #[must_use]
    pub fn only<T: Bits>(number: T) -> Self {
        Self::OneOf(vec![number.to_word()])
    }

    /// Allows these numbers.
    #[must_use]
    pub fn any_of<T: Bits>(numbers: impl IntoIterator<Item = T>) -> Self {
        Self::OneOf(numbers.into_iter().map(T::to_word).collect())
    }

    /// Whether a result of type `of` is allowed.
    #[must_use]
    pub fn contains(&self, of: Type, bits: u64) -> bool {
        match self {
            Self::OneOf(numbers) => numbers.iter().any(|number| of.same(*number, bits)),
            Self::Between(low, high) => (*low..=*high).contains(&of.value(bits)),
        }
    }

    /// Returns the allowed results as text.
    #[must_use]
    pub fn show(&self, of: Type) -> String {
        match self {
            Self::OneOf(numbers) => numbers.iter().map(|bits| of.show(*bits)).collect::<Vec<_>>().join(" or "),
            Self::Between(low, high) => format!("{low:?} to {high:?}"),
        }
    }
}

/// What it means if a driver's results follow a reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The driver calculates each operation as written, and rounds it correctly.
    AsWritten,
    /// The driver calculates another formula, which the specification allows.
    Rewriting,
    /// The driver's results are within the error that the specification allows.
    Error,
}

/// A function from the inputs of a case to the results that a reading allows.
type AllowedResults = Box<dyn Fn(&[u64]) -> Allowed>;

/// A reading of a program: its name, and the results that it allows for each case.
pub struct Reading {
    /// The name, as it is in tables.
    pub name: &'static str,
    /// What it means if results follow this reading.
    pub kind: Kind,
    allowed: AllowedResults,
}

impl Reading {
    /// Returns a reading that allows `allowed(case)` for a case.
    pub fn new(name: &'static str, kind: Kind, allowed: impl Fn(&[u64]) -> Allowed + 'static) -> Self {
        Self { name, kind, allowed: Box::new(allowed) }
    }

    /// Returns the results that are allowed for a case.
    #[must_use]
    pub fn allowed(&self, case: &[u64]) -> Allowed {
        (self.allowed)(case)
    }
}

impl fmt::Debug for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: {}", self.kind, self.name)
    }
}
