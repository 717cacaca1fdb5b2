//! Copies expressions without f64, and those for which only the types and the operands change.

use naga::{Expression, Handle};

use super::function::FunctionLowering;
use super::refusal::{Lowered, Refusal};

/// Returns the expression number `handle` of the source with lowered operands and types.
pub fn copy(this: &mut FunctionLowering<'_, '_>, handle: Handle<Expression>) -> Lowered<Expression> {
    let mut copied = this.source.expressions[handle].clone();
    let (mut operands, mut optional) = (Vec::new(), Vec::new());
    match &mut copied {
        Expression::Literal(_) | Expression::FunctionArgument(_) => {}
        Expression::Constant(constant) => *constant = this.lowering.constants[constant],
        Expression::GlobalVariable(variable) => *variable = this.lowering.globals[variable.index()],
        Expression::LocalVariable(variable) => *variable = this.locals[variable.index()],
        Expression::CallResult(function) => *function = this.lowering.functions[function.index()],
        Expression::ZeroValue(ty) => *ty = this.lowering.types.of(*ty),
        Expression::Relational { fun, argument } if this.shape(*argument).is_some() => {
            return Err(Refusal::new(this.span, format!("`{fun:?}` of f64")));
        }
        Expression::AccessIndex { base: operand, .. }
        | Expression::Splat { value: operand, .. }
        | Expression::Swizzle { vector: operand, .. }
        | Expression::Load { pointer: operand }
        | Expression::Unary { expr: operand, .. }
        | Expression::Relational { argument: operand, .. }
        | Expression::As { expr: operand, .. }
        | Expression::ArrayLength(operand) => operands.push(operand),
        Expression::Access { base: left, index: right } | Expression::Binary { left, right, .. } => {
            operands.extend([left, right]);
        }
        Expression::Select { condition, accept, reject } => operands.extend([condition, accept, reject]),
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            operands.push(arg);
            optional.extend([arg1, arg2, arg3]);
        }
        _ => return Err(Refusal::new(this.span, "this expression")),
    }
    for operand in operands {
        *operand = this.plain(*operand)?;
    }
    for operand in optional {
        *operand = this.optional(*operand)?;
    }
    Ok(copied)
}
