//! Runs one pixel with a trace of its calls, and reads the calls.

use std::marker::PhantomData;

use shaders::{CallTrace, Library};

use super::twins::{Twin, twin};
use crate::head::{Part, head};
use crate::pipeline::Content;
use crate::ray_loop::{MAX_ITERATIONS, RayLoop};
use crate::{Error, Float, Gpu, Picture, Pipeline};

/// Largest number of numbers of a trace. In f32 every whole number up to this one is exact, so the trace can hold its
/// own length.
const MOST_NUMBERS: u64 = 1 << 22;

/// A call of a function in WGSL.
#[derive(Clone, Debug, PartialEq)]
pub struct Call<T> {
    /// Index of the function in the list of the trace.
    pub function: usize,
    /// The depth of the call: 1 if it is not inside another recorded call.
    pub depth: usize,
    /// The numbers of the arguments.
    pub arguments: Vec<T>,
    /// The numbers of the result.
    pub results: Vec<T>,
}

/// A kernel that is compiled with a trace of its calls.
#[derive(Debug)]
pub struct Tracer<'a, T> {
    gpu: &'a Gpu,
    trace: CallTrace,
    pipeline: Pipeline,
    /// The twin of each function of the trace, if it has one.
    twins: Vec<Option<Twin<T>>>,
    /// Whether rays find their closest hit in a hierarchy of boxes.
    in_hierarchy: bool,
    precision: PhantomData<T>,
}

impl<'a, T: Float> Tracer<'a, T> {
    /// Compiles `kernel` from `library` with a trace.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn new(gpu: &'a Gpu, library: &Library, kernel: &str, constants: &[(&str, f64)]) -> Result<Self, Error> {
        let trace = library.compose(kernel, T::PRECISION)?.with_call_trace()?;
        let shipped = Library::standard().compose(kernel, T::PRECISION)?.with_call_trace()?.functions;
        let pipeline = Pipeline::new(gpu, &trace.composition, constants)?;
        // A function of the user with other parameters is not the twin's.
        let twins = trace.functions.iter().map(|function| {
            let is_same = |other: &&shaders::call_trace::Recorded| {
                other.name == function.name
                    && other.arguments.len() == function.arguments.len()
                    && other.results.len() == function.results.len()
            };
            shipped.iter().find(is_same).and_then(|function| twin(&function.name))
        });
        let twins = twins.collect();
        let in_hierarchy = library.has_hierarchy();
        Ok(Self { gpu, trace, pipeline, twins, in_hierarchy, precision: PhantomData })
    }

    /// Returns the trace's functions and text.
    pub const fn trace(&self) -> &CallTrace {
        &self.trace
    }

    /// Returns the trace's functions and text, without the compiled kernel.
    pub fn into_trace(self) -> CallTrace {
        self.trace
    }

    /// Returns the twin of the function at this index of the list of the trace, or `None` if it has none.
    pub fn twin(&self, function: usize) -> Option<Twin<T>> {
        self.twins[function]
    }

    /// Traces the path of the pixel at `index` in deterministic mode, and returns its calls and its linear colour.
    ///
    /// # Errors
    /// [`Error::TooManyIterations`] if the path needs more than one run, or the errors of [`Pipeline::run`].
    pub fn pixel(&self, picture: &Picture<T>, index: usize) -> Result<(Vec<Call<T>>, Vec<T>), Error> {
        let ray_loop = RayLoop::new(picture, self.in_hierarchy);
        if ray_loop.surfaces_of_a_run(picture.max_depth, 0)? < picture.max_depth {
            let objects = (picture.spheres.len() + picture.cylinders.len()) as u64;
            return Err(Error::TooManyIterations { objects, depth: picture.max_depth.into(), limit: MAX_ITERATIONS });
        }
        let head = head(picture, &Part::Pixels { first: index as u32, count: 1 }, &(0..picture.max_depth));
        let color = 3 * size_of::<T>() as u64;
        let own = [
            Content::Scratch(u64::from(picture.max_depth) * size_of::<u32>() as u64),
            Content::Output(color),
            Content::Scratch(2 * color + 2 * size_of::<u32>() as u64),
        ];
        self.run(&ray_loop.contents(Content::Input(&head), &own))
    }

    /// Runs one invocation. Returns its calls, and the numbers of the only output in `contents`.
    fn run(&self, contents: &[Content<'_>]) -> Result<(Vec<Call<T>>, Vec<T>), Error> {
        let room = MOST_NUMBERS.min(self.gpu.binding_limit() / size_of::<T>() as u64) * size_of::<T>() as u64;
        let contents = [contents, &[Content::Record(room)]].concat();
        let outputs = self.pipeline.run(self.gpu, &contents, 1)?.outputs;
        let numbers = |bytes: &[u8]| bytemuck::pod_collect_to_vec::<u8, T>(bytes);
        let [output, records] = &outputs[..] else { return Ok((Vec::new(), Vec::new())) };
        Ok((self.calls(&numbers(records)), numbers(output)))
    }

    /// Returns the calls that the buffer of the trace holds.
    fn calls(&self, records: &[T]) -> Vec<Call<T>> {
        let end = records.first().map_or(0, |end| end.wide() as usize).min(records.len());
        let mut rest = records.get(1..end).unwrap_or_default();
        let mut calls = Vec::new();
        while let [function, depth, numbers @ ..] = rest {
            let [function, depth] = [function, depth].map(|number| number.wide() as usize);
            let Some(recorded) = self.trace.functions.get(function) else { break };
            let (arguments, results) = (recorded.arguments.len(), recorded.results.len());
            let Some((arguments, numbers)) = numbers.split_at_checked(arguments) else { break };
            let Some((results, numbers)) = numbers.split_at_checked(results) else { break };
            calls.push(Call { function, depth, arguments: arguments.to_vec(), results: results.to_vec() });
            rest = numbers;
        }
        calls
    }
}
