//! One path, from the first surface that scatters to its end, and the stream that all paths share.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::find::Accelerator;
use crate::accel::object::ObjectId;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Layout;
use crate::materials::prepared::{BsdfKind, PreparedMaterial};
use crate::math::vec3::Vec3;
use crate::render::context::Context;
use crate::render::path_ends::PathEnds;
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::render::queue::PathQueue;
use crate::render::surface::{ScatterResult, Surface, material_of};
use crate::sampling::scatter_stream::ScatterSamples;

/// The ray that a surface scatters.
pub struct Scattered<'a> {
    pub ray: Ray,
    /// The prepared material and the random vector; `None` after refraction.
    cause: Option<(&'a PreparedMaterial, Vec3)>,
}

/// Traces paths; holds the stream of scatter samples, the queue and the ends of its paths.
#[derive(Debug)]
pub struct PathTracer {
    pub scatter_samples: ScatterSamples,
    pub queue: PathQueue,
    /// The paths of the queue that are done.
    pub ends: PathEnds,
    stack: Stack,
}

impl PathTracer {
    /// At the beginning of the stream.
    pub fn new<L: Layout>(prepared: &Prepared<L>) -> Box<Self> {
        Box::new(Self {
            scatter_samples: ScatterSamples::new(prepared.vectors, prepared.material_seed),
            queue: PathQueue::EMPTY,
            ends: PathEnds::new(),
            stack: Stack::EMPTY,
        })
    }

    /// Whether every path of the queue may send a ray.
    pub fn all_may_send_rays(&self) -> bool {
        self.queue.arrays[PathVertex::RAYS][..self.queue.count].iter().all(|rays| rays.to_bits() > 0)
    }

    /// Traces every path of the queue to its end.
    #[inline(always)]
    pub fn trace<'a, C: Context<'a>>(&mut self, context: &C) {
        for at in 0..self.queue.count {
            self.scatter_samples.prepare(context.simd());
            self.ends.begin();
            let scatter_sample = self.scatter_samples.next();
            let vertex = PathVertex::of(self.queue.get(at));
            if vertex.rays.to_bits() == 0 {
                self.ends.terminate(at, &mut self.queue);
            } else {
                self.trace_path(context, at, &vertex, scatter_sample);
            }
        }
    }

    /// Traces path `at` of the queue, which begins at `vertex`, to its end.
    #[inline(always)]
    fn trace_path<'a, C: Context<'a>>(&mut self, context: &C, at: usize, vertex: &PathVertex, scatter_sample: Vec3) {
        let (accel, objects) = (context.accel(), &context.prepared().objects);
        let mut ray = vertex.scattered_ray(scatter_sample);
        let mut rays = vertex.rays.to_bits();
        let mut origin = accel.origin(objects, &ray, vertex.object as ObjectId);
        loop {
            add(Counter::WalkRays, 1);
            let hit = accel.closest_hit_from::<C::Simd, _>(objects, &ray, origin, &mut self.stack);
            if !hit.is_hit() {
                return self.ends.escape(at, ray.direction);
            }
            rays -= 1;
            let Some(scattered) = self.scatter(context, at, rays, &ray, &hit) else {
                return;
            };
            origin = match scattered.cause {
                Some((material_data, vector)) => accel.next_origin(objects, &ray, &hit, material_data, vector),
                None => accel.origin(objects, &scattered.ray, hit.object),
            };
            ray = scattered.ray;
        }
    }

    /// Scatters path `at` at its hit, or terminates it if `rays`, how many more it may send, is 0.
    #[inline(always)]
    pub fn scatter<'a, C: Context<'a>>(
        &mut self,
        context: &C,
        at: usize,
        rays: u64,
        ray: &Ray,
        hit: &ClosestHit,
    ) -> Option<Scattered<'a>> {
        let (simd, prepared) = (context.simd(), context.prepared());
        let Self { scatter_samples, queue, ends, .. } = self;
        if rays == 0 {
            // At the maximum depth a surface that scatters takes its sample all the same.
            add(Counter::Hits, 1);
            let material = material_of(&prepared.objects, hit.object);
            if prepared.materials[material as usize].kind != BsdfKind::Refractive {
                scatter_samples.prepare(simd);
                scatter_samples.skip(1);
            }
            ends.terminate(at, queue);
            return None;
        }
        let surface = Surface::new(&prepared.objects, ray, hit);
        let material_data = &prepared.materials[surface.material as usize];
        match surface.scatter_result(material_data, ray.direction) {
            ScatterResult::Around(base) => {
                if !ends.push_attenuation(at, surface.material) {
                    ends.terminate(at, queue);
                    return None;
                }
                scatter_samples.prepare(simd);
                let scatter_sample = scatter_samples.next();
                let ray = Ray { origin: surface.point, direction: material_data.spread.around(base, scatter_sample) };
                Some(Scattered { ray, cause: Some((material_data, material_data.spread.vector(scatter_sample))) })
            }
            ScatterResult::Along(direction) => {
                Some(Scattered { ray: Ray { origin: surface.point, direction }, cause: None })
            }
        }
    }
}
