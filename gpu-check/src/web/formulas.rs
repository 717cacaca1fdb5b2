//! The jobs that compute every formula in f32, with the results that Rust has.

use shaders::{Library, Precision};

use super::jobs::{Job, Jobs};
use crate::kernels::KERNELS;
use crate::{Error, Formulas, Kernel};

/// Number of random cases of each formula. They follow its edge cases.
const RANDOM: usize = 1 << 14;

/// Adds a job for each kernel, which computes the formula for all its [`cases`]. Its name is that of the module.
///
/// # Errors
/// The errors of [`Library::compose`].
pub fn add_formulas(jobs: &mut Jobs) -> Result<(), Error> {
    let library = Library::standard();
    for kernel in &KERNELS {
        let module = kernel.module;
        let cases = cases(kernel);
        let rows = cases.len() / kernel.inputs;
        let (shader, input) = (format!("wgsl/{module}"), format!("cases/{module}"));
        jobs.add_bytes(&shader, library.compose(module, Precision::F32)?.source().as_bytes().to_vec());
        jobs.add_bytes(&input, bytemuck::cast_slice(&cases).to_vec());
        jobs.add(&Job {
            name: module,
            shader: &shader,
            entry: module.trim_start_matches("kernels/"),
            written: &[false, true],
            constants: "{}",
            contents: &format!("[{input:?}, {}]", rows * kernel.outputs.len() * size_of::<f32>()),
            output: 1,
            invocations: rows,
        });
    }
    Ok(())
}

/// Returns the edge cases of a formula and then its random cases, row after row.
#[must_use]
pub fn cases(kernel: &Kernel) -> Vec<f32> {
    let mut cases = kernel.edge_cases::<f32>();
    cases.extend(kernel.random_cases::<f32>(RANDOM, 7));
    cases
}

/// Returns the results of the cases in Rust's f32, row after row.
#[must_use]
pub fn expected(kernel: &Kernel, cases: &[f32]) -> Vec<f32> {
    let mut results = vec![0.0; cases.len() / kernel.inputs * kernel.outputs.len()];
    for (case, result) in cases.chunks(kernel.inputs).zip(results.chunks_mut(kernel.outputs.len())) {
        f32::formula(kernel)(case, result);
    }
    results
}
