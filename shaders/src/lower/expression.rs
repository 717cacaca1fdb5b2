//! Lowers an expression that is evaluated in a function: loads, and what builds and divides values.

use naga::{Expression, Handle, Scalar, ScalarKind, Span, Type, TypeInner, VectorSize};

use super::copy::copy;
use super::function::{FunctionLowering, Value};
use super::refusal::Lowered;
use super::types::{Shape, padded_type, pads_elements, shape, shape_type};

impl FunctionLowering<'_, '_> {
    /// Appends what stands for an expression of the source, and the calls that it needs.
    pub fn lower_expression(&mut self, handle: Handle<Expression>) -> Lowered<Value> {
        let source = self.source;
        let lowered = match source.expressions[handle] {
            Expression::Access { base, index } => return self.access(base, index),
            Expression::AccessIndex { base, .. } => {
                let element = copy(self, handle)?;
                let element = self.emit(element);
                return Ok(Value::Plain(self.unpadded(base, element)));
            }
            Expression::Load { pointer } => return self.load(pointer).map(Value::Plain),
            Expression::Compose { ty, ref components } => return self.compose(ty, components).map(Value::Plain),
            Expression::Splat { size, value } if self.shape(value).is_some() => {
                let value = self.plain(value)?;
                Some(self.vector(&vec![value; size as usize]))
            }
            Expression::Swizzle { size, vector, pattern } if self.shape(vector).is_some() => {
                let components = self.components(vector)?;
                let chosen: Vec<_> =
                    pattern[..size as usize].iter().map(|component| components[*component as usize]).collect();
                Some(self.vector(&chosen))
            }
            Expression::Select { condition, accept, reject } if self.shape(accept).is_some() => {
                Some(self.select(condition, accept, reject)?)
            }
            Expression::Unary { op, expr } => self.unary(op, expr)?,
            Expression::Binary { op, left, right } => self.binary(op, left, right)?,
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let arguments: Vec<_> = [Some(arg), arg1, arg2, arg3].into_iter().flatten().collect();
                self.math(fun, &arguments)?
            }
            Expression::As { expr, kind, convert } => self.convert(handle, expr, kind, convert)?,
            _ => None,
        };
        match lowered {
            Some(lowered) => Ok(Value::Plain(lowered)),
            None => {
                let lowered = copy(self, handle)?;
                Ok(Value::Plain(self.emit(lowered)))
            }
        }
    }

    /// Returns the components of a vector of the source, or the number itself.
    pub fn components(&mut self, handle: Handle<Expression>) -> Lowered<Vec<Handle<Expression>>> {
        let lowered = self.plain(handle)?;
        Ok(match self.shape(handle) {
            Some(Shape::Vector(size)) => self.parts(lowered, size),
            _ => vec![lowered],
        })
    }

    /// Returns the components of a lowered vector.
    fn parts(&mut self, vector: Handle<Expression>, size: VectorSize) -> Vec<Handle<Expression>> {
        match &self.function.expressions[vector] {
            Expression::Compose { components, .. } => components.clone(),
            _ => {
                let part = |index| self.emit(Expression::AccessIndex { base: vector, index });
                (0..size as u32).map(part).collect()
            }
        }
    }

    /// Returns the vector of these components, which are f64, or the number if there is one.
    pub fn vector(&mut self, components: &[Handle<Expression>]) -> Handle<Expression> {
        self.vector_of(Scalar::F64, components)
    }

    /// Returns the vector of these components, or the component if there is one.
    pub fn vector_of(&mut self, scalar: Scalar, components: &[Handle<Expression>]) -> Handle<Expression> {
        let sizes = [VectorSize::Bi, VectorSize::Tri, VectorSize::Quad];
        let Some(size) = sizes.into_iter().find(|size| *size as usize == components.len()) else {
            return components[0];
        };
        let types = &mut self.lowering.module.types;
        let ty = match scalar {
            Scalar::F64 => shape_type(Shape::Vector(size), types),
            _ => types.insert(Type { name: None, inner: TypeInner::Vector { size, scalar } }, Span::UNDEFINED),
        };
        self.emit(Expression::Compose { ty, components: components.to_vec() })
    }

    /// Returns the vector in an element of the array `base`, if the element is padded; otherwise the element.
    fn unpadded(&mut self, base: Handle<Expression>, element: Handle<Expression>) -> Handle<Expression> {
        let inner = self.info[base].ty.inner_with(&self.lowering.source.types);
        if pads_elements(inner, self.lowering.source) {
            return self.emit(Expression::AccessIndex { base: element, index: 0 });
        }
        element
    }

    /// Lowers `base[index]`, where `index` is calculated.
    fn access(&mut self, base: Handle<Expression>, index: Handle<Expression>) -> Lowered<Value> {
        let base_inner = self.info[base].ty.inner_with(&self.lowering.source.types);
        let is_pointer = base_inner.pointer_space().is_some();
        let (vector, index_kind) =
            (self.plain(base)?, self.info[index].ty.inner_with(&self.lowering.source.types).scalar_kind());
        let index = self.plain(index)?;
        let Some(Shape::Vector(size)) = self.pointee_shape(base) else {
            let element = self.emit(Expression::Access { base: vector, index });
            return Ok(Value::Plain(self.unpadded(base, element)));
        };
        let index = match index_kind {
            Some(ScalarKind::Uint) => index,
            _ => self.emit(Expression::As { expr: index, kind: ScalarKind::Uint, convert: Some(4) }),
        };
        let count = size as u32;
        if is_pointer {
            return Ok(Value::Component { vector, index, count });
        }
        let components = self.parts(vector, size);
        Ok(Value::Plain(self.chosen(&components, index)))
    }

    /// Returns the component number `index`; beyond the last component, where WGSL allows any value, the last one.
    fn chosen(&mut self, components: &[Handle<Expression>], index: Handle<Expression>) -> Handle<Expression> {
        let mut chosen = components[components.len() - 1];
        for (place, &component) in components[..components.len() - 1].iter().enumerate() {
            let right = self.word(place as u32);
            let op = naga::BinaryOperator::Equal;
            let condition = self.emit(Expression::Binary { op, left: index, right });
            chosen = self.emit(Expression::Select { condition, accept: component, reject: chosen });
        }
        chosen
    }

    fn load(&mut self, pointer: Handle<Expression>) -> Lowered<Handle<Expression>> {
        Ok(match self.value(pointer)? {
            Value::Plain(pointer) => self.emit(Expression::Load { pointer }),
            Value::Component { vector, index, count } => {
                let mut components = Vec::new();
                for place in 0..count {
                    let pointer = self.emit(Expression::AccessIndex { base: vector, index: place });
                    components.push(self.emit(Expression::Load { pointer }));
                }
                self.chosen(&components, index)
            }
        })
    }

    fn compose(&mut self, ty: Handle<Type>, source: &[Handle<Expression>]) -> Lowered<Handle<Expression>> {
        let inner = &self.lowering.source.types[ty].inner;
        if shape(inner).is_some() {
            // A part of a vector may be a vector itself.
            let parts = source.iter().map(|part| self.components(*part)).collect::<Lowered<Vec<_>>>()?;
            return Ok(self.vector(&parts.concat()));
        }
        let mut components = source.iter().map(|part| self.plain(*part)).collect::<Lowered<Vec<_>>>()?;
        if pads_elements(inner, self.lowering.source) {
            let padded = padded_type(&mut self.lowering.module.types);
            for component in &mut components {
                *component = self.emit(Expression::Compose { ty: padded, components: vec![*component] });
            }
        }
        let ty = self.lowering.types.of(ty);
        Ok(self.emit(Expression::Compose { ty, components }))
    }

    /// Lowers a choice between numbers or vectors. The condition of a vector may have a component for each of its own.
    fn select(
        &mut self,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Lowered<Handle<Expression>> {
        let is_vector =
            matches!(self.info[condition].ty.inner_with(&self.lowering.source.types), TypeInner::Vector { .. });
        let condition = self.plain(condition)?;
        let (accept, reject) = (self.components(accept)?, self.components(reject)?);
        let mut components = Vec::new();
        for (index, (&accept, &reject)) in (0..).zip(accept.iter().zip(&reject)) {
            let own = match is_vector {
                true => self.emit(Expression::AccessIndex { base: condition, index }),
                false => condition,
            };
            components.push(self.emit(Expression::Select { condition: own, accept, reject }));
        }
        Ok(self.vector(&components))
    }
}
