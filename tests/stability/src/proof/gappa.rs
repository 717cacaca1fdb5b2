//! Exports proofs of margins as text for Gappa, an independent prover of bounds of rounding errors.
//!
//! The formulas of `cpu` run over [`Bounded`], which keeps how each number is computed. `Script` writes these
//! operations in Gappa's language, each one with its rounding and without. No bound of our own prover is exported.
//! What Gappa cannot know is given as a hypothesis: the inequality of Cauchy and Schwarz, and bounds that an earlier
//! script proves.

mod background;
mod camera;
mod cap;
mod hypotheses;
mod largest;
mod scripts;
mod sphere;

use std::collections::HashMap;
use std::fmt::Write;

use super::bounded::{Bounded, Operation};
pub use scripts::scripts;

/// A proof for Gappa.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The row of docs/margins.md that the proof belongs to.
    pub row: &'static str,
    /// What Gappa proves, and how it bears on the row.
    pub what: &'static str,
    /// The text that Gappa reads. Gappa ends with status 0 if it proves the text.
    pub text: String,
    /// A part of the text, and what makes the text wrong in its place: less precision, or a constant below the need.
    pub wrong: [String; 2],
}

/// A text in Gappa's language that defines numbers, with their rounding and without.
#[derive(Debug)]
struct Script {
    definitions: String,
    names: HashMap<Bounded, [String; 2]>,
}

impl Script {
    fn new() -> Self {
        Self { definitions: "@rnd = float<ieee_64, ne>;\n".to_owned(), names: HashMap::new() }
    }

    /// Defines a number by expressions for its computed value and its exact one, in place of the operations that
    /// compute it. Returns the names of both values.
    fn define(&mut self, number: Bounded, [computed, exact]: [&str; 2]) -> [String; 2] {
        let names = ["c", "e"].map(|kind| format!("{kind}{}", number.place()));
        // Writing to a `String` never fails, so errors are ignored.
        let _ = writeln!(self.definitions, "{} = {exact};\n{} = {computed};", names[1], names[0]);
        self.names.insert(number, names.clone());
        names
    }

    /// Defines a number and all numbers that it is computed from, each by its operation. Returns the names of the
    /// computed value and of the exact one.
    fn export(&mut self, number: Bounded) -> [String; 2] {
        if let Some(names) = self.names.get(&number) {
            return names.clone();
        }
        let mut of = |number: Bounded| self.export(number);
        let two = |[a, b]: [[String; 2]; 2], operator: &str| {
            [0, 1].map(|index| format!("{} {operator} {}", a[index], b[index]))
        };
        let [computed, exact] = match number.operation() {
            Operation::Input((family, component)) => [(); 2].map(|()| format!("x{family}_{component}")),
            Operation::Constant(bits) => [(); 2].map(|()| dyadic(f64::from_bits(bits))),
            Operation::Sum(a, b) => rounded(two([of(a), of(b)], "+")),
            Operation::Difference(a, b) => rounded(two([of(a), of(b)], "-")),
            Operation::Product(a, b) => rounded(two([of(a), of(b)], "*")),
            Operation::Quotient(a, b) => rounded(two([of(a), of(b)], "/")),
            Operation::Fused(a, b, c) => {
                let ([a, b], c) = ([of(a), of(b)], of(c));
                rounded(two([two([a, b], "*"), c], "+"))
            }
            Operation::Root(a) => rounded(of(a).map(|a| format!("sqrt({a})"))),
            Operation::Negative(a) => of(a).map(|a| format!("-{a}")),
            Operation::Magnitude(a) => of(a).map(|a| format!("|{a}|")),
            Operation::Flipped(..) => unreachable!("no exported formula flips a sign"),
        };
        self.define(number, [&computed, &exact])
    }

    /// Removes the definitions of computed values (`c`) or of exact ones (`e`), if a proof needs only the others. Gappa
    /// then takes a tenth of the time.
    fn keep(&mut self, kind: char) {
        let removed = if kind == 'c' { 'e' } else { 'c' };
        let lines = self.definitions.lines().filter(|line| !line.starts_with(removed));
        self.definitions = lines.map(|line| format!("{line}\n")).collect();
    }

    /// Returns the text in which the hypotheses imply the goal. The `hints` tell Gappa how to proceed.
    fn proves(&self, hypotheses: &[String], goal: &str, hints: &str) -> String {
        format!("{}{{ {}\n  -> {goal} }}\n{hints}", self.definitions, hypotheses.join("\n  /\\ "))
    }
}

/// Returns the change of a text to single precision.
fn in_single_precision() -> [String; 2] {
    ["ieee_64", "ieee_32"].map(ToOwned::to_owned)
}

/// Returns that a number lies between two others.
fn within(name: &str, [low, high]: [f64; 2]) -> String {
    format!("{name} in [{},{}]", dyadic(low), dyadic(high))
}

/// Returns the expressions of a computed value, which is rounded, and of the exact one.
fn rounded([computed, exact]: [String; 2]) -> [String; 2] {
    [format!("rnd({computed})"), exact]
}

/// Returns a number as Gappa writes it: `mbe` is `m` times two to the power of `e`.
fn dyadic(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let bits = value.abs().to_bits();
    let (exponent, mantissa) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
    // Numbers below the normal ones have no leading bit.
    let (mantissa, exponent) = if exponent == 0 { (mantissa, -1074) } else { (mantissa | 1 << 52, exponent - 1075) };
    let shift = mantissa.trailing_zeros();
    let sign = if value < 0.0 { "-" } else { "" };
    format!("{sign}{}b{}", mantissa >> shift, exponent + i64::from(shift))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proof::bounded::begin;
    use crate::proof::bounds::Arithmetic;
    use cpu::internals::math::real::Real;

    #[test]
    fn numbers_are_written_exactly() {
        assert_eq!([0.0, 1.0, -0.75, 1e-3].map(dyadic), ["0", "1b0", "-3b-2", "1152921504606847b-60"]);
        assert_eq!(dyadic(f64::from_bits(3)), "3b-1074");
    }

    #[test]
    fn a_formula_is_exported_with_its_rounding_and_without() {
        begin(Arithmetic::F64, f64::NAN);
        let [x, y] = [0, 1].map(|component| Bounded::input((7, component), 0.0));
        let mut script = Script::new();
        let [computed, exact] = script.export((x * y + Bounded::of(0.5)).sqrt());
        let text = script.proves(&["x7_0 in [1,2]".to_owned()], &format!("{computed} - {exact} in [0,0]"), "");
        assert_eq!(
            text,
            "@rnd = float<ieee_64, ne>;\n\
             e0 = x7_0;\nc0 = x7_0;\ne1 = x7_1;\nc1 = x7_1;\ne2 = e0 * e1;\nc2 = rnd(c0 * c1);\n\
             e3 = 1b-1;\nc3 = 1b-1;\ne4 = e2 + e3;\nc4 = rnd(c2 + c3);\ne5 = sqrt(e4);\nc5 = rnd(sqrt(c4));\n\
             { x7_0 in [1,2]\n  -> c5 - e5 in [0,0] }\n"
        );
    }
}
