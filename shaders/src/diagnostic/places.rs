//! Finds the place of a type. naga keeps a place for structures only, so the place of another type is its first use.

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Expression, Function, Handle, Module, Span, Type, TypeInner};

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
