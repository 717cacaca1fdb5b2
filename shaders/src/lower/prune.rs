//! Removes the functions of the arithmetic that a lowered module does not use.

use naga::compact::{KeepUnused, compact};
use naga::{EntryPoint, Expression, Function, Handle, Module, ShaderStage, Span, Statement};

/// Removes what `module` does not use, except for `functions` and for all variables and overrides, by which a program
/// may know the module.
pub fn prune(module: &mut Module, functions: &[Handle<Function>]) {
    // For a moment an entry point uses everything that must stay. naga's function then removes the rest.
    let mut keeper = Function::default();
    for &function in functions {
        let call = Statement::Call { function, arguments: Vec::new(), result: None };
        keeper.body.push(call, Span::UNDEFINED);
    }
    let variables = module.global_variables.iter().map(|(handle, _)| Expression::GlobalVariable(handle));
    let overrides = module.overrides.iter().map(|(handle, _)| Expression::Override(handle));
    for expression in variables.chain(overrides) {
        let handle = keeper.expressions.append(expression, Span::UNDEFINED);
        keeper.named_expressions.insert(handle, "kept".to_owned());
    }
    module.entry_points.push(EntryPoint {
        name: "keeper".to_owned(),
        stage: ShaderStage::Compute,
        early_depth_test: None,
        workgroup_size: [1; 3],
        workgroup_size_overrides: None,
        function: keeper,
        mesh_info: None,
        task_payload: None,
        incoming_ray_payload: None,
    });
    compact(module, KeepUnused::No);
    module.entry_points.pop();
}
