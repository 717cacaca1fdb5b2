//! Lowers the statements of a function.

use naga::{Block, Expression, Handle, Span, Statement, SwitchCase, SwitchValue};

use super::function::{FunctionLowering, Value};
use super::refusal::{Lowered, Refusal};

impl FunctionLowering<'_, '_> {
    /// Appends the lowered statements of `source` to the innermost block.
    pub fn lower_block(&mut self, source: &Block) -> Lowered<()> {
        for (statement, span) in source.span_iter() {
            self.at(*span);
            self.lower_statement(statement, *span)?;
        }
        Ok(())
    }

    fn nested(&mut self, source: &Block) -> Lowered<Block> {
        self.inside(|inner| inner.lower_block(source))
    }

    fn lower_statement(&mut self, source: &Statement, span: Span) -> Lowered<()> {
        let lowered = match source {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    self.at(self.source.expressions.get_span(handle));
                    let value = self.lower_expression(handle)?;
                    self.set(handle, value);
                }
                return Ok(());
            }
            Statement::Store { pointer, value } => return self.lower_store(*pointer, *value),
            Statement::Block(block) => Statement::Block(self.nested(block)?),
            Statement::If { condition, accept, reject } => {
                let condition = self.plain(*condition)?;
                Statement::If { condition, accept: self.nested(accept)?, reject: self.nested(reject)? }
            }
            Statement::Switch { selector, cases } => {
                let selector = self.plain(*selector)?;
                let lower = |case: &SwitchCase| {
                    let body = self.nested(&case.body)?;
                    Ok(SwitchCase { value: case.value, body, fall_through: case.fall_through })
                };
                Statement::Switch { selector, cases: cases.iter().map(lower).collect::<Lowered<_>>()? }
            }
            Statement::Loop { body, continuing, break_if } => {
                let body = self.nested(body)?;
                let mut break_if = *break_if;
                let continuing = self.inside(|inner| {
                    inner.lower_block(continuing)?;
                    break_if = break_if.map(|condition| inner.plain(condition)).transpose()?;
                    Ok(())
                })?;
                Statement::Loop { body, continuing, break_if }
            }
            Statement::Return { value } => Statement::Return { value: self.optional(*value)? },
            Statement::Call { function, arguments, result } => {
                let function = self.lowering.functions[function.index()];
                let arguments = arguments.iter().map(|part| self.plain(*part)).collect::<Lowered<_>>()?;
                let result = result.map(|result| self.lowered_result(result)).transpose()?;
                Statement::Call { function, arguments, result }
            }
            Statement::Break
            | Statement::Continue
            | Statement::Kill
            | Statement::ControlBarrier(_)
            | Statement::MemoryBarrier(_) => source.clone(),
            _ => return Err(Refusal::new(span, "this statement")),
        };
        self.at(span);
        self.push(lowered);
        Ok(())
    }

    pub fn optional(&mut self, handle: Option<Handle<Expression>>) -> Lowered<Option<Handle<Expression>>> {
        handle.map(|handle| self.plain(handle)).transpose()
    }

    /// Appends the expression that is the result of a statement.
    fn lowered_result(&mut self, handle: Handle<Expression>) -> Lowered<Handle<Expression>> {
        let lowered = super::copy::copy(self, handle)?;
        let lowered = self.settled(lowered);
        self.set(handle, Value::Plain(lowered));
        Ok(lowered)
    }

    fn lower_store(&mut self, pointer: Handle<Expression>, value: Handle<Expression>) -> Lowered<()> {
        let value = self.plain(value)?;
        match self.value(pointer)? {
            Value::Plain(pointer) => self.push(Statement::Store { pointer, value }),
            Value::Component { vector, index, count } => {
                // A store to each component, in a switch over the index. Beyond the last component, where WGSL allows
                // any component to be written, it is the last one.
                let mut cases = Vec::new();
                for component in 0..count {
                    let body = self.inside(|inner| {
                        let pointer = inner.emit(Expression::AccessIndex { base: vector, index: component });
                        inner.push(Statement::Store { pointer, value });
                        Ok(())
                    })?;
                    let is_last = component + 1 == count;
                    let case = if is_last { SwitchValue::Default } else { SwitchValue::U32(component) };
                    cases.push(SwitchCase { value: case, body, fall_through: false });
                }
                self.push(Statement::Switch { selector: index, cases });
            }
        }
        Ok(())
    }
}
