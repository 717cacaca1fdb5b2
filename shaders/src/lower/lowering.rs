//! What is known while a module is lowered: what stands for its types, constants, variables and functions.

use std::collections::HashMap;

use naga::valid::ModuleInfo;
use naga::{Constant, Expression, Function, GlobalVariable, Handle, Literal, Module, Override, Span};

use super::refusal::{Lowered, Refusal};
use super::types::{Types, words_type};

/// A module that is being lowered.
pub struct Lowering<'a> {
    pub source: &'a Module,
    pub info: &'a ModuleInfo,
    /// The lowered module, which begins with the arithmetic.
    pub module: Module,
    pub types: Types,
    pub constants: HashMap<Handle<Constant>, Handle<Constant>>,
    pub overrides: HashMap<Handle<Override>, Handle<Override>>,
    pub globals: Vec<Handle<GlobalVariable>>,
    pub global_expressions: Vec<Handle<Expression>>,
    pub functions: Vec<Handle<Function>>,
    /// The functions of the arithmetic by their names.
    arithmetic: HashMap<String, Handle<Function>>,
    /// Constants without a name, by the bits of the number.
    literals: HashMap<u64, Handle<Constant>>,
}

impl<'a> Lowering<'a> {
    /// Returns the lowering of `source` into `module`, which has the arithmetic and nothing else.
    pub fn new(source: &'a Module, info: &'a ModuleInfo, module: Module) -> Self {
        let named = |(handle, function): (Handle<Function>, &Function)| Some((function.name.clone()?, handle));
        Self {
            source,
            info,
            arithmetic: module.functions.iter().filter_map(named).collect(),
            module,
            types: Types::default(),
            constants: HashMap::new(),
            overrides: HashMap::new(),
            globals: Vec::new(),
            global_expressions: Vec::new(),
            functions: Vec::new(),
            literals: HashMap::new(),
        }
    }

    /// Returns the function `name` of the arithmetic, or a refusal if a change of the arithmetic has removed it.
    pub fn arithmetic(&self, name: &str, span: Span) -> Lowered<Handle<Function>> {
        self.arithmetic.get(name).copied().ok_or_else(|| Refusal::new(span, format!("an operation without `{name}`")))
    }

    /// Returns an unnamed constant with the words of `number`.
    pub fn literal(&mut self, number: f64) -> Handle<Constant> {
        if let Some(&handle) = self.literals.get(&number.to_bits()) {
            return handle;
        }
        let ty = words_type(&mut self.module.types);
        let init = self.words(number);
        let handle = self.module.constants.append(Constant { name: None, ty, init }, Span::UNDEFINED);
        self.literals.insert(number.to_bits(), handle);
        handle
    }

    /// Returns a global expression with the words of `number`.
    pub fn words(&mut self, number: f64) -> Handle<Expression> {
        let ty = words_type(&mut self.module.types);
        let components = split(number).map(|word| self.global(Expression::Literal(Literal::U32(word)))).to_vec();
        self.global(Expression::Compose { ty, components })
    }

    /// Appends a global expression.
    pub fn global(&mut self, expression: Expression) -> Handle<Expression> {
        self.module.global_expressions.append(expression, Span::UNDEFINED)
    }
}

/// Returns the low and the high word of a number.
fn split(number: f64) -> [u32; 2] {
    let bits = number.to_bits();
    [bits as u32, (bits >> 32) as u32]
}
