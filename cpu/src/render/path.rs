//! What a path does at a hit ([`PathTracer::scatter`]), and the data that all paths share ([`PathTracer`]).

use crate::render::{
    boxed::Boxed, max_depth::RaysLeft, path_ends::PathEnds, path_vertex::PathVertex, prepared::Prepared,
    queue::PathQueue, surface::Surface,
};
use crate::{
    accel::bvh::stack::Stack, accel::closest_hit::ClosestHit, geometry::ray::Ray, input::error::Error, layout::Layout,
    materials::prepared::PreparedMaterial, math::vec3::Vec3, sampling::scatter_stream::ScatterSamples, simd::Simd,
};

/// The ray that a surface scatters.
pub struct Scattered<'a> {
    /// The ray.
    pub ray: Ray,
    /// The material and the random vector; `None` after refraction.
    pub cause: Option<(&'a PreparedMaterial, Vec3)>,
}

/// The data for tracing paths: the stream of scatter samples, the queue of paths, and the ends of the paths.
#[derive(Debug)]
pub struct PathTracer {
    /// The stream of scatter samples.
    pub scatter_samples: ScatterSamples,
    /// The paths to trace.
    pub queue: PathQueue,
    /// The paths of the queue that have ended.
    pub ends: PathEnds,
    /// Traversal stack of the acceleration structure.
    pub stack: Stack,
}

impl PathTracer {
    /// The data before the first path, at the beginning of the stream.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new<L: Layout>(prepared: &Prepared<L>) -> Result<Boxed<Self>, Error> {
        Boxed::new(Self {
            scatter_samples: ScatterSamples::new(prepared.scatter_stream, prepared.material_seed),
            queue: PathQueue::EMPTY,
            ends: PathEnds::new(),
            stack: Stack::EMPTY,
        })
    }

    /// Whether every path of the queue may send a ray.
    pub fn all_may_send_rays(&self) -> bool {
        let rays = &self.queue.entries.0[PathVertex::RAYS][..self.queue.count];
        !rays.iter().any(|&rays| RaysLeft::of_bits(rays).is_none())
    }

    /// Scatters path `at` at its hit and returns its next ray. At the maximum depth it terminates the path and returns
    /// `None`. `rays` is how many rays the path may send from here.
    #[inline(always)]
    pub fn scatter<'a, S: Simd, L: Layout>(
        &mut self,
        (simd, prepared): (S, &'a Prepared<L>),
        (at, rays): (usize, RaysLeft),
        ray: &Ray,
        hit: &ClosestHit,
    ) -> Option<Scattered<'a>> {
        let Self { scatter_samples, queue, ends, .. } = self;
        if rays.is_none() {
            // Only the material of the surface is used, so LLVM removes the rest.
            let surface = Surface::new(&prepared.objects, ray, hit);
            if prepared.materials[surface.material as usize].takes_scatter_sample() {
                scatter_samples.prepare(simd);
                scatter_samples.skip(1);
            }
            ends.terminate(at, queue);
            return None;
        }
        let surface = Surface::new(&prepared.objects, ray, hit);
        let material = &prepared.materials[surface.material as usize];
        let (origin, direction) = (surface.point, material.unperturbed_direction(ray.direction, surface.outward));
        if !material.takes_scatter_sample() {
            return Some(Scattered { ray: Ray { origin, direction }, cause: None });
        }
        if !ends.push_attenuation(at, surface.material) {
            ends.terminate(at, queue);
            return None;
        }
        scatter_samples.prepare(simd);
        let scatter_sample = scatter_samples.next();
        let ray = Ray { origin, direction: material.scatter_params.scatter_around(direction, scatter_sample) };
        Some(Scattered { ray, cause: Some((material, material.scatter_params.vector(scatter_sample))) })
    }
}
