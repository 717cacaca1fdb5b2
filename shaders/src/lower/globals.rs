//! Constants, overrides and variables that stand outside of functions.

use naga::{
    AddressSpace, Constant, Expression, GlobalVariable, Handle, Literal, Module, Override, Span, Type, TypeInner,
    VectorSize,
};

use super::lowering::Lowering;
use super::refusal::{Lowered, Refusal};
use super::types::{Shape, shape, shape_type};

impl Lowering<'_> {
    /// Lowers everything that stands outside of functions, except for types.
    pub fn lower_globals(&mut self) -> Lowered<()> {
        let source = self.source;
        for (handle, expression) in source.global_expressions.iter() {
            let lowered = self.global_expression(handle, expression)?;
            self.global_expressions.push(lowered);
        }
        for (handle, _) in source.constants.iter() {
            self.constant(handle);
        }
        for (handle, _) in source.overrides.iter() {
            self.override_(handle)?;
        }
        for (handle, variable) in source.global_variables.iter() {
            let span = source.global_variables.get_span(handle);
            if variable.space == AddressSpace::Uniform && crowds_triple(source, variable.ty) {
                return Err(Refusal::new(span, "a number just after a vec3<f64>, in uniform memory, that"));
            }
            let ty = self.types.of(variable.ty);
            let init = variable.init.map(|init| self.global_expressions[init.index()]);
            let lowered = GlobalVariable { ty, init, ..variable.clone() };
            self.globals.push(self.module.global_variables.append(lowered, span));
        }
        Ok(())
    }

    /// Returns the lowered constant. The expressions that it needs have been lowered.
    fn constant(&mut self, handle: Handle<Constant>) -> Handle<Constant> {
        if let Some(&lowered) = self.constants.get(&handle) {
            return lowered;
        }
        let Constant { ref name, ty, init } = self.source.constants[handle];
        let constant =
            Constant { name: name.clone(), ty: self.types.of(ty), init: self.global_expressions[init.index()] };
        let lowered = self.module.constants.append(constant, self.source.constants.get_span(handle));
        self.constants.insert(handle, lowered);
        lowered
    }

    fn override_(&mut self, handle: Handle<Override>) -> Lowered<Handle<Override>> {
        if let Some(&lowered) = self.overrides.get(&handle) {
            return Ok(lowered);
        }
        let source = &self.source.overrides[handle];
        let span = self.source.overrides.get_span(handle);
        if shape(&self.source.types[source.ty].inner).is_some() {
            return Err(Refusal::new(span, "an override of f64"));
        }
        let ty = self.types.of(source.ty);
        let init = source.init.map(|init| self.global_expressions[init.index()]);
        let lowered = self.module.overrides.append(Override { ty, init, ..source.clone() }, span);
        self.overrides.insert(handle, lowered);
        Ok(lowered)
    }

    fn global_expression(&mut self, handle: Handle<Expression>, source: &Expression) -> Lowered<Handle<Expression>> {
        let span = self.source.global_expressions.get_span(handle);
        let lowered = match *source {
            Expression::Literal(Literal::F64(number)) => return Ok(self.words(number)),
            Expression::Literal(literal) => Expression::Literal(literal),
            Expression::Constant(constant) => Expression::Constant(self.constant(constant)),
            Expression::Override(handle) => Expression::Override(self.override_(handle)?),
            Expression::ZeroValue(ty) => Expression::ZeroValue(self.types.of(ty)),
            Expression::Compose { ty, ref components } => {
                let inner = &self.source.types[ty].inner;
                let components: Vec<_> = components.iter().map(|part| self.global_expressions[part.index()]).collect();
                if super::types::pads_elements(inner, self.source) {
                    return Ok(self.padded_elements(ty, &components));
                }
                if matches!(shape(inner), Some(Shape::Vector(size)) if size as usize != components.len()) {
                    return Err(Refusal::new(span, "a constant vector of f64 that is made of vectors"));
                }
                Expression::Compose { ty: self.types.of(ty), components }
            }
            Expression::Splat { size, value } => {
                let of_f64 = self.info[handle].inner_with(&self.source.types);
                let value = self.global_expressions[value.index()];
                match shape(of_f64) {
                    Some(of_f64) => {
                        let ty = shape_type(of_f64, &mut self.module.types);
                        Expression::Compose { ty, components: vec![value; size as usize] }
                    }
                    None => Expression::Splat { size, value },
                }
            }
            // naga has calculated all others, unless they depend on an override. Its writer cannot write them.
            _ => return Err(Refusal::new(span, "an expression of overrides")),
        };
        Ok(self.module.global_expressions.append(lowered, span))
    }

    /// Returns a constant array of vectors of three, each inside a structure of 32 bytes.
    fn padded_elements(&mut self, ty: Handle<Type>, elements: &[Handle<Expression>]) -> Handle<Expression> {
        let padded = super::types::padded_type(&mut self.module.types);
        let pad = |&element: &Handle<Expression>| Expression::Compose { ty: padded, components: vec![element] };
        let components =
            elements.iter().map(|element| self.module.global_expressions.append(pad(element), Span::UNDEFINED));
        let components = components.collect();
        self.global(Expression::Compose { ty: self.types.of(ty), components })
    }
}

/// Whether a structure in `ty` has a member within the last 8 of the 32 bytes that begin with a vec3<f64>. Uniform
/// memory does not allow a member so near to a structure, which the vector becomes.
fn crowds_triple(module: &Module, ty: Handle<Type>) -> bool {
    match &module.types[ty].inner {
        TypeInner::Array { base, .. } => crowds_triple(module, *base),
        TypeInner::Struct { members, .. } => {
            let is_triple = |ty| shape(&module.types[ty].inner) == Some(Shape::Vector(VectorSize::Tri));
            members.iter().any(|member| crowds_triple(module, member.ty))
                || members.windows(2).any(|pair| is_triple(pair[0].ty) && pair[1].offset < pair[0].offset + 32)
        }
        _ => false,
    }
}
