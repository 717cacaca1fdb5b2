//! Lowers the operators of f64.

use naga::{BinaryOperator, Expression, Handle, Scalar, UnaryOperator};

use super::function::FunctionLowering;
use super::refusal::{Lowered, Refusal};

impl FunctionLowering<'_, '_> {
    /// Lowers an operator with one operand. Returns `None` if the operand is no f64.
    pub fn unary(
        &mut self,
        operator: UnaryOperator,
        operand: Handle<Expression>,
    ) -> Lowered<Option<Handle<Expression>>> {
        match (self.shape(operand), operator) {
            (None, _) => Ok(None),
            (Some(_), UnaryOperator::Negate) => self.each("f64_negate", &[operand]).map(Some),
            (Some(_), other) => Err(Refusal::new(self.span, format!("{other:?} of f64"))),
        }
    }

    /// Lowers an operator with two operands. Returns `None` if neither is f64.
    pub fn binary(
        &mut self,
        operator: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Lowered<Option<Handle<Expression>>> {
        if self.shape(left).is_none() && self.shape(right).is_none() {
            return Ok(None);
        }
        use BinaryOperator::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        let name = match operator {
            BinaryOperator::Add => "f64_add",
            BinaryOperator::Subtract => "f64_subtract",
            BinaryOperator::Multiply => "f64_multiply",
            BinaryOperator::Divide => "f64_divide",
            BinaryOperator::Modulo => "f64_remainder",
            Equal => "f64_equal",
            NotEqual => "f64_not_equal",
            Less => "f64_less",
            LessEqual => "f64_less_equal",
            Greater => "f64_greater",
            GreaterEqual => "f64_greater_equal",
            other => return Err(Refusal::new(self.span, format!("{other:?} of f64"))),
        };
        let results = self.each_component(name, &[left, right])?;
        let is_comparison = matches!(operator, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual);
        Ok(Some(self.vector_of(if is_comparison { Scalar::BOOL } else { Scalar::F64 }, &results)))
    }

    /// Calls the function `name` of the arithmetic for each component of the operands, and returns the vector of the
    /// results.
    pub fn each(&mut self, name: &str, operands: &[Handle<Expression>]) -> Lowered<Handle<Expression>> {
        let results = self.each_component(name, operands)?;
        Ok(self.vector(&results))
    }

    /// Calls the function `name` of the arithmetic for each component of the operands. An operand that is a number
    /// counts for every component.
    pub fn each_component(&mut self, name: &str, operands: &[Handle<Expression>]) -> Lowered<Vec<Handle<Expression>>> {
        let operands = operands.iter().map(|operand| self.components(*operand)).collect::<Lowered<Vec<_>>>()?;
        let count = operands.iter().map(Vec::len).max().unwrap_or(0);
        let call = |index: usize| {
            let own: Vec<_> = operands.iter().map(|parts| parts[index.min(parts.len() - 1)]).collect();
            self.call(name, &own)
        };
        (0..count).map(call).collect()
    }
}
