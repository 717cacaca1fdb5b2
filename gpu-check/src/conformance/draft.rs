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

/// Returns the inputs of a case as numbers.
fn numbers<I: Bits, const N: usize>(case: &[u64]) -> [I; N] {
    std::array::from_fn(|index| I::of_bits(case[index]))
}

impl<I: Bits, O: Bits, const N: usize> Draft<I, O, N> {
    /// Starts a probe of the expression `result`, whose inputs are called `a`, `b`, `c` and `d`. The function
    /// `as_written` calculates the expression as it is written.
    #[must_use]
    pub fn new(
        name: &str,
        result: &'static str,
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
            rule: "",
            input: I::TYPE,
            output: O::TYPE,
            declarations: "",
            statements: "",
            result,
            has_surplus: true,
            may_be_refused: false,
            cases,
            readings: Vec::new(),
        };
        Self { probe, types: PhantomData }
            .reading("as written", Kind::AsWritten, move |case| Allowed::only(as_written(case)))
    }

    /// Sets the text that says what IEEE 754 and WGSL allow.
    #[must_use]
    pub fn rule(mut self, rule: &'static str) -> Self {
        self.probe.rule = rule;
        self
    }

    /// Sets the declarations before the entry point, and the statements before the result.
    #[must_use]
    pub fn code(mut self, declarations: &'static str, statements: &'static str) -> Self {
        (self.probe.declarations, self.probe.statements) = (declarations, statements);
        self
    }

    /// Starts no invocations beyond the cases. The number of cases must be a multiple of the workgroup's size.
    #[must_use]
    pub fn uniform(mut self) -> Self {
        self.probe.has_surplus = false;
        self
    }

    /// Accepts that an implementation refuses the program.
    #[must_use]
    pub fn may_be_refused(mut self) -> Self {
        self.probe.may_be_refused = true;
        self
    }

    /// Adds a reading that allows several results for a case.
    #[must_use]
    pub fn reading(mut self, name: &'static str, kind: Kind, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        self.probe.readings.push(Reading::new(name, kind, move |case| allowed(numbers(case))));
        self
    }

    /// Adds the rewriting that calculates `formula`.
    #[must_use]
    pub fn rewriting(self, name: &'static str, formula: impl Fn([I; N]) -> O + 'static) -> Self {
        self.reading(name, Kind::Rewriting, move |case| Allowed::only(formula(case)))
    }

    /// Adds a reading that allows results within an error.
    #[must_use]
    pub fn error(self, name: &'static str, allowed: impl Fn([I; N]) -> Allowed + 'static) -> Self {
        self.reading(name, Kind::Error, allowed)
    }

    /// Adds the reading that a driver assumes that there is no NaN and no infinity. It allows anything for the cases
    /// that `is_outside` names, and the result as written for the others.
    #[must_use]
    pub fn finite_math(self, is_outside: impl Fn([I; N]) -> bool + 'static) -> Self {
        self.indeterminate("indeterminate value (assumes finite numbers)", is_outside)
    }

    /// Adds a reading of this name that allows anything for the cases that `is_outside` names, and the result as
    /// written for the others.
    #[must_use]
    pub fn indeterminate(mut self, name: &'static str, is_outside: impl Fn([I; N]) -> bool + 'static) -> Self {
        let as_written = self.probe.readings.remove(0);
        // The closure needs the first reading, which also stays first, so both share it.
        let shared = std::rc::Rc::new(as_written);
        let first = std::rc::Rc::clone(&shared);
        let again = Reading::new(shared.name, shared.kind, move |case| first.allowed(case));
        self.probe.readings.insert(0, again);
        self.probe.readings.push(Reading::new(name, Kind::Rewriting, move |case| {
            if is_outside(numbers(case)) { Allowed::Anything } else { shared.allowed(case) }
        }));
        self
    }

    /// Returns the probe.
    #[must_use]
    pub fn done(self) -> Probe {
        self.probe
    }
}
