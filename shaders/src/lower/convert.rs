//! Lowers conversions from f64 and to f64.

use naga::common::wgsl::TryToWgsl;
use naga::{Bytes, Expression, Handle, Scalar, ScalarKind, TypeInner};

use super::function::FunctionLowering;
use super::refusal::{Lowered, Refusal};
use super::types::{Shape, shape};

impl FunctionLowering<'_, '_> {
    /// Lowers a conversion to `kind` with a width of `width` bytes. Without a width the bits are kept. Returns `None`
    /// if neither side is f64.
    pub fn convert(
        &mut self,
        result: Handle<Expression>,
        source: Handle<Expression>,
        kind: ScalarKind,
        width: Option<Bytes>,
    ) -> Lowered<Option<Handle<Expression>>> {
        let types = &self.lowering.source.types;
        let to = shape(self.info[result].ty.inner_with(types));
        let from = self.shape(source);
        let source_scalar = self.info[source].ty.inner_with(types).scalar();
        let Some(width) = width else {
            return match (from, to) {
                (None, None) => Ok(None),
                (Some(Shape::Scalar), Some(Shape::Scalar)) => self.plain(source).map(Some),
                (Some(Shape::Scalar), None) if kind == ScalarKind::Uint => self.bits_of(source).map(Some),
                (None, Some(Shape::Scalar)) if source_scalar == Some(Scalar::U64) => self.number_of(source).map(Some),
                _ => Err(Refusal::new(self.span, "this bitcast of f64")),
            };
        };
        let other = Scalar { kind, width };
        match (from, to) {
            (None, None) => Ok(None),
            (Some(_), Some(_)) => self.plain(source).map(Some),
            (Some(_), None) => {
                let name = match other {
                    Scalar::F32 => "f64_to_f32",
                    Scalar::I32 => "f64_to_i32",
                    Scalar::U32 => "f64_to_u32",
                    Scalar::BOOL => "f64_to_bool",
                    _ => return Err(Refusal::new(self.span, format!("a conversion of f64 to {}", name(other)))),
                };
                let components = self.each_component(name, &[source])?;
                Ok(Some(self.vector_of(other, &components)))
            }
            (None, Some(_)) => {
                let from = source_scalar.unwrap_or(other);
                let function = match from {
                    Scalar::F32 => "f64_from_f32",
                    Scalar::I32 => "f64_from_i32",
                    Scalar::U32 => "f64_from_u32",
                    Scalar::BOOL => "f64_from_bool",
                    _ => return Err(Refusal::new(self.span, format!("a conversion of {} to f64", name(from)))),
                };
                let inner = self.info[source].ty.inner_with(&self.lowering.source.types);
                let count = match *inner {
                    TypeInner::Vector { size, .. } => size as u32,
                    _ => 1,
                };
                let vector = self.plain(source)?;
                let mut components = Vec::new();
                for index in 0..count {
                    let part = match count {
                        1 => vector,
                        _ => self.emit(Expression::AccessIndex { base: vector, index }),
                    };
                    components.push(self.call(function, &[part])?);
                }
                Ok(Some(self.vector(&components)))
            }
        }
    }

    /// Returns the bits of a number as u64.
    fn bits_of(&mut self, source: Handle<Expression>) -> Lowered<Handle<Expression>> {
        let words = self.plain(source)?;
        let thirty_two = self.word(32);
        let [low, high] = [0, 1].map(|index| {
            let expr = self.emit(Expression::AccessIndex { base: words, index });
            self.emit(Expression::As { expr, kind: ScalarKind::Uint, convert: Some(8) })
        });
        let op = naga::BinaryOperator::ShiftLeft;
        let high = self.emit(Expression::Binary { op, left: high, right: thirty_two });
        Ok(self.emit(Expression::Binary { op: naga::BinaryOperator::InclusiveOr, left: high, right: low }))
    }

    /// Returns the number with the bits of a u64.
    fn number_of(&mut self, source: Handle<Expression>) -> Lowered<Handle<Expression>> {
        let bits = self.plain(source)?;
        let thirty_two = self.word(32);
        let op = naga::BinaryOperator::ShiftRight;
        let high = self.emit(Expression::Binary { op, left: bits, right: thirty_two });
        let components =
            [bits, high].map(|expr| self.emit(Expression::As { expr, kind: ScalarKind::Uint, convert: Some(4) }));
        let ty = super::types::words_type(&mut self.lowering.module.types);
        Ok(self.emit(Expression::Compose { ty, components: components.to_vec() }))
    }
}

/// Returns the name of the type in WGSL.
fn name(scalar: Scalar) -> &'static str {
    scalar.try_to_wgsl().unwrap_or("an abstract number")
}
