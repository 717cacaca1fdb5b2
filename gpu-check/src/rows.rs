//! Runs kernels that turn each case, a row of inputs, into a row of outputs.

use std::time::Duration;

use crate::pipeline::{Content, MAX_INVOCATIONS};
use crate::{Error, Float, Gpu, Pipeline};

/// Largest number of cases in one run. The device's limit on a binding may be lower.
const BATCH: u64 = 1 << 18;

/// Runs a kernel for `cases`. Returns all results in one list, in the order of the cases, and how long the device
/// computed, without the transfers. A case has `inputs` numbers, and a result has `outputs` numbers. The buffers of
/// each run are as large as the device can bind.
///
/// # Errors
/// The errors of [`Pipeline::run`].
pub fn results<T: Float>(
    gpu: &Gpu,
    pipeline: &Pipeline,
    [inputs, outputs]: [usize; 2],
    cases: &[T],
) -> Result<(Vec<T>, Duration), Error> {
    let width = inputs.max(outputs) * size_of::<T>();
    let batch = BATCH.min(gpu.binding_limit() / width as u64).min(MAX_INVOCATIONS) as usize;
    let mut results = Vec::with_capacity(cases.len() / inputs * outputs);
    let mut time = Duration::ZERO;
    for cases in cases.chunks(batch * inputs) {
        let rows = cases.len() / inputs;
        let output = (rows * outputs * size_of::<T>()) as u64;
        let contents = [Content::Input(bytemuck::cast_slice(cases)), Content::Output(output)];
        let run = pipeline.run(gpu, &contents, rows as u64)?;
        time += run.time;
        for bytes in run.outputs {
            results.extend(bytemuck::pod_collect_to_vec::<u8, T>(&bytes));
        }
    }
    Ok((results, time))
}
