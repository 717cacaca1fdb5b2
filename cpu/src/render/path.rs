//! The data of the paths of a span ([`PathTracer`]), and the rule by which a path continues or ends at a hit
//! ([`PathTracer::scatter`]).

use crate::render::{
    boxed::Boxed, limits::Ended, limits::Limits, max_depth::RaysLane, max_depth::RaysLeft, path_ends::PathEnds,
    path_vertex::PathVertex, prepared::Prepared, queue::PathQueue, surface_hit::SurfaceHit,
};
use crate::{
    accel::accelerator::ScatterTerms, accel::closest_hit::ClosestHit, geometry::ray::Ray, input::error::Error,
    layout::Layout, materials::prepared::BsdfKind, sampling::scatter_stream::ScatterSamples,
    simd::instruction_set::InstructionSet,
};

/// The next ray of a path: scattered by a matte or metal surface, or refracted.
pub struct Scattered {
    /// The next ray.
    pub ray: Ray,
    /// The terms of the ray's direction, or `None` if the ray was refracted.
    pub terms: Option<ScatterTerms>,
}

/// The data for tracing the paths of a span: the stream of scatter samples, the queue of paths, and the ends of the
/// paths.
#[derive(Debug)]
pub struct PathTracer {
    /// The stream of scatter samples.
    pub scatter_samples: ScatterSamples,
    /// The paths to trace.
    pub queue: PathQueue,
    /// The ends of the paths of the queue.
    pub ends: PathEnds,
    /// The limits of the picture.
    pub limits: Limits,
}

impl PathTracer {
    /// Returns the data before the first path, with the stream of scatter samples at its beginning. `set` is the
    /// instruction set that makes the samples: the one that renders the picture.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn new<L: Layout>(
        prepared: &Prepared<L>,
        set: InstructionSet,
        limits: &Limits,
    ) -> Result<Boxed<Self>, Error> {
        Boxed::new(|| Self {
            scatter_samples: ScatterSamples::new(prepared.scatter_stream, prepared.material_seed, set),
            queue: PathQueue::EMPTY,
            ends: PathEnds::new(limits.surfaces),
            limits: limits.clone(),
        })
    }

    /// Returns the reason why the picture ends before it is complete, or `None` if it goes on.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory was short for the surfaces of a path.
    pub(crate) fn ended(&mut self) -> Result<Option<Ended>, Error> {
        Ok(self.ends.check()?.or_else(|| self.limits.is_stopped().then_some(Ended::Stopped)))
    }

    /// Whether every path of the queue may send at least one ray.
    pub(crate) fn all_may_send_rays(&self) -> bool {
        let rays = &self.queue.entries.0[PathVertex::RAYS][..self.queue.count];
        !rays.iter().any(|&rays| RaysLane(rays).get().is_none())
    }

    /// Ends the path at index `at` of the queue at the maximum depth, on a matte or metal surface. The path is black,
    /// but the surface takes its scatter sample, so that the next surface gets the next one.
    #[inline(always)]
    pub(crate) fn end_at_max_depth(&mut self, at: usize) {
        self.scatter_samples.skip(1);
        self.ends.terminate(at, &mut self.queue);
    }

    /// Continues the path at index `at` of the queue at `hit`, and returns its next ray. `rays` is the number of rays
    /// that the path may still send. If there are none, or if the picture ends, the path ends in black, and the result
    /// is `None`. A matte or metal surface takes a scatter sample, even at the maximum depth.
    #[inline(always)]
    pub(crate) fn scatter<L: Layout>(
        &mut self,
        prepared: &Prepared<L>,
        (at, rays): (usize, RaysLeft),
        ray: &Ray,
        hit: &ClosestHit,
    ) -> Option<Scattered> {
        let Self { scatter_samples, queue, ends, .. } = self;
        if rays.pauses() && !rays.is_none() && self.limits.is_stopped() {
            ends.terminate(at, queue);
            return None;
        }
        if rays.is_none() {
            // Only the material of the surface is used, so LLVM removes the rest.
            let surface_hit = SurfaceHit::new(&prepared.objects, ray, hit);
            if prepared.materials[surface_hit.material as usize].takes_scatter_sample() {
                scatter_samples.prepare();
                self.end_at_max_depth(at);
            } else {
                ends.terminate(at, queue);
            }
            return None;
        }
        let surface_hit = SurfaceHit::new(&prepared.objects, ray, hit);
        let material = &prepared.materials[surface_hit.material as usize];
        let (origin, direction) =
            (surface_hit.point, material.unperturbed_direction(ray.direction, surface_hit.outward));
        if !material.takes_scatter_sample() {
            return Some(Scattered { ray: Ray { origin, direction }, terms: None });
        }
        if !ends.push_attenuation(at, surface_hit.material) {
            ends.terminate(at, queue);
            return None;
        }
        scatter_samples.prepare();
        let scatter_sample = scatter_samples.next();
        let ray = Ray { origin, direction: material.scatter_params.scatter_around(direction, scatter_sample) };
        let is_around_normal = material.bsdf_kind == BsdfKind::Matte;
        let terms = ScatterTerms { is_around_normal, vector: material.scatter_params.vector(scatter_sample) };
        Some(Scattered { ray, terms: Some(terms) })
    }
}
