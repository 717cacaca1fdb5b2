//! Scripts in which an operation is rounded by a relative error, at any magnitude. So a proof may measure the numbers
//! of a formula in any unit, such as the length of a vector, and not only in powers of two.
//!
//! The letters before the number of an operation are: `c` for the computed value, `e` for the exact one, `y` for a
//! given value, `k` for a factor in a known range, and of a dot product `a` for the sum of the products with their
//! errors, and `b` for these errors.

use super::super::bounded::{Bounded, Operation};
use super::super::row::U;
use super::super::signed::two_sum;
use super::hypotheses::relative;
use super::{Proof, Rounding, Script, dyadic, one_bit_less, within};

/// A dot product of two vectors of three components. The code adds the three products one after the other, to a first
/// number if there is one.
pub(super) struct Dot {
    /// The number to which the products are added.
    pub(super) start: Option<Bounded>,
    /// The sum after each product.
    pub(super) sums: [Bounded; 3],
    /// The two vectors.
    pub(super) vectors: [[Bounded; 3]; 2],
}

impl Dot {
    /// Takes a dot product apart whose products are rounded before they are added.
    pub(super) fn of_products(last: Bounded) -> Self {
        let Operation::Sum(second, third) = last.operation() else { panic!("it is no sum") };
        let Operation::Sum(first, middle) = second.operation() else { panic!("it is no sum of three") };
        let factors = [first, middle, third].map(|product| {
            let Operation::Product(x, y) = product.operation() else { panic!("it adds products") };
            [x, y]
        });
        Self { start: None, sums: [first, second, last], vectors: [0, 1].map(|index| factors.map(|both| both[index])) }
    }

    /// Takes a dot product by fused operations apart.
    pub(super) fn of(last: Bounded) -> Self {
        let Operation::Fused(x2, y2, second) = last.operation() else { panic!("it is no fused sum") };
        let Operation::Fused(x1, y1, first) = second.operation() else { panic!("it is no fused sum of two") };
        let (x0, y0, start) = match first.operation() {
            Operation::Fused(x, y, start) => (x, y, Some(start)),
            Operation::Product(x, y) => (x, y, None),
            other => panic!("{other:?} is no product"),
        };
        Self { start, sums: [first, second, last], vectors: [[x0, x1, x2], [y0, y1, y2]] }
    }
}

/// Returns the operation whose rounding error this number is. With the sign `-` the number is the exact value minus the
/// rounded one, and without a sign the rounded value minus the exact one.
pub(super) fn error_of(number: Bounded) -> Option<(Bounded, &'static str)> {
    match number.operation() {
        // Knuth's algorithm computes the exact sum minus the rounded one.
        Operation::Sum(x, y) => two_sum(x, y).map(|[_, _, rounded_sum]| (rounded_sum, "-")),
        Operation::Fused(a, b, c) => match c.operation() {
            Operation::Negative(product) if product.operation() == Operation::Product(a, b) => Some((product, "-")),
            Operation::Product(x, y) if a.operation() == Operation::Negative(x) && b == y => Some((c, "")),
            _ => None,
        },
        _ => None,
    }
}

/// Returns the proof of the relative error of a product, for factors with these relative errors, all in units of `u`.
pub(super) fn product(row: &'static str, bits: u32, factors: [f64; 2], error: f64) -> Proof {
    let [x, y, product] = ["x", "y", "p"].map(|name| [format!("c{name}"), format!("e{name}")]);
    let [given_x, given_y] = [relative(&x, factors[0]), relative(&y, factors[1])];
    let text = format!(
        "ep = ex * ey;\ncp = mul_rel<{bits}>(cx, cy);\n{{ {given_x}\n  /\\ {given_y}\n  -> {} }}\n",
        relative(&product, error)
    );
    Proof { row, what: "the relative error of a product of given numbers", text, wrong: one_bit_less(bits) }
}

impl Script {
    /// Begins a script whose operations have relative errors of at most 2 to the power of `-bits`.
    pub(super) fn relative(bits: u32) -> Self {
        Self::with_rounding(Rounding::Relative(bits), "")
    }

    pub(super) fn is_relative(&self) -> bool {
        matches!(self.rounding, Rounding::Relative(_))
    }

    /// If the number is the rounding error of another number, returns its value. That of a sum is exact by Knuth's
    /// theorem, that of a product because the code uses a fused operation.
    pub(super) fn exact_error(&mut self, number: Bounded) -> Option<String> {
        let (of, sign) = error_of(number).filter(|_| self.is_relative())?;
        let [computed, _] = self.export(of);
        self.compensated.insert(of);
        Some(format!("{sign}({computed} - ({}))", self.unrounded[&of]))
    }

