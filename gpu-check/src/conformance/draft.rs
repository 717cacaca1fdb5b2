//! Builds probes. The formulas are closures over numbers of Rust, so that the compiler checks their types.

use std::marker::PhantomData;

use super::probe::Probe;
use super::reading::{Allowed, Kind, Reading};
use super::value::{Type, Value};

/// A probe that is being built: `N` inputs of type `I` and a result of type `O`.
#[derive(Debug)]
pub struct Draft<I, O, const N: usize> {
    probe: Probe,
    types: PhantomData<fn([I; N]) -> O>,
}

impl<I: Value, O: Value, const N: usize> Draft<I, O, N> {
    /// Starts a probe of the expression `result`, whose inputs are called `a`, `b` and `c`. The text `rule` says what
    /// IEEE 754 and WGSL allow. The function `as_written` calculates the expression as it is written.
    #[must_use]
    pub fn new(
        name: &str,
        result: &'static str,
        rule: &'static str,
        cases: impl IntoIterator<Item = [I; N]>,
        as_written: impl Fn([I; N]) -> O + 'static,
    ) -> Self {
        let cases = cases.into_iter().map(|case| case.map(I::to_f64).to_vec()).collect();
        // Probes that differ only in their floating-point type have that type at the end of their names.
        let of_f64 = I::TYPE == Type::F64 || O::TYPE == Type::F64;
        let name = if of_f64 && !name.contains("f64") { format!("{name}-f64") } else { name.to_owned() };
        let as_written = move |case| Allowed::any_of([as_written(case)]);
        let probe = Probe {
            name,
            group: "",
            rule,
            input: I::TYPE,
            output: O::TYPE,
            statements: "",
            result,
            may_be_refused: false,
            cases,
            as_written: Self::reading("as written", Kind::AsWritten, as_written),
            others: Vec::new(),
        };
        Self { probe, types: PhantomData }
    }

    /// Sets the statements before the result.
    #[must_use]
    pub fn statements(mut self, statements: &'static str) -> Self {
        self.probe.statements = statements;
        self
    }

    /// Accepts that an implementation refuses the program.
    #[must_use]
    pub fn may_be_refused(mut self) -> Self {
        self.probe.may_be_refused = true;
        self
    }

    /// Adds the rewriting that calculates `formula`.
    #[must_use]
    pub fn rewriting(self, name: &'static str, formula: impl Fn([I; N]) -> O + 'static) -> Self {
        self.rewritings(name, move |case| Allowed::any_of([formula(case)]))
    }

    /// Adds a rewriting that allows several results for a case.
    #[must_use]
    pub fn rewritings(mut self, name: &'static str, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        self.probe.others.push(Self::reading(name, Kind::Rewriting, allowed));
        self
    }

    /// Adds a reading that allows results within an error.
    #[must_use]
    pub fn error(mut self, name: &'static str, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        self.probe.others.push(Self::reading(name, Kind::Error, allowed));
        self
    }

    fn reading(name: &'static str, kind: Kind, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Reading {
        let allowed = Box::new(move |case: &[f64]| allowed(std::array::from_fn(|index| I::of_f64(case[index]))));
        Reading { name, kind, allowed }
    }

    /// Returns the probe.
    #[must_use]
    pub fn done(self) -> Probe {
        self.probe
    }
}
