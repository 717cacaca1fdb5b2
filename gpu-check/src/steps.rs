//! Records a pixel's path step by step, on a device and in Rust, to find the first difference. A step is one ray and
//! its hit.

use std::marker::PhantomData;

use shaders::{Features, Library};
pub use twin::steps::{NAMES, Step, first_difference};

use crate::head::{Part, head};
use crate::pipeline::Content;
use crate::ray_loop::{RayLoop, steps};
use crate::{Error, Float, Gpu, Picture, Pipeline};

/// A pipeline that records the steps of pixels on a device.
#[derive(Debug)]
pub struct Follower<'a, T> {
    gpu: &'a Gpu,
    pipeline: Pipeline,
    depth: u32,
    in_hierarchy: bool,
    precision: PhantomData<T>,
}

impl<'a, T: Float> Follower<'a, T> {
    /// Compiles `kernels/steps` from `library`. The number of recorded steps is the maximum depth of `features`. `own`
    /// has the names and values of constants that a replaced module declares.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn new(gpu: &'a Gpu, library: &Library, features: &Features, own: &[(&str, f64)]) -> Result<Self, Error> {
        let composition = library.compose("kernels/steps", T::PRECISION)?;
        let constants = [&features.constants()[..], own].concat();
        let pipeline = Pipeline::new(gpu, &composition, &constants)?;
        let in_hierarchy = library.has_hierarchy();
        Ok(Self { gpu, pipeline, depth: features.max_depth, in_hierarchy, precision: PhantomData })
    }

    /// Returns the steps of `count` pixels, from the pixel `first` on.
    ///
    /// # Errors
    /// [`Error::TooManyIterations`] if one surface already takes too many, or the errors of [`Pipeline::run`]. In a
    /// hierarchy, [`Error::Unwritten`] if a ray visits too many nodes.
    pub fn follow(&self, picture: &Picture<T>, first: usize, count: usize) -> Result<Vec<Vec<Step<T>>>, Error> {
        if self.depth == 0 {
            return Ok(vec![Vec::new(); count]);
        }
        let ray_loop = RayLoop::new(picture, self.in_hierarchy);
        let depths = steps(self.depth, ray_loop.surfaces_of_a_run(self.depth, 0)?);
        let part = Part::Pixels { first: first as u32, count: count as u32 };
        let heads: Vec<_> = depths.iter().map(|depths| head(picture, &part, depths)).collect();
        let output = Content::Output((count * self.depth as usize * size_of::<Step<T>>()) as u64);
        // This kernel does not use the attenuations.
        let contents = ray_loop.contents(Content::Inputs(&heads), &[Content::Scratch(0), output]);
        let run = self.pipeline.run(self.gpu, &contents, count as u64)?;
        let numbers = bytemuck::pod_collect_to_vec::<u8, T>(&run.outputs.concat());
        let steps: Vec<_> = numbers.chunks_exact(NAMES.len()).map(to_step).collect();
        Ok(steps.chunks_exact(self.depth as usize).map(<[_]>::to_vec).collect())
    }
}

fn to_step<T: Float>(numbers: &[T]) -> Step<T> {
    let mut step = [T::of(0.0); NAMES.len()];
    step.copy_from_slice(numbers);
    Step(step)
}
