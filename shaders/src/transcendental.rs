//! Refuses transcendental functions of f64, and its conversions of angles.
//!
//! naga accepts them, but SPIR-V has them for 16 and 32 bits only (`docs/upstream/naga-f64-functions.md`). lavapipe
//! then gives wrong results. NVIDIA's compiler crashes for `log` and `pow`, and the device is lost.

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Expression, Function, MathFunction, Module, Scalar, Span};

use crate::{Composition, Diagnostic};

/// Returns the name in WGSL of a function that f64 does not have, or `None` for another function.
const fn name(function: MathFunction) -> Option<&'static str> {
    Some(match function {
        MathFunction::Sin => "sin",
        MathFunction::Cos => "cos",
        MathFunction::Tan => "tan",
        MathFunction::Asin => "asin",
        MathFunction::Acos => "acos",
        MathFunction::Atan => "atan",
        MathFunction::Atan2 => "atan2",
        MathFunction::Sinh => "sinh",
        MathFunction::Cosh => "cosh",
        MathFunction::Tanh => "tanh",
        MathFunction::Asinh => "asinh",
        MathFunction::Acosh => "acosh",
        MathFunction::Atanh => "atanh",
        MathFunction::Exp => "exp",
        MathFunction::Exp2 => "exp2",
        MathFunction::Log => "log",
        MathFunction::Log2 => "log2",
        MathFunction::Pow => "pow",
        MathFunction::Radians => "radians",
        MathFunction::Degrees => "degrees",
        _ => return None,
    })
}

/// Returns an error for the first transcendental function of f64 in `module`, which naga has read from `composition`.
///
/// # Errors
/// The message, with the place of the call.
pub fn refuse(module: &Module, info: &ModuleInfo, composition: &Composition) -> Result<(), Box<Diagnostic>> {
    let functions = module.functions.iter().map(|(handle, function)| (function, &info[handle]));
    let entries = module.entry_points.iter().enumerate();
    let entries = entries.map(|(index, entry)| (&entry.function, info.get_entry_point(index)));
    let calls = functions.chain(entries).flat_map(|(function, info)| calls(module, function, info));
    let start = |span: &Span| span.to_range().map(|range| range.start);
    let Some((name, span)) = calls.min_by_key(|(_, span)| start(span)) else { return Ok(()) };
    let message = format!(
        "`{name}` of f64 is refused, because drivers calculate it wrongly or crash: compute it on the CPU or in f32"
    );
    Err(Box::new(Diagnostic::of_span(message, span, None, composition)))
}

/// Returns the name and the place of each call of a transcendental function of f64.
fn calls<'a>(
    module: &'a Module,
    function: &'a Function,
    info: &'a FunctionInfo,
) -> impl Iterator<Item = (&'static str, Span)> {
    function.expressions.iter().filter_map(move |(handle, expression)| {
        let Expression::Math { fun, arg, .. } = *expression else { return None };
        let is_f64 = info[arg].ty.inner_with(&module.types).scalar() == Some(Scalar::F64);
        name(fun).filter(|_| is_f64).map(|name| (name, function.expressions.get_span(handle)))
    })
}
