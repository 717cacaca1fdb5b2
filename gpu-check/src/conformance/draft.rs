//! Builds probes. The formulas are closures over numbers of Rust, so that the compiler checks their types.

use std::marker::PhantomData;

use super::probe::Probe;
use super::reading::{Allowed, Kind, Reading};
use super::value::{Bits, Type};

/// A probe that is being built: `N` inputs of type `I` and a result of type `O`.
#[derive(Debug)]
pub struct Draft<I, O, const N: usize> {
    probe: Probe,
    types: PhantomData<fn([I; N]) -> O>,
}

impl<I: Bits, O: Bits, const N: usize> Draft<I, O, N> {
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
        let cases = cases.into_iter().map(|case| case.map(I::to_word).to_vec()).collect();
        // Probes that differ only in their floating-point type have that type at the end of their names.
        let of_f64 = I::TYPE == Type::F64 || O::TYPE == Type::F64;
        let name = if of_f64 && !name.contains("f64") { format!("{name}-f64") } else { name.to_owned() };
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
            readings: Vec::new(),
        };
        Self { probe, types: PhantomData }
            .reading("as written", Kind::AsWritten, move |case| Allowed::only(as_written(case)))
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
        self.reading(name, Kind::Rewriting, move |case| Allowed::only(formula(case)))
    }

    /// Adds a rewriting that allows several results for a case.
    #[must_use]
    pub fn rewritings(self, name: &'static str, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        self.reading(name, Kind::Rewriting, allowed)
    }

    /// Adds a reading that allows results within an error.
    #[must_use]
    pub fn error(self, name: &'static str, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        self.reading(name, Kind::Error, allowed)
    }

    fn reading(mut self, name: &'static str, kind: Kind, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        let of_bits = move |case: &[u64]| allowed(std::array::from_fn(|index| I::of_bits(case[index])));
        self.probe.readings.push(Reading::new(name, kind, of_bits));
        self
    }

    /// Returns the probe.
    #[must_use]
    pub fn done(self) -> Probe {
        self.probe
    }
}
