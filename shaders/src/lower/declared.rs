//! Lowers expressions that no statement evaluates: literals, constants, arguments, and the first values of variables.

use naga::{Expression, Handle, Literal};

use super::copy::copy;
use super::function::{FunctionLowering, Value};
use super::refusal::{Lowered, Refusal};

impl FunctionLowering<'_, '_> {
    /// Lowers an expression that is not evaluated at a place: a literal, a constant, an argument or a variable.
    pub fn declared(&mut self, handle: Handle<Expression>, source: &Expression) -> Lowered<Handle<Expression>> {
        match *source {
            Expression::Literal(Literal::F64(number)) => Ok(self.number(number)),
            Expression::Override(constant) => {
                Ok(self.settled(Expression::Override(self.lowering.overrides[&constant])))
            }
            _ => {
                let lowered = copy(self, handle)?;
                Ok(self.settled(lowered))
            }
        }
    }

    /// Lowers a constant expression that no statement evaluates, such as the first value of a variable.
    pub fn constant(&mut self, handle: Handle<Expression>) -> Lowered<Handle<Expression>> {
        let source = &self.source.expressions[handle];
        // It is lowered as if it were evaluated here, but without the statement that evaluates it.
        self.flush();
        let block = std::mem::take(&mut self.block);
        self.at(self.source.expressions.get_span(handle));
        let lowered = match source {
            source if source.needs_pre_emit() => self.declared(handle, source).map(Value::Plain),
            Expression::Compose { .. } | Expression::Splat { .. } => self.lower_expression(handle),
            _ => Err(Refusal::new(self.span, "a first value that depends on an override")),
        };
        self.emitting = None;
        self.block = block;
        let lowered = lowered?;
        self.values[handle.index()] = Some(lowered);
        self.plain(handle)
    }
}