    /// Returns the roundings of a number's operations, which add up to its error. Those that the code computes and
    /// adds back are left out, and those of numbers that the proof defines.
    pub(super) fn roundings(&mut self, number: Bounded) -> Vec<String> {
        let [computed, _] = self.export(number);
        let times = |factor: &str, roundings: Vec<String>| {
            roundings.into_iter().map(|rounding| format!("{factor}{rounding}")).collect::<Vec<_>>()
        };
        if self.compensated.contains(&number) {
            return Vec::new();
        }
        let Some(unrounded) = self.unrounded.get(&number) else {
            return match number.operation() {
                Operation::Sum(a, b) if a == b => times("2 * ", self.roundings(a)),
                _ => Vec::new(),
            };
        };
        let own = vec![format!("({computed} - ({unrounded}))")];
        let of_operands = match number.operation() {
            Operation::Sum(a, b) => [self.roundings(a), self.roundings(b)].concat(),
            Operation::Difference(a, b) => [self.roundings(a), times("-", self.roundings(b))].concat(),
            Operation::Product(a, b) => {
                assert_eq!(self.roundings(a), [""; 0], "the error of the first factor is added back");
                let [factor, _] = self.export(a);
                times(&format!("{factor} * "), self.roundings(b))
            }
            Operation::Fused(.., c) => self.roundings(c),
            other => unreachable!("no number whose errors are added back is computed by {other:?}"),
        };
        [own, of_operands].concat()
    }

    /// Returns the expression of a multiple of `size`, by a factor in this range.
    pub(super) fn multiple(&mut self, of: Bounded, size: &str, range: [f64; 2]) -> String {
        let factor = format!("k{}", of.place());
        self.hypotheses.push(within(&factor, range));
        format!("{factor} * ({size})")
    }

    /// Defines a number that is given, by its exact value and a relative error of at most `error u`.
    pub(super) fn given(&mut self, number: Bounded, exact: &str, error: f64) {
        let computed = format!("y{}", number.place());
        let names = self.define(number, [&computed, exact]);
        self.hypotheses.push(relative(&names, error));
    }

    /// Assumes, without proof, that the exact value of a number is a multiple of `size` by a factor in this range.
    pub(super) fn is_multiple(&mut self, number: Bounded, size: &str, range: [f64; 2]) {
        let ([_, exact], multiple) = (self.export(number), self.multiple(number, size, range));
        self.hypotheses.push(format!("{exact} = {multiple}"));
    }

    /// Defines the sums of one, two and three products of a dot product, for vectors whose lengths have the product
    /// `lengths`. The products have relative errors of at most `error u`. Neither the sums nor, relative to the error,
    /// the sums of the errors exceed `lengths`. This is the inequality of Cauchy and Schwarz for the first components
    /// of both vectors; `lengths` may also be a bound of the sum of the products' magnitudes. The sums of a vector's
    /// square are not negative.
    pub(super) fn given_dot(&mut self, dot: &Dot, lengths: &str, error: f64) {
        let Rounding::Relative(bits) = self.rounding else { panic!("the rounding is relative") };
        let least = if dot.vectors[0] == dot.vectors[1] { 0.0 } else { -1.0 };
        let start = dot.start.map(|start| self.export(start));
        let mut last = start.clone();
        for sum in dot.sums {
            let (place, multiple) = (sum.place(), self.multiple(sum, lengths, [least, 1.0]));
            // The exact sum with the errors of the products, but without those of sums.
            let (of_products, errors) = (format!("a{place}"), format!("b{place} * ({lengths})"));
            self.hypotheses.push(format!("|b{place}| <= {}", dyadic(error * U)));
            let exact = start.iter().map(|[_, exact]| exact.clone()).chain([multiple]).collect::<Vec<_>>().join(" + ");
            self.definitions += &format!("{of_products} = {exact} + {errors};\n");
            let mut computed = of_products.clone();
            if let Some([sum, exact]) = last {
                computed = format!("add_rel<{bits}>({sum}, {of_products} - {exact})");
                let (added, error) = (format!("{sum} + ({of_products} - {exact})"), format!("({sum} - {exact})"));
                self.hints += &format!(
                    "{added} -> {of_products} + {error};\n\
                     c{place} - {of_products} -> (c{place} - ({added})) + {error};\n"
                );
            }
            let [computed, exact] = self.define(sum, [&computed, &exact]);
            self.hints += &format!("{computed} - {exact} -> ({computed} - {of_products}) + {errors};\n");
            last = Some([computed, of_products]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proof::bounded::begin;
    use crate::proof::bounds::Arithmetic;
    use cpu::internals::math::error_free::two_product;

    #[test]
    fn a_rounding_error_that_the_code_adds_back_is_exact() {
        begin(Arithmetic::F64, f64::NAN);
        let [x, y, z] = [0, 1, 2].map(|component| Bounded::input((7, component), 0.0));
        let (product, error) = two_product(x, y);
        let sum = error + (z + z);
        let mut script = Script::relative(53);
        assert_eq!(script.roundings(sum), ["(c7 - (c5 + c6))"]);
        assert_eq!(script.roundings(product), [""; 0]);
        for line in ["c3 = mul_rel<53>(c0, c1);\n", "e5 = 0;\nc5 = -(c3 - (c0 * c1));\n", "c6 = 2 * c2;\n"] {
            assert!(script.definitions.contains(line), "{}", script.definitions);
        }
    }
}
