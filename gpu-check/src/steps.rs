//! Records a pixel's path step by step, on a device and in Rust, to find the first difference. A step is one ray and
//! its hit.

use std::marker::PhantomData;

use shaders::{Features, Library};
pub use twin::steps::{NAMES, Step, first_difference};

use crate::head::{Part, head};
use crate::packed::buffer;
use crate::pipeline::{Content, MAX_INVOCATIONS};
use crate::renderer::{BATCH, MAX_ITERATIONS};
use crate::{Error, Float, Gpu, Picture, Pipeline};

/// Returns an error when the paths through a scene of `objects` objects, to the maximum depth `depth`, take more
/// iterations than one run may have.
///
/// # Errors
/// [`Error::TooManyIterations`].
pub fn check_iterations(objects: usize, depth: u32) -> Result<(), Error> {
    let (objects, depth) = (objects as u64, u64::from(depth));
    if (objects + 1) * depth > MAX_ITERATIONS {
        return Err(Error::TooManyIterations { objects, depth, limit: MAX_ITERATIONS });
    }
    Ok(())
}

/// A pipeline that records the steps of pixels on a device.
#[derive(Debug)]
pub struct Follower<'a, T> {
    gpu: &'a Gpu,
    pipeline: Pipeline,
    depth: u32,
    precision: PhantomData<T>,
}

impl<'a, T: Float> Follower<'a, T> {
    /// Compiles `kernels/steps` from `library`. The number of recorded steps is the maximum depth of `features`. `own`
    /// has the names and values of constants that a replaced module declares.
    ///
    /// # Errors
    /// The errors of [`Pipeline::with_constants`].
    pub fn new(gpu: &'a Gpu, library: &Library, features: &Features, own: &[(&str, f64)]) -> Result<Self, Error> {
        let composition = library.compose("kernels/steps", T::PRECISION)?;
        let constants = [&features.constants()[..], own].concat();
        let pipeline = Pipeline::with_constants(gpu, &composition, &constants)?;
        Ok(Self { gpu, pipeline, depth: features.max_depth, precision: PhantomData })
    }

    /// Records the steps of `count` pixels, from the pixel `first`. Calls `each` with the index and the steps of each
    /// pixel.
    ///
    /// # Errors
    /// [`Error::TooManyIterations`] if the paths need more than one run, or the errors of [`Pipeline::run`].
    pub fn follow(
        &self,
        picture: &Picture<T>,
        first: usize,
        count: usize,
        mut each: impl FnMut(usize, &[Step<T>]),
    ) -> Result<(), Error> {
        check_iterations(picture.spheres.len() + picture.cylinders.len(), self.depth)?;
        let depth = u64::from(self.depth);
        if depth == 0 {
            (first..first + count).for_each(|pixel| each(pixel, &[]));
            return Ok(());
        }
        let [spheres, cylinders] = [buffer(&picture.spheres), buffer(&picture.cylinders)];
        let materials = buffer(&picture.materials);
        let row = depth * size_of::<Step<T>>() as u64;
        let batch = BATCH.min(MAX_INVOCATIONS).min(self.gpu.binding_limit() / row).max(1) as usize;
        for start in (first..first + count).step_by(batch) {
            let pixels = batch.min(first + count - start);
            let part = Part::Pixels { first: start as u32, count: pixels as u32 };
            let head = head(picture, &part, &(0..self.depth));
            let contents = [
                Content::Input(&head),
                Content::Input(&spheres),
                Content::Input(&cylinders),
                Content::Input(&materials),
                // The attenuations, which this kernel does not use.
                Content::Scratch(0),
                Content::Output(pixels as u64 * row),
            ];
            let run = self.pipeline.run(self.gpu, &contents, pixels as u64)?;
            let numbers = bytemuck::pod_collect_to_vec::<u8, T>(&run.outputs.concat());
            let steps: Vec<_> = numbers.chunks_exact(NAMES.len()).map(to_step).collect();
            for (pixel, steps) in (start..).zip(steps.chunks_exact(self.depth as usize)) {
                each(pixel, steps);
            }
        }
        Ok(())
    }
}

fn to_step<T: Float>(numbers: &[T]) -> Step<T> {
    let mut step = [T::of(0.0); NAMES.len()];
    step.copy_from_slice(numbers);
    Step(step)
}
