//! The types of the lowered module.
//!
//! A vector of f64 has no counterpart among the vectors of WGSL, which have 32-bit components only. It becomes a
//! structure with a member for each component. A vector of three has 24 bytes, but in an array it takes 32. So an array
//! holds it in one more structure, whose size is 32.

use naga::valid::ModuleInfo;
use naga::{
    ArraySize, Binding, Handle, Module, PredeclaredType, Scalar, Span, StructMember, Type, TypeInner, UniqueArena,
    VectorSize,
};

use super::refusal::{Lowered, Refusal};
use crate::diagnostic::places::of_type;

/// The form of a value that is f64 or has components of f64.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A single number.
    Scalar,
    /// A vector.
    Vector(VectorSize),
}

/// Returns the shape of `inner`, or `None` if it is no f64 and no vector of f64.
pub const fn shape(inner: &TypeInner) -> Option<Shape> {
    match *inner {
        TypeInner::Scalar(Scalar::F64) => Some(Shape::Scalar),
        TypeInner::Vector { size, scalar: Scalar::F64 } => Some(Shape::Vector(size)),
        _ => None,
    }
}

/// Returns what a pointer of type `inner` points to. Any other type is returned as it is.
pub fn pointee<'a>(inner: &'a TypeInner, module: &'a Module) -> &'a TypeInner {
    match *inner {
        TypeInner::Pointer { base, .. } => &module.types[base].inner,
        _ => inner,
    }
}

/// Whether the elements of the array `inner`, or of the array to which it points, are vectors of three f64. Each is
/// then inside a structure of 32 bytes.
pub fn pads_elements(inner: &TypeInner, module: &Module) -> bool {
    match *pointee(inner, module) {
        TypeInner::Array { base, .. } => is_triple(&module.types[base].inner),
        _ => false,
    }
}

fn is_triple(inner: &TypeInner) -> bool {
    shape(inner) == Some(Shape::Vector(VectorSize::Tri))
}

/// The types of the lowered module, by those of the source.
#[derive(Debug, Default)]
pub struct Types {
    map: Vec<Handle<Type>>,
}

impl Types {
    /// Copies all types of `source` into `module`.
    pub fn new(source: &Module, info: &ModuleInfo, module: &mut Module) -> Lowered<Self> {
        let mut types = Self::default();
        for (handle, ty) in source.types.iter() {
            let span = source.types.get_span(handle);
            let refused = |what| Refusal::new(of_type(handle, source, Some(info)), what);
            let inner = types.lower(ty, source, module).map_err(refused)?;
            let name = if shape(&ty.inner).is_some() { name_of(&ty.inner) } else { ty.name.clone() };
            types.map.push(module.types.insert(Type { name, inner }, span));
        }
        for (key, &handle) in &source.special_types.predeclared_types {
            // The operations that need the other types are refused where they stand.
            let has_f64 = matches!(key, PredeclaredType::ModfResult { scalar: Scalar::F64, .. })
                || matches!(key, PredeclaredType::FrexpResult { scalar: Scalar::F64, .. });
            if !has_f64 {
                module.special_types.predeclared_types.insert(key.clone(), types.of(handle));
            }
        }
        Ok(types)
    }

    /// Returns the lowered type of the source's type `handle`.
    pub fn of(&self, handle: Handle<Type>) -> Handle<Type> {
        self.map[handle.index()]
    }

    /// Returns the lowered type of `ty`, or what cannot be lowered.
    fn lower(&self, ty: &Type, source: &Module, module: &mut Module) -> Result<TypeInner, &'static str> {
        Ok(match ty.inner {
            TypeInner::Scalar(Scalar::F64) => WORDS,
            TypeInner::Vector { size, scalar: Scalar::F64 } => vector(size, &mut module.types),
            TypeInner::Matrix { scalar: Scalar::F64, .. } => return Err("a matrix of f64"),
            TypeInner::Pointer { base, space } => TypeInner::Pointer { base: self.of(base), space },
            TypeInner::Array { size: ArraySize::Pending(_), .. } => return Err("an array sized by an override"),
            TypeInner::Array { base, size, stride } => {
                let is_padded = is_triple(&source.types[base].inner);
                let base = if is_padded { padded_type(&mut module.types) } else { self.of(base) };
                TypeInner::Array { base, size, stride }
            }
            TypeInner::Struct { ref members, span: size } => {
                let has_f64 = |member: &StructMember| shape(&source.types[member.ty].inner).is_some();
                let is_interface = |member: &StructMember| matches!(member.binding, Some(Binding::Location { .. }));
                if members.iter().any(|member| is_interface(member) && has_f64(member)) {
                    return Err("f64 between shader stages");
                }
                let members = members.iter().map(|member| StructMember { ty: self.of(member.ty), ..member.clone() });
                TypeInner::Struct { members: members.collect(), span: size }
            }
            ref other @ (TypeInner::Scalar(_) | TypeInner::Vector { .. } | TypeInner::Matrix { .. }) => other.clone(),
            _ => return Err("this type"),
        })
    }
}

/// The type of a single number: two words.
const WORDS: TypeInner = TypeInner::Vector { size: VectorSize::Bi, scalar: Scalar::U32 };

/// Returns the type of a single number in the lowered module.
pub fn words_type(types: &mut UniqueArena<Type>) -> Handle<Type> {
    types.insert(Type { name: None, inner: WORDS }, Span::UNDEFINED)
}

/// Returns the type of a value of this shape in the lowered module.
pub fn shape_type(shape: Shape, types: &mut UniqueArena<Type>) -> Handle<Type> {
    match shape {
        Shape::Scalar => words_type(types),
        Shape::Vector(size) => vector_type(size, types),
    }
}

fn vector_type(size: VectorSize, types: &mut UniqueArena<Type>) -> Handle<Type> {
    let inner = vector(size, types);
    types.insert(Type { name: vector_name(size), inner }, Span::UNDEFINED)
}

/// Returns the structure of 32 bytes that holds a vector of three in an array.
pub fn padded_type(types: &mut UniqueArena<Type>) -> Handle<Type> {
    let ty = vector_type(VectorSize::Tri, types);
    let members = vec![StructMember { name: Some("value".to_owned()), ty, binding: None, offset: 0 }];
    let inner = TypeInner::Struct { members, span: 32 };
    types.insert(Type { name: Some("PaddedF64Triple".to_owned()), inner }, Span::UNDEFINED)
}

fn vector(size: VectorSize, types: &mut UniqueArena<Type>) -> TypeInner {
    let ty = words_type(types);
    let member = |(place, name): (u32, &&str)| StructMember {
        name: Some((*name).to_owned()),
        ty,
        binding: None,
        offset: 8 * place,
    };
    let members = (0..).zip(&["x", "y", "z", "w"][..size as usize]).map(member).collect();
    TypeInner::Struct { members, span: 8 * size as u32 }
}

fn vector_name(size: VectorSize) -> Option<String> {
    let name = match size {
        VectorSize::Bi => "F64Pair",
        VectorSize::Tri => "F64Triple",
        VectorSize::Quad => "F64Quad",
    };
    Some(name.to_owned())
}

fn name_of(inner: &TypeInner) -> Option<String> {
    match *inner {
        TypeInner::Vector { size, .. } => vector_name(size),
        _ => None,
    }
}
