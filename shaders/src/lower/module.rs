//! Copies a module into one that has the arithmetic, part after part.

use std::collections::HashMap;

use naga::valid::ModuleInfo;
use naga::{Constant, EntryPoint, Expression, Function, GlobalVariable, Handle, Literal, Module, Override, Span};

use super::function::FunctionLowering;
use super::refusal::{Lowered, Refusal};
use super::types::{Types, words_type};

/// What stands for an override of the source.
#[derive(Clone, Copy, Debug)]
pub enum LoweredOverride {
    /// One override of the same type.
    Same(Handle<Override>),
    /// The low and the high word of a number.
    Words([Handle<Override>; 2]),
}

/// A module that is being lowered.
pub struct Lowering<'a> {
    pub source: &'a Module,
    pub info: &'a ModuleInfo,
    /// The lowered module, which begins with the arithmetic.
    pub module: Module,
    pub types: Types,
    pub constants: HashMap<Handle<Constant>, Handle<Constant>>,
    pub overrides: HashMap<Handle<Override>, LoweredOverride>,
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

    /// Returns the lowered module, and its functions without those of the arithmetic. All of the arithmetic is there.
    pub fn run(mut self) -> Lowered<(Module, Vec<Handle<Function>>)> {
        let (source, info) = (self.source, self.info);
        self.module.diagnostic_filters = source.diagnostic_filters.clone();
        self.module.diagnostic_filter_leaf = source.diagnostic_filter_leaf;
        self.types = Types::new(source, info, &mut self.module)?;
        self.lower_globals()?;
        for (handle, function) in source.functions.iter() {
            let lowered = FunctionLowering::new(&mut self, function, &info[handle]).run()?;
            let handle = self.module.functions.append(lowered, source.functions.get_span(handle));
            self.functions.push(handle);
        }
        for (index, entry) in source.entry_points.iter().enumerate() {
            let entry = self.lower_entry_point(index, entry)?;
            self.module.entry_points.push(entry);
        }
        Ok((self.module, self.functions))
    }

    fn lower_entry_point(&mut self, index: usize, entry: &EntryPoint) -> Lowered<EntryPoint> {
        let refused = |what: &str| Err(Refusal::of_entry_point(what, &entry.name));
        if entry.workgroup_size_overrides.iter().flatten().any(Option::is_some) {
            return refused("a workgroup size by an override, that");
        }
        if entry.mesh_info.is_some() || entry.task_payload.is_some() || entry.incoming_ray_payload.is_some() {
            return refused("the stage");
        }
        let info = self.info.get_entry_point(index);
        let function = FunctionLowering::new(self, &entry.function, info).run()?;
        Ok(EntryPoint {
            name: entry.name.clone(),
            stage: entry.stage,
            early_depth_test: entry.early_depth_test,
            workgroup_size: entry.workgroup_size,
            workgroup_size_overrides: None,
            function,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        })
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
pub fn split(number: f64) -> [u32; 2] {
    let bits = number.to_bits();
    [bits as u32, (bits >> 32) as u32]
}
