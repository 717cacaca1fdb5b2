//! The jobs that compute every formula, with the results that Rust has.

use std::collections::BTreeMap;

use serde_json::json;
use shaders::Library;

use super::jobs::{Job, Jobs};
use crate::{Error, Float, Formulas, Kernel};

/// Number of random cases of each formula. They follow its edge cases.
const RANDOM: usize = 1 << 14;

/// Adds a job for each of `kernels`, with the modules of `library`. It computes the formula for all its [`cases`]. Its
/// name is that of the module.
///
/// # Errors
/// The errors of [`Library::compose`].
pub fn add_formulas<'a, T: Float>(
    jobs: &mut Jobs,
    library: &Library,
    kernels: impl Iterator<Item = &'a Kernel>,
) -> Result<(), Error> {
    for kernel in kernels {
        let module = kernel.module;
        let cases = cases::<T>(kernel);
        let rows = cases.len() / kernel.inputs;
        let (shader, input) = (format!("wgsl/{module}"), format!("cases/{module}"));
        jobs.add_bytes(&shader, library.compose(module, T::PRECISION)?.source().as_bytes().to_vec());
        jobs.add_bytes(&input, bytemuck::cast_slice(&cases).to_vec());
        jobs.add(&Job {
            name: module,
            shader: &shader,
            entry: module.trim_start_matches("kernels/"),
            written: &[false, true],
            constants: BTreeMap::new(),
            contents: vec![json!(input), json!(rows * kernel.outputs.len() * size_of::<T>())],
            output: 1,
            invocations: rows,
        });
    }
    Ok(())
}

/// Returns the edge cases of a formula and then its random cases, row after row.
#[must_use]
pub fn cases<T: Float>(kernel: &Kernel) -> Vec<T> {
    let mut cases = kernel.edge_cases::<T>();
    cases.extend(kernel.random_cases::<T>(RANDOM, 7));
    cases
}

/// Returns the results of the cases in Rust, row after row.
#[must_use]
pub fn expected<T: Formulas>(kernel: &Kernel, cases: &[T]) -> Vec<T> {
    let mut results = vec![T::of(0.0); cases.len() / kernel.inputs * kernel.outputs.len()];
    for (case, result) in cases.chunks(kernel.inputs).zip(results.chunks_mut(kernel.outputs.len())) {
        T::formula(kernel)(case, result);
    }
    results
}
