//! Renders whole pictures on a device, in deterministic mode.

use std::marker::PhantomData;
use std::time::Duration;

use cpu::Size;
use cpu::Vec3;
use shaders::{Features, Library};

use crate::head::{Part, head};
use crate::pipeline::{Content, MAX_INVOCATIONS};
use crate::ray_loop::{RayLoop, steps};
use crate::{Error, Float, Gpu, Picture, Pipeline};

/// Largest number of pixels in one run. The device's limit on a binding may be lower.
pub(crate) const BATCH: u64 = 1 << 18;

/// Largest number of tests of a ray against an object in one run, if every path has the maximum depth. On a CPU that
/// acts as a GPU they take seconds. So a large scene is rendered in many runs, each run stays within its time limit,
/// and the program can report progress between them.
pub(crate) const TESTS: u64 = 1 << 28;

/// Smallest number of pixels in one run, unless a limit requires fewer. With fewer, most of a device would be idle.
pub(crate) const LEAST_BATCH: u64 = 1 << 10;

/// A pipeline that renders pictures in one precision, with one set of features.
#[derive(Debug)]
pub struct Renderer<'a, T> {
    gpu: &'a Gpu,
    pipeline: Pipeline,
    features: Features,
    /// Whether rays find their closest hit in a hierarchy of boxes.
    in_hierarchy: bool,
    precision: PhantomData<T>,
}

/// The linear colours of a picture, before they are converted to bytes.
#[derive(Clone, Debug)]
pub struct Rendering<T> {
    /// Number of columns and rows.
    pub size: Size,
    /// The colours, row by row from the top left.
    pub pixels: Vec<Vec3<T>>,
    /// The time that the device needed, without the transfers.
    pub time: Duration,
}

impl<'a, T: Float> Renderer<'a, T> {
    /// Compiles `kernels/image` from `library`, with the constants of `features`. `own` has the names and values of
    /// constants that a replaced module declares.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn new(gpu: &'a Gpu, library: &Library, features: &Features, own: &[(&str, f64)]) -> Result<Self, Error> {
        let composition = library.compose("kernels/image", T::PRECISION)?;
        let constants = [&features.constants()[..], own].concat();
        let pipeline = Pipeline::new(gpu, &composition, &constants)?;
        let in_hierarchy = library.has_hierarchy();
        Ok(Self { gpu, pipeline, features: *features, in_hierarchy, precision: PhantomData })
    }

    /// Renders `picture` with its maximum depth, or with that of the features of this renderer if it is less.
    ///
    /// # Errors
    /// The errors of [`Pipeline::run`], and [`Error::TooManyIterations`].
    pub fn render(&self, picture: &Picture<T>) -> Result<Rendering<T>, Error> {
        self.render_telling(picture, |_, _| ())
    }

    /// Renders as [`Self::render`] does. After each run it calls `tell` with the number of finished pixels and the
    /// number of all pixels.
    ///
    /// # Errors
    /// The errors of [`Self::render`].
    pub fn render_telling(&self, picture: &Picture<T>, mut tell: impl FnMut(u64, u64)) -> Result<Rendering<T>, Error> {
        let count = picture.size.pixels() as u64;
        let color = size_of::<Vec3<T>>() as u64;
        let path = u64::from(self.features.max_depth) * size_of::<u32>() as u64;
        // At least one pixel. If the path of one pixel is too long for a binding, the run returns an error.
        let ray_loop = RayLoop::new(picture, self.in_hierarchy);
        let tests = (ray_loop.tests() * u64::from(self.features.max_depth)).max(1);
        let batch = BATCH.min(MAX_INVOCATIONS).min(self.gpu.binding_limit() / color.max(path)).max(1);
        let batch = batch.min((TESTS / tests).max(LEAST_BATCH));
        // A pipeline for deeper paths renders a picture of less depth too.
        let depth = self.features.max_depth.min(picture.max_depth);
        let depths = steps(depth, ray_loop.surfaces_of_a_run(depth, 0)?);
        let mut rendering = Rendering { size: picture.size, pixels: Vec::new(), time: Duration::ZERO };
        for first in (0..count).step_by(batch as usize) {
            let pixels = batch.min(count - first);
            let part = Part::Pixels { first: first as u32, count: pixels as u32 };
            let heads: Vec<_> = depths.iter().map(|depths| head(picture, &part, depths)).collect();
            let own = [
                Content::Scratch(pixels * path),
                Content::Output(pixels * color),
                Content::Scratch(pixels * (2 * color + 2 * size_of::<u32>() as u64)),
            ];
            let contents = ray_loop.contents(Content::Inputs(&heads), &own);
            let run = self.pipeline.run(self.gpu, &contents, pixels)?;
            rendering.time += run.time;
            let numbers = bytemuck::pod_collect_to_vec::<u8, T>(&run.outputs.concat());
            rendering.pixels.extend(numbers.chunks(3).map(|rgb| Vec3::new(rgb[0], rgb[1], rgb[2])));
            tell(first + pixels, count);
        }
        Ok(rendering)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::buffer;

    fn structures_have_the_size_of_their_twins<T: Float>() {
        let composition = Library::standard().compose("kernels/image", T::PRECISION).expect("it exists");
        let shader = composition.validate().expect("it is valid");
        let size = |name| shader.size_of(name).expect("the structure exists") as usize;
        let text = "matte: a 1 1 1\nsphere: 0 0 0 1 a\ncylinder: 0 0 0 1 0 1 0 a\n";
        let scene = cpu::Scene::parse(text.as_bytes()).expect("it is valid");
        let picture = Picture::<T>::new(&cpu::Config::default(), &scene).expect("it is valid");
        assert_eq!(buffer(&picture.spheres).len(), size("PlacedSphere"));
        assert_eq!(buffer(&picture.cylinders).len(), size("PlacedCylinder"));
        assert_eq!(buffer(&picture.materials).len(), size("PackedMaterial"));
        assert_eq!(head(&picture, &Part::Pixels { first: 0, count: 1 }, &(0..5)).len(), size("Picture"));
        assert_eq!(size_of::<Vec3<T>>(), size("PackedVec3"));
        assert_eq!(2 * size_of::<Vec3<T>>() + 8, size("PackedPath"));
    }

    #[test]
    fn buffers_have_no_padding_in_either_precision() {
        structures_have_the_size_of_their_twins::<f32>();
        structures_have_the_size_of_their_twins::<f64>();
    }
}
