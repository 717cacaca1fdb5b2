//! Scripts that bound what underflow adds to numbers.
//!
//! For a computed number, `e` is what it would be without underflow, with the same relative rounding errors, and `t` is
//! what underflow adds to `e`. Underflow of a product adds an error of at most 2^-1075, and sums add none. Numbers are
//! measured in units that are products of `P`, `V` and `Z`. So all but the direction are at most about 1, and the error
//! of underflow is divided by the unit.
//!
//! The letters before the number of an operation are: `e` and `t`, `d` for its relative rounding error, `n` for its own
//! underflow, `g` for what underflow adds to a root, and `m` for the sign of a magnitude. `iP` is `1 / P`.

use std::collections::HashMap;
use std::fmt::Write;

use super::super::bounded::{Bounded, Operation};
use super::super::row::U;
use super::relative::error_of;
use super::{dyadic, expression, within};

/// The powers of `P`, `V` and `Z` in a unit.
pub(super) type Unit = [i32; 3];

/// The largest error of a product by underflow: half of the smallest positive f64.
pub(super) const HALF_OF_LEAST: &str = "1b-1075";

/// The expressions of a number without underflow, and of what underflow adds to it.
#[derive(Clone, Debug)]
struct Names {
    value: String,
    /// It is `None` if underflow adds nothing.
    added: Option<String>,
    unit: Unit,
}

/// A text in Gappa's language that defines numbers without underflow, and what it adds.
#[derive(Debug, Default)]
pub(super) struct UnderflowScript {
    definitions: String,
    names: HashMap<Bounded, Names>,
    hypotheses: Vec<String>,
    goals: Vec<String>,
}

impl UnderflowScript {
    /// Begins a script in which the units or inverses of units with these names are at most these numbers.
    pub(super) fn new(units: [(&str, f64); 4]) -> Self {
        let hypotheses = units.map(|(name, most)| within(name, [0.0, most])).to_vec();
        Self { hypotheses, ..Self::default() }
    }

    /// States that numbers are at most `most` in this unit, without underflow, and that underflow adds at most `added`
    /// to each. An infinite `most` states nothing.
    pub(super) fn given<const N: usize>(&mut self, numbers: [Bounded; N], unit: Unit, most: f64, added: f64) {
        for number in numbers {
            let value = format!("e{}", number.place());
            if most.is_finite() {
                self.hypotheses.push(within(&value, [-most, most]));
            }
            let added = (added > 0.0).then(|| self.at_most('t', number, &dyadic(added)));
            self.names.insert(number, Names { value, added, unit });
        }
    }

    /// Adds the goal that underflow adds at most `most` to a number.
    pub(super) fn adds_at_most(&mut self, number: Bounded, most: f64) {
        let Names { added, .. } = self.export(number);
        self.goals.push(format!("|{}| <= {}", added.expect("the formula has products"), dyadic(most)));
    }

    /// Adds the goal that underflow adds at most `most` to the number of which a root is taken, and states what follows
    /// for the root: the difference of two roots is at most the root of the difference. The number must consist of
    /// squares, so that it is not negative.
    pub(super) fn root_of(&mut self, root: Bounded, most: f64) {
        let Operation::Root(of) = root.operation() else { panic!("it is no root") };
        assert_eq!(most.sqrt() * most.sqrt(), most, "the root is not rounded");
        self.adds_at_most(of, most);
        let Names { value, .. } = self.export(of);
        self.hypotheses.push(format!("{value} >= 0"));
        _ = self.at_most('g', root, &dyadic(most.sqrt()));
    }

    /// Returns the text of the goals.
    pub(super) fn text(&self) -> String {
        let [hypotheses, goals] = [&self.hypotheses, &self.goals].map(|all| all.join("\n  /\\ "));
        format!("{}{{ {hypotheses}\n  -> {goals} }}\n", self.definitions)
    }

    fn export(&mut self, number: Bounded) -> Names {
        if let Some(names) = self.names.get(&number) {
            return names.clone();
        }
        let names = match (error_of(number), number.operation()) {
            (Some((of, sign)), _) => self.error(number, of, sign),
            (_, Operation::Constant(bits)) => Names { value: dyadic(f64::from_bits(bits)), added: None, unit: [0; 3] },
            (_, Operation::Negative(a)) => {
                let Names { value, added, unit } = self.export(a);
                self.define(number, format!("-{value}"), added.map(|added| format!("-{added}")), unit)
            }
            (_, Operation::Magnitude(a)) => {
                let Names { value, added, unit } = self.export(a);
                let factor = self.at_most('m', number, "1");
                self.define(number, format!("|{value}|"), added.map(|added| format!("{factor} * {added}")), unit)
            }
            (_, Operation::Root(a)) => {
                let Names { value, unit, .. } = self.export(a);
                let [rounding, difference] = [self.rounding(number), format!("g{}", number.place())];
                let added = format!("{difference} * {rounding}");
                let unit = unit.map(|power| power / 2);
                self.define(number, format!("sqrt({value}) * {rounding}"), Some(added), unit)
            }
            _ => {
                let (value, added, unit) = self.operation(number);
                let rounding = self.rounding(number);
                let added = added.map(|added| format!("({added}) * {rounding}"));
                let added = sum([added, self.own_underflow(number, number, unit)]);
                self.define(number, format!("({value}) * {rounding}"), added, unit)
            }
        };
        self.names.insert(number, names.clone());
        names
    }

