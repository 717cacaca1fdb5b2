//! Finds the closest hits of given rays on a device, to compare the hierarchy with the loop over all objects.

use cpu::Ray;
use shaders::{Features, Library};

use crate::head::{Part, head};
use crate::packed::Packed;
use crate::pipeline::Content;
use crate::ray_loop::RayLoop;
use crate::{Error, Float, Gpu, Picture, Pipeline};

/// Largest number of rays in one run.
const BATCH: usize = 1 << 16;

/// Returns lambda, order and part of each ray's closest hit among the objects of `picture`, or three times minus one.
/// `library` decides whether the rays use a hierarchy.
///
/// # Errors
/// The errors of [`Pipeline::new`] and [`Pipeline::run`].
pub fn closest_hits<T: Float>(
    gpu: &Gpu,
    library: &Library,
    picture: &Picture<T>,
    rays: &[Ray<T>],
) -> Result<Vec<[T; 3]>, Error> {
    let composition = library.compose("kernels/rays", T::PRECISION)?;
    // The kernel has no materials, so it declares only some of the constants.
    let constants = Features::all(1).constants();
    let pipeline = Pipeline::new(gpu, &composition, &constants)?;
    let ray_loop = RayLoop::new(picture, library.has_hierarchy());
    let mut hits = Vec::with_capacity(rays.len());
    for rays in rays.chunks(BATCH) {
        let mut paths = Vec::new();
        for ray in rays {
            ray.origin.pack(&mut paths);
            ray.direction.pack(&mut paths);
            [0_u32; 2].iter().for_each(|number| number.pack(&mut paths));
        }
        let head = head(picture, &Part::Pixels { first: 0, count: rays.len() as u32 }, &(0..1));
        let own =
            [Content::Scratch(0), Content::Output((3 * rays.len() * size_of::<T>()) as u64), Content::Input(&paths)];
        let run = pipeline.run(gpu, &ray_loop.contents(Content::Input(&head), &own), rays.len() as u64)?;
        let numbers = bytemuck::pod_collect_to_vec::<u8, T>(&run.outputs.concat());
        hits.extend(numbers.chunks(3).map(|hit| [hit[0], hit[1], hit[2]]));
    }
    Ok(hits)
}
