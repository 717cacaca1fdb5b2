//! Lowers a function: its arguments, its variables and its body.

use naga::valid::FunctionInfo;
use naga::{Block, Expression, Function, FunctionArgument, FunctionResult, Handle, LocalVariable, Span};

use super::lowering::Lowering;
use super::refusal::{Lowered, Refusal};
use super::types::{Shape, pointee, shape};

/// What stands for an expression of the source.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// An expression.
    Plain(Handle<Expression>),
    /// A pointer to the component number `index` of a vector, where `index` is calculated. A component of a structure
    /// has no such pointer, so loads and stores replace it.
    Component {
        /// A pointer to the vector.
        vector: Handle<Expression>,
        /// The number of the component, as u32.
        index: Handle<Expression>,
        /// Number of components of the vector.
        count: u32,
    },
}

/// A function that is being lowered.
pub struct FunctionLowering<'l, 'a> {
    pub lowering: &'l mut Lowering<'a>,
    pub source: &'l Function,
    pub info: &'l FunctionInfo,
    /// The lowered function.
    pub function: Function,
    /// What stands for the expressions of the source, by their index.
    pub values: Vec<Option<Value>>,
    pub locals: Vec<Handle<LocalVariable>>,
    /// The statements so far of the innermost block.
    pub block: Block,
    /// The index of the first expression that is being emitted.
    pub emitting: Option<usize>,
    /// The place in the source of what is being written.
    pub span: Span,
}

impl<'l, 'a> FunctionLowering<'l, 'a> {
    pub fn new(lowering: &'l mut Lowering<'a>, source: &'l Function, info: &'l FunctionInfo) -> Self {
        Self {
            lowering,
            source,
            info,
            function: Function::default(),
            values: vec![None; source.expressions.len()],
            locals: Vec::new(),
            block: Block::new(),
            emitting: None,
            span: Span::UNDEFINED,
        }
    }

    /// Returns the lowered function.
    pub fn run(mut self) -> Lowered<Function> {
        self.function.name.clone_from(&self.source.name);
        self.function.diagnostic_filter_leaf = self.source.diagnostic_filter_leaf;
        for argument in &self.source.arguments {
            self.refuse_interface(argument.binding.as_ref(), argument.ty)?;
            let ty = self.lowering.types.of(argument.ty);
            self.function.arguments.push(FunctionArgument { ty, ..argument.clone() });
        }
        if let Some(result) = &self.source.result {
            self.refuse_interface(result.binding.as_ref(), result.ty)?;
            let ty = self.lowering.types.of(result.ty);
            self.function.result = Some(FunctionResult { ty, ..result.clone() });
        }
        for (handle, local) in self.source.local_variables.iter() {
            let init = local.init.map(|init| self.constant(init)).transpose()?;
            let lowered = LocalVariable { name: local.name.clone(), ty: self.lowering.types.of(local.ty), init };
            let span = self.source.local_variables.get_span(handle);
            self.locals.push(self.function.local_variables.append(lowered, span));
        }
        // These hold in the whole function, wherever they stand in the list.
        for (handle, expression) in self.source.expressions.iter() {
            if expression.needs_pre_emit() {
                self.at(self.source.expressions.get_span(handle));
                let lowered = self.declared(handle, expression)?;
                self.set(handle, Value::Plain(lowered));
            }
        }
        let source = self.source;
        self.lower_block(&source.body)?;
        self.flush();
        self.function.body = std::mem::take(&mut self.block);
        Ok(self.function)
    }

    fn refuse_interface(&self, binding: Option<&naga::Binding>, ty: Handle<naga::Type>) -> Lowered<()> {
        let is_f64 = shape(&self.lowering.source.types[ty].inner).is_some();
        if is_f64 && binding.is_some() {
            let span = self.lowering.source.types.get_span(ty);
            return Err(Refusal::new(span, "f64 between shader stages"));
        }
        Ok(())
    }

    /// Remembers what stands for an expression of the source, and gives it the same name.
    pub fn set(&mut self, handle: Handle<Expression>, value: Value) {
        self.values[handle.index()] = Some(value);
        if let (Value::Plain(lowered), Some(name)) = (value, self.source.named_expressions.get(&handle)) {
            self.function.named_expressions.insert(lowered, name.clone());
        }
    }

    /// Returns what stands for an expression of the source.
    pub fn value(&mut self, handle: Handle<Expression>) -> Lowered<Value> {
        match self.values[handle.index()] {
            Some(value) => Ok(value),
            None => self.constant(handle).map(Value::Plain),
        }
    }

    /// Returns the expression that stands for one of the source.
    pub fn plain(&mut self, handle: Handle<Expression>) -> Lowered<Handle<Expression>> {
        match self.value(handle)? {
            Value::Plain(lowered) => Ok(lowered),
            Value::Component { .. } => Err(Refusal::new(self.span, "this use of a pointer to a component of f64")),
        }
    }

    /// Returns the shape of an expression of the source, or `None` if it has no f64.
    pub fn shape(&self, handle: Handle<Expression>) -> Option<Shape> {
        shape(self.info[handle].ty.inner_with(&self.lowering.source.types))
    }

    /// Returns the shape of what an expression of the source points to, or of its value.
    pub fn pointee_shape(&self, handle: Handle<Expression>) -> Option<Shape> {
        let inner = self.info[handle].ty.inner_with(&self.lowering.source.types);
        match *inner {
            naga::TypeInner::ValuePointer { size: Some(size), scalar: naga::Scalar::F64, .. } => {
                Some(Shape::Vector(size))
            }
            _ => shape(pointee(inner, self.lowering.source)),
        }
    }
}
