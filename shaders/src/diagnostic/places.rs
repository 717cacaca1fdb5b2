//! Finds places that naga does not have: of types and of nesting that is too deep. naga keeps a place for structures
//! only, so the place of another type is its first use.

use naga::front::wgsl::{ParseError, parse_str};
use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Expression, Function, Handle, Module, Span, Type, TypeInner};

use crate::limits::tokens;

/// Returns the place in the source where the type `ty`, or a type that contains it, is first used. Returns
/// [`Span::UNDEFINED`] if it is not used. A module that is not valid has no `info`. Then only those expressions count
/// that name the type.
pub fn of_type(ty: Handle<Type>, module: &Module, info: Option<&ModuleInfo>) -> Span {
    let uses = Uses::of(ty, module);
    let mut places = Vec::new();
    places.extend(module.types.iter().filter(|(ty, _)| uses.has(*ty)).map(|(ty, _)| module.types.get_span(ty)));
    let constants = module.constants.iter().filter(|(_, constant)| uses.has(constant.ty));
    places.extend(constants.map(|(constant, _)| module.constants.get_span(constant)));
    let overrides = module.overrides.iter().filter(|(_, constant)| uses.has(constant.ty));
    places.extend(overrides.map(|(constant, _)| module.overrides.get_span(constant)));
    let variables = module.global_variables.iter().filter(|(_, variable)| uses.has(variable.ty));
    places.extend(variables.map(|(variable, _)| module.global_variables.get_span(variable)));
    for (handle, function) in module.functions.iter() {
        if function.result.as_ref().is_some_and(|result| uses.has(result.ty)) {
            places.push(module.functions.get_span(handle));
        }
        uses.within(function, info.map(|info| &info[handle]), &mut places);
    }
    for (index, entry) in module.entry_points.iter().enumerate() {
        uses.within(&entry.function, info.map(|info| info.get_entry_point(index)), &mut places);
    }
    let start = |span: &Span| span.to_range().map(|range| range.start);
    places.into_iter().filter(Span::is_defined).min_by_key(start).unwrap_or(Span::UNDEFINED)
}

/// A type, and all types that contain it.
struct Uses<'a> {
    module: &'a Module,
    ty: &'a TypeInner,
    contains: Vec<bool>,
}

impl<'a> Uses<'a> {
    fn of(ty: Handle<Type>, module: &'a Module) -> Self {
        let mut uses = Self { module, ty: &module.types[ty].inner, contains: Vec::new() };
        // A type stands after those that it contains.
        for (handle, other) in module.types.iter() {
            let contains = handle == ty || uses.is_inside(&other.inner);
            uses.contains.push(contains);
        }
        uses
    }

    fn has(&self, ty: Handle<Type>) -> bool {
        self.contains.get(ty.index()).is_some_and(|contains| *contains)
    }

    /// Whether the type is a part of `other`.
    fn is_inside(&self, other: &TypeInner) -> bool {
        match other {
            TypeInner::Pointer { base, .. } | TypeInner::Array { base, .. } | TypeInner::BindingArray { base, .. } => {
                self.has(*base)
            }
            TypeInner::Struct { members, .. } => members.iter().any(|member| self.has(member.ty)),
            _ => false,
        }
    }

    /// Adds the places of all uses inside of a function.
    fn within(&self, function: &Function, info: Option<&FunctionInfo>, places: &mut Vec<Span>) {
        let variables = function.local_variables.iter().filter(|(_, variable)| self.has(variable.ty));
        places.extend(variables.map(|(variable, _)| function.local_variables.get_span(variable)));
        let expressions = function.expressions.iter().filter(|(handle, expression)| match (expression, info) {
            (Expression::Compose { ty, .. } | Expression::ZeroValue(ty), _) => self.has(*ty),
            (_, Some(info)) => {
                let inner = info[*handle].ty.inner_with(&self.module.types);
                inner == self.ty || self.is_inside(inner)
            }
            (_, None) => false,
        });
        places.extend(expressions.map(|(expression, _)| function.expressions.get_span(expression)));
    }
}

/// naga's note about a text that is nested too deeply.
const TOO_DEEP: &str = "Parser recursion limit exceeded";

/// The message for a text that is nested too deeply, with what to do.
pub const NESTED_TOO_DEEPLY: &str = "this is nested too deeply for naga; use several statements";

/// Whether naga found the text nested too deeply.
pub fn is_too_deep(error: &ParseError) -> bool {
    error.notes().any(|note| note == TOO_DEEP)
}

/// Returns the offset in bytes of the token at which naga finds `source` nested too deeply. Returns `None` if naga does
/// not.
///
/// The parser reads from left to right, so it fails in the same way for every start of the text that has this token,
/// and in another way for every shorter start. A binary search needs 16 attempts for the longest text.
pub fn of_deep_nesting(source: &str) -> Option<usize> {
    let tokens: Vec<_> = tokens(source.as_bytes()).map(|(offset, token)| (offset, offset + token.len())).collect();
    let is_read = |&(_, end): &(usize, usize)| !matches!(parse_str(&source[..end]), Err(error) if is_too_deep(&error));
    tokens.get(tokens.partition_point(is_read)).map(|(offset, _)| *offset)
}