    fn define(&mut self, number: Bounded, value: String, added: Option<String>, unit: Unit) -> Names {
        let place = number.place();
        // Writing to a `String` never fails, so errors are ignored.
        let _ = writeln!(self.definitions, "e{place} = {value};");
        let added = added.map(|added| {
            let _ = writeln!(self.definitions, "t{place} = {added};");
            format!("t{place}")
        });
        Names { value: format!("e{place}"), added, unit }
    }

    /// Returns the result of an operation before it is rounded, what its operands add to it, and the unit.
    fn operation(&mut self, number: Bounded) -> (String, Option<String>, Unit) {
        let (operator, operands) = match number.operation() {
            Operation::Sum(a, b) => ("add", vec![a, b]),
            Operation::Difference(a, b) => ("sub", vec![a, b]),
            Operation::Product(a, b) => ("mul", vec![a, b]),
            Operation::Fused(a, b, c) => ("fma", vec![a, b, c]),
            other => unreachable!("{other:?} is not exported here"),
        };
        let names: Vec<_> = operands.into_iter().map(|operand| self.export(operand)).collect();
        let values: Vec<_> = names.iter().map(|names| names.value.as_str()).collect();
        let added = |index: usize, factor: &str| names[index].added.as_ref().map(|added| format!("{factor}{added}"));
        let product = || {
            let both = added(0, "").zip(added(1, "")).map(|(a, b)| format!("{a} * {b}"));
            sum([added(0, &format!("{} * ", values[1])), added(1, &format!("{} * ", values[0])), both])
        };
        let (terms, parts) = match operator {
            "add" => (&names[..], sum([added(0, ""), added(1, "")])),
            "sub" => (&names[..], sum([added(0, ""), added(1, "-1 * ")])),
            "mul" => (&names[2..], product()),
            _ => (&names[2..], sum([product(), added(2, "")])),
        };
        let of_product = || [0, 1, 2].map(|index| names[0].unit[index] + names[1].unit[index]);
        let unit = if terms.len() == 2 { terms[0].unit } else { of_product() };
        assert!(terms.iter().all(|term| term.unit == unit), "a formula adds numbers of different units");
        (expression(operator, &values), parts, unit)
    }

    /// Defines the rounding error of the operation `of`, with the sign of [`error_of`]. The code computes it by a fused
    /// operation if it is that of a product, and then the error of the product's underflow is a part of it.
    fn error(&mut self, number: Bounded, of: Bounded, sign: &str) -> Names {
        _ = self.export(of);
        let (value, added, unit) = self.operation(of);
        _ = self.rounding(of);
        let rounding = format!("d{}", of.place());
        let added = added.map(|added| format!("({added}) * {rounding}"));
        let added = sum([added, self.own_underflow(of, of, unit)]).map(|added| format!("{sign}({added})"));
        let added = sum([added, self.own_underflow(number, of, unit)]);
        self.define(number, format!("{sign}(({value}) * {rounding})"), added, unit)
    }

    /// Returns the factor by which rounding changes a number.
    fn rounding(&mut self, number: Bounded) -> String {
        format!("(1 + {})", self.at_most('d', number, &dyadic(U)))
    }

    /// States that a variable for a number has at most this magnitude. Returns its name.
    fn at_most(&mut self, kind: char, number: Bounded, most: &str) -> String {
        let name = format!("{kind}{}", number.place());
        let hypothesis = format!("|{name}| <= {most}");
        if !self.hypotheses.contains(&hypothesis) {
            self.hypotheses.push(hypothesis);
        }
        name
    }

    /// Returns what underflow of the number adds in this unit, if the operation `of` is a product.
    fn own_underflow(&mut self, number: Bounded, of: Bounded, unit: Unit) -> Option<String> {
        if !matches!(of.operation(), Operation::Product(..) | Operation::Fused(..)) {
            return None;
        }
        let mut factors = vec![self.at_most('n', number, HALF_OF_LEAST)];
        for (name, power) in ["P", "V", "Z"].into_iter().zip(unit) {
            let factor = if power > 0 { format!("i{name}") } else { name.to_owned() };
            factors.extend(vec![factor; power.unsigned_abs() as usize]);
        }
        Some(factors.join(" * "))
    }
}

/// Returns the sum of the expressions that there are.
fn sum<const N: usize>(parts: [Option<String>; N]) -> Option<String> {
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| parts.join(" + "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proof::bounded::begin;
    use crate::proof::bounds::Arithmetic;

    #[test]
    fn underflow_of_a_product_is_divided_by_the_unit() {
        begin(Arithmetic::F64, f64::NAN);
        let [x, y] = [0, 1].map(|component| Bounded::input((7, component), 0.0));
        let mut script = UnderflowScript::new([("iP", 4.0), ("iV", 4.0), ("iZ", 4.0), ("V", 4.0)]);
        script.given([x], [1, 0, 0], 1.0, 0.5);
        script.given([y], [0, -2, 0], 2.0, 0.0);
        script.adds_at_most(x * y, 8.0);
        let text = script.text();
        let definitions = "e2 = (e0 * e1) * (1 + d2);\nt2 = (e1 * t0) * (1 + d2) + n2 * iP * V * V;\n{ iP in [0,1b2]";
        assert!(text.starts_with(definitions), "{text}");
        assert!(text.ends_with("|d2| <= 1b-53\n  /\\ |n2| <= 1b-1075\n  -> |t2| <= 1b3 }\n"), "{text}");
    }
}
