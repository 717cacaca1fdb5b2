//! Copies expressions without f64, and those for which only the types and the operands change.

use naga::{Expression, Handle, ImageQuery, SampleLevel};

use super::function::FunctionLowering;
use super::refusal::{Lowered, Refusal};

/// Returns the expression number `handle` of the source with lowered operands and types.
pub fn copy(this: &mut FunctionLowering<'_, '_>, handle: Handle<Expression>) -> Lowered<Expression> {
    let source = this.source;
    Ok(match source.expressions[handle] {
        Expression::Literal(literal) => Expression::Literal(literal),
        Expression::Constant(constant) => Expression::Constant(this.lowering.constants[&constant]),
        Expression::ZeroValue(ty) => Expression::ZeroValue(this.lowering.types.of(ty)),
        Expression::FunctionArgument(index) => Expression::FunctionArgument(index),
        Expression::GlobalVariable(variable) => Expression::GlobalVariable(this.lowering.globals[variable.index()]),
        Expression::LocalVariable(variable) => Expression::LocalVariable(this.locals[variable.index()]),
        Expression::CallResult(function) => Expression::CallResult(this.lowering.functions[function.index()]),
        Expression::AtomicResult { ty, comparison } => {
            Expression::AtomicResult { ty: this.lowering.types.of(ty), comparison }
        }
        Expression::WorkGroupUniformLoadResult { ty } => {
            Expression::WorkGroupUniformLoadResult { ty: this.lowering.types.of(ty) }
        }
        Expression::SubgroupOperationResult { ty } => {
            Expression::SubgroupOperationResult { ty: this.lowering.types.of(ty) }
        }
        Expression::SubgroupBallotResult => Expression::SubgroupBallotResult,
        Expression::Access { base, index } => Expression::Access { base: this.plain(base)?, index: this.plain(index)? },
        Expression::AccessIndex { base, index } => Expression::AccessIndex { base: this.plain(base)?, index },
        Expression::Splat { size, value } => Expression::Splat { size, value: this.plain(value)? },
        Expression::Swizzle { size, vector, pattern } => {
            Expression::Swizzle { size, vector: this.plain(vector)?, pattern }
        }
        Expression::Load { pointer } => Expression::Load { pointer: this.plain(pointer)? },
        Expression::Unary { op, expr } => Expression::Unary { op, expr: this.plain(expr)? },
        Expression::Binary { op, left, right } => {
            Expression::Binary { op, left: this.plain(left)?, right: this.plain(right)? }
        }
        Expression::Select { condition, accept, reject } => Expression::Select {
            condition: this.plain(condition)?,
            accept: this.plain(accept)?,
            reject: this.plain(reject)?,
        },
        Expression::Derivative { axis, ctrl, expr } => Expression::Derivative { axis, ctrl, expr: this.plain(expr)? },
        Expression::Relational { fun, argument } => {
            if this.shape(argument).is_some() {
                return Err(Refusal::new(this.span, format!("`{fun:?}` of f64")));
            }
            Expression::Relational { fun, argument: this.plain(argument)? }
        }
        Expression::Math { fun, arg, arg1, arg2, arg3 } => Expression::Math {
            fun,
            arg: this.plain(arg)?,
            arg1: this.optional(arg1)?,
            arg2: this.optional(arg2)?,
            arg3: this.optional(arg3)?,
        },
        Expression::As { expr, kind, convert } => Expression::As { expr: this.plain(expr)?, kind, convert },
        Expression::ArrayLength(expr) => Expression::ArrayLength(this.plain(expr)?),
        Expression::ImageSample { .. } | Expression::ImageLoad { .. } | Expression::ImageQuery { .. } => {
            copy_image(this, handle)?
        }
        Expression::Compose { .. } | Expression::Override(_) => {
            return Err(Refusal::new(this.span, "this expression"));
        }
        Expression::RayQueryVertexPositions { .. }
        | Expression::RayQueryProceedResult
        | Expression::RayQueryGetIntersection { .. } => return Err(Refusal::new(this.span, "a ray query")),
        Expression::CooperativeLoad { .. } | Expression::CooperativeMultiplyAdd { .. } => {
            return Err(Refusal::new(this.span, "a cooperative matrix"));
        }
    })
}

fn copy_image(this: &mut FunctionLowering<'_, '_>, handle: Handle<Expression>) -> Lowered<Expression> {
    let source = this.source;
    Ok(match source.expressions[handle] {
        Expression::ImageSample {
            image,
            sampler,
            gather,
            coordinate,
            array_index,
            offset,
            level,
            depth_ref,
            clamp_to_edge,
        } => Expression::ImageSample {
            image: this.plain(image)?,
            sampler: this.plain(sampler)?,
            gather,
            coordinate: this.plain(coordinate)?,
            array_index: this.optional(array_index)?,
            offset: this.optional(offset)?,
            level: match level {
                SampleLevel::Auto | SampleLevel::Zero => level,
                SampleLevel::Exact(level) => SampleLevel::Exact(this.plain(level)?),
                SampleLevel::Bias(bias) => SampleLevel::Bias(this.plain(bias)?),
                SampleLevel::Gradient { x, y } => SampleLevel::Gradient { x: this.plain(x)?, y: this.plain(y)? },
            },
            depth_ref: this.optional(depth_ref)?,
            clamp_to_edge,
        },
        Expression::ImageLoad { image, coordinate, array_index, sample, level } => Expression::ImageLoad {
            image: this.plain(image)?,
            coordinate: this.plain(coordinate)?,
            array_index: this.optional(array_index)?,
            sample: this.optional(sample)?,
            level: this.optional(level)?,
        },
        Expression::ImageQuery { image, query } => Expression::ImageQuery {
            image: this.plain(image)?,
            query: match query {
                ImageQuery::Size { level } => ImageQuery::Size { level: this.optional(level)? },
                other => other,
            },
        },
        _ => return Err(Refusal::new(this.span, "this expression")),
    })
}
