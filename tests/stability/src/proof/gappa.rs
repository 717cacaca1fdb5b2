//! Exports proofs of margins as text for Gappa, an independent prover of bounds of rounding errors.
//!
//! The formulas of `cpu` run over [`Bounded`], which keeps how each number is computed. `Script` writes these
//! operations in Gappa's language, each one with its rounding and without. Two scripts take bounds of our own prover:
//! `cap` and `side_lambda`. Hypotheses are ranges and relative errors of given numbers, the inequality of Cauchy and
//! Schwarz, that errors of `two_sum` and `two_product` are exact, and results of earlier scripts.

mod background;
mod camera;
mod cap;
mod compensated;
mod compensated_underflow;
mod filter;
mod hypotheses;
mod largest;
mod relative;
mod scripts;
mod sphere;
mod underflow;

use std::collections::{HashMap, HashSet};
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
    /// Two strings. The test replaces the first by the second, and Gappa must then refuse the text.
    pub wrong: [String; 2],
}

/// How a script writes that an operation is rounded.
#[derive(Clone, Copy, Debug)]
enum Rounding {
    /// Rounding to f64, with underflow. It depends on the unit, unless units differ by a power of two.
    Ieee,
    /// By a relative error of at most 2 to the power of minus this number of bits, at any magnitude. Underflow is left
    /// out, and a formula may be measured in any unit.
    Relative(u32),
}

/// The bits of numbers in double and in single precision.
const DOUBLE: u32 = 53;
const SINGLE: u32 = 24;

/// A text in Gappa's language that defines numbers, with their rounding and without.
#[derive(Debug)]
struct Script {
    rounding: Rounding,
    definitions: String,
    names: HashMap<Bounded, [String; 2]>,
    /// The computed values of operations before they are rounded.
    unrounded: HashMap<Bounded, String>,
    /// The operations whose errors are computed and exported too.
    compensated: HashSet<Bounded>,
    /// What holds beside the hypotheses that [`Script::proves`] gets.
    hypotheses: Vec<String>,
    /// What Gappa is told beside the hints that [`Script::proves`] gets.
    hints: String,
}

impl Script {
    fn new() -> Self {
        Self::with_rounding(Rounding::Ieee, "@rnd = float<ieee_64, ne>;\n")
    }

    fn with_rounding(rounding: Rounding, definitions: &str) -> Self {
        let (names, unrounded, compensated) = (HashMap::new(), HashMap::new(), HashSet::new());
        let (definitions, hypotheses, hints) = (definitions.to_owned(), Vec::new(), String::new());
        Self { rounding, definitions, names, unrounded, compensated, hypotheses, hints }
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
        if let Some(error) = self.exact_error(number) {
            return self.define(number, [&error, "0"]);
        }
        let [computed, exact] = match number.operation() {
            Operation::Input((family, component)) => [(); 2].map(|()| format!("x{family}_{component}")),
            Operation::Constant(bits) => [(); 2].map(|()| dyadic(f64::from_bits(bits))),
            Operation::Negative(a) => self.export(a).map(|a| format!("-{a}")),
            Operation::Magnitude(a) => self.export(a).map(|a| format!("|{a}|")),
            Operation::Sum(a, b) if a == b && self.is_relative() => self.export(a).map(|a| format!("2 * {a}")),
            Operation::Sum(a, b) => self.rounded(number, "add", &[a, b]),
            Operation::Difference(a, b) => self.rounded(number, "sub", &[a, b]),
            Operation::Product(a, b) => self.rounded(number, "mul", &[a, b]),
            Operation::Quotient(a, b) => self.rounded(number, "div", &[a, b]),
            Operation::Fused(a, b, c) => self.rounded(number, "fma", &[a, b, c]),
            Operation::Root(a) => self.rounded(number, "sqrt", &[a]),
            Operation::Flipped(..) => unreachable!("no exported formula flips a sign"),
        };
        self.define(number, [&computed, &exact])
    }

    /// Returns the expressions of the computed value of a number, which is rounded, and of its exact one.
    fn rounded(&mut self, number: Bounded, operator: &str, operands: &[Bounded]) -> [String; 2] {
        let operands: Vec<_> = operands.iter().map(|&operand| self.export(operand)).collect();
        let [of_computed, of_exact] =
            [0, 1].map(|kind| operands.iter().map(|names| names[kind].as_str()).collect::<Vec<_>>());
        let mut computed = expression(operator, &of_computed);
        let rounded = match (self.rounding, &of_computed[..]) {
            (Rounding::Ieee, _) => format!("rnd({computed})"),
            // Single precision has no fused operation on some machines. Where it has one, the product has no error.
            (Rounding::Relative(SINGLE), [a, b, c]) => {
                let product = format!("mul_rel<{SINGLE}>({a}, {b})");
                computed = format!("{product} + {c}");
                format!("add_rel<{SINGLE}>({product}, {c})")
            }
            (Rounding::Relative(bits), operands) => format!("{operator}_rel<{bits}>({})", operands.join(", ")),
        };
        if self.is_relative() {
            let _ = writeln!(self.hints, "{computed} ~ e{};", number.place());
        }
        let exact = expression(operator, &of_exact);
        self.unrounded.insert(number, computed);
        [rounded, exact]
    }

    /// Removes the definitions of computed values (`c`) or of exact ones (`e`), if a proof needs only the others. Gappa
    /// then takes a tenth of the time.
    fn keep_only(&mut self, kind: char) {
        let removed = if kind == 'c' { 'e' } else { 'c' };
        let lines = self.definitions.lines().filter(|line| !line.starts_with(removed));
        self.definitions = lines.map(|line| format!("{line}\n")).collect();
    }

    /// Returns the text in which the hypotheses imply the goal. The `hints` tell Gappa how to proceed.
    fn proves(&self, hypotheses: &[String], goal: &str, hints: &str) -> String {
        let hypotheses = [&self.hypotheses, hypotheses].concat().join("\n  /\\ ");
        format!("{}{{ {hypotheses}\n  -> {goal} }}\n{}{hints}", self.definitions, self.hints)
    }
}

/// Returns the change of a text to single precision.
fn in_single_precision() -> [String; 2] {
    ["ieee_64", "ieee_32"].map(ToOwned::to_owned)
}

/// Returns the change of a text to numbers with one bit less.
fn one_bit_less(bits: u32) -> [String; 2] {
    [bits, bits - 1].map(|bits| format!("rel<{bits}>"))
}

/// Returns that a number lies between two others.
fn within(name: &str, [low, high]: [f64; 2]) -> String {
    format!("{name} in [{},{}]", dyadic(low), dyadic(high))
}

/// Returns the expression of an operation.
fn expression(operator: &str, operands: &[&str]) -> String {
    match (operator, operands) {
        ("add", [a, b]) => format!("{a} + {b}"),
        ("sub", [a, b]) => format!("{a} - {b}"),
        ("mul", [a, b]) => format!("{a} * {b}"),
        ("div", [a, b]) => format!("{a} / {b}"),
        ("fma", [a, b, c]) => format!("{a} * {b} + {c}"),
        ("sqrt", [a]) => format!("sqrt({a})"),
        _ => unreachable!("no operation is named {operator}"),
    }
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
