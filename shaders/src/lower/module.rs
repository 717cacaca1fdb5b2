//! Copies a module into one that has the arithmetic, part after part.

use naga::{EntryPoint, Function, Handle, Module};

use super::function::FunctionLowering;
use super::lowering::Lowering;
use super::refusal::{Lowered, Refusal};
use super::types::Types;

impl Lowering<'_> {
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
        Ok(EntryPoint { workgroup_size_overrides: None, function, ..entry.clone() })
    }
}
