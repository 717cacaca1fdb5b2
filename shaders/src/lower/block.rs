//! Writes expressions and statements into the body of a lowered function.
//!
//! naga evaluates expressions where a statement `Emit` names them. A call is a statement of its own, so it ends the
//! expressions that are being emitted.

use naga::{Expression, Handle, Literal, Span, Statement};

use super::function::FunctionLowering;
use super::refusal::Lowered;

impl FunctionLowering<'_, '_> {
    /// Appends an expression that is evaluated here.
    pub fn emit(&mut self, expression: Expression) -> Handle<Expression> {
        self.emitting.get_or_insert(self.function.expressions.len());
        self.function.expressions.append(expression, self.span)
    }

    /// Appends an expression that is not evaluated at a place: a literal, a variable, or the result of a statement.
    pub fn settled(&mut self, expression: Expression) -> Handle<Expression> {
        self.flush();
        self.function.expressions.append(expression, self.span)
    }

    /// Ends the expressions that are being emitted.
    pub fn flush(&mut self) {
        if let Some(start) = self.emitting.take() {
            let range = self.function.expressions.range_from(start);
            self.block.push(Statement::Emit(range), self.span);
        }
    }

    /// Appends a statement.
    pub fn push(&mut self, statement: Statement) {
        self.flush();
        self.block.push(statement, self.span);
    }

    /// Calls the function `name` of the arithmetic, and returns its result.
    pub fn call(&mut self, name: &str, arguments: &[Handle<Expression>]) -> Lowered<Handle<Expression>> {
        let function = self.lowering.arithmetic(name, self.span)?;
        let result = self.settled(Expression::CallResult(function));
        self.push(Statement::Call { function, arguments: arguments.to_vec(), result: Some(result) });
        Ok(result)
    }

    /// Returns a literal of type u32.
    pub fn word(&mut self, word: u32) -> Handle<Expression> {
        self.settled(Expression::Literal(Literal::U32(word)))
    }

    /// Returns the words of a number.
    pub fn number(&mut self, number: f64) -> Handle<Expression> {
        let constant = self.lowering.literal(number);
        self.settled(Expression::Constant(constant))
    }

    /// Calls `write` with an empty block as the place for statements, and returns that block.
    pub fn inside(&mut self, write: impl FnOnce(&mut Self) -> Lowered<()>) -> Lowered<naga::Block> {
        self.flush();
        let outer = std::mem::take(&mut self.block);
        write(self)?;
        self.flush();
        Ok(std::mem::replace(&mut self.block, outer))
    }

    /// Sets the place in the source of what is written next.
    pub fn at(&mut self, span: Span) {
        self.span = span;
    }
}
