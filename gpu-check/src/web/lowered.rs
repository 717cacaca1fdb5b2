//! The jobs that compute each operation of f64 by integers.

use std::collections::BTreeMap;

use serde_json::json;
use shaders::lower::Arithmetic;
use shaders::{Composition, Precision};

use super::jobs::{Job, Jobs};
use crate::Error;
use crate::lowered::operands::Operands;
use crate::lowered::operations::Operation;

/// Adds jobs that compute each of `operations` for all `cases`. Their names are `operation/` and an index.
///
/// # Errors
/// The errors of lowering.
pub fn add_operations<'a>(
    jobs: &mut Jobs,
    operations: impl Iterator<Item = &'a Operation>,
    cases: &[Operands],
) -> Result<(), Error> {
    let packed: Vec<_> = cases.iter().map(Operands::packed).collect();
    jobs.add_bytes("cases", bytemuck::cast_slice(&packed).to_vec());
    for (index, operation) in operations.enumerate() {
        let text = crate::lowered::kernel(operation);
        let composition = Composition::of_file(operation.wgsl, text, Precision::F64);
        let code = composition.lowered(&Arithmetic::standard())?;
        let (name, shader) = (format!("operation/{index}"), format!("wgsl/operation/{index}"));
        jobs.add_bytes(&shader, code.source().as_bytes().to_vec());
        jobs.add(&Job {
            name: &name,
            shader: &shader,
            entry: "operation",
            written: &[false, true],
            constants: BTreeMap::new(),
            contents: vec![json!("cases"), json!(cases.len() * operation.outcome.size())],
            output: 1,
            invocations: cases.len(),
        });
    }
    Ok(())
}
