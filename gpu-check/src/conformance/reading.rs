//! One way to calculate a program that IEEE 754 or WGSL allows, with the results that it allows.

use std::fmt;

use super::value::{Type, Value};
use crate::Float;

/// The results that a reading allows for one case.
#[derive(Clone, Debug, PartialEq)]
pub enum Allowed {
    /// Any of these numbers.
    OneOf(Vec<f64>),
    /// Any number from the first to the second, but not NaN.
    Between(f64, f64),
}

impl Allowed {
    /// Allows these numbers.
    #[must_use]
    pub fn any_of<T: Value>(numbers: impl IntoIterator<Item = T>) -> Self {
        Self::OneOf(numbers.into_iter().map(T::to_f64).collect())
    }

    /// Whether a result is allowed. The sign of zero counts.
    #[must_use]
    pub fn contains(&self, result: f64) -> bool {
        match self {
            Self::OneOf(numbers) => numbers.iter().any(|number| number.same(result)),
            Self::Between(low, high) => (*low..=*high).contains(&result),
        }
    }

    /// Returns the allowed results as text.
    #[must_use]
    pub fn show(&self, of: Type) -> String {
        match self {
            Self::OneOf(numbers) => numbers.iter().map(|number| of.show(*number)).collect::<Vec<_>>().join(" or "),
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
type AllowedFor = dyn Fn(&[f64]) -> Allowed;

/// A reading of a program: its name, and the results that it allows for each case.
pub struct Reading {
    /// The name, as it is in tables.
    pub name: &'static str,
    /// What it means if results follow this reading.
    pub kind: Kind,
    /// Returns the allowed results for the inputs of a case.
    pub allowed: Box<AllowedFor>,
}

impl Reading {
    /// Returns the indices of the results that this reading does not allow.
    #[must_use]
    pub fn wrong(&self, cases: &[Vec<f64>], results: &[f64]) -> Vec<usize> {
        let pairs = cases.iter().zip(results).enumerate();
        pairs.filter(|(_, (case, result))| !(self.allowed)(case).contains(**result)).map(|(index, _)| index).collect()
    }
}

impl fmt::Debug for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: {}", self.kind, self.name)
    }
}
