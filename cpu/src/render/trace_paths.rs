//! Traces the paths one after the other, each from its first matte or metal surface on. The specification makes this
//! part sequential, because all paths take their scatter samples from one stream.
//!
//! With fewer than four objects, [`lookahead`](crate::render::lookahead) replaces this loop, unless a path of the queue
//! is already at the maximum depth.

use crate::accel::object::ObjectId;
use crate::accel::{choice::Accel, every_object::EveryObject, find::Accelerator};
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::math::vec3::Vec3;
use crate::render::{limits::PIECE, lookahead::TraceWithLookahead, max_depth::RaysLeft, path::PathTracer};
use crate::render::{path_vertex::PathVertex, prepared::Prepared, span_state::SpanState};
use crate::simd::{Kernel, Simd};

/// A kernel that traces every path of the queue to its end.
pub struct TracePaths<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>);

impl<L: Layout> Kernel for TracePaths<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let SpanState { prepared, tracer, .. } = self.0;
        let prepared = *prepared;
        // The loop is compiled once for each structure. With many objects, the width of the lanes matters more than the
        // latency of comparisons.
        match &prepared.accel {
            Accel::EveryObject => simd.run_promptly(OneByOne { prepared, tracer, accel: &EveryObject }),
            Accel::SmallScene(accel) if !accel.uses_object_lanes() && tracer.all_may_send_rays() => {
                simd.run_promptly(TraceWithLookahead { prepared, tracer, small_scene: accel });
            }
            Accel::SmallScene(accel) => simd.run_promptly(OneByOne { prepared, tracer, accel }),
            Accel::FlatFilter(accel) => simd.run(OneByOne { prepared, tracer, accel }),
            Accel::Bvh(accel) => simd.run(OneByOne { prepared, tracer, accel }),
            Accel::LargeBvh(accel) => simd.run(OneByOne { prepared, tracer, accel }),
        }
    }
}

/// A kernel that traces the paths one after the other, without lookahead.
struct OneByOne<'a, L: Layout, A> {
    prepared: &'a Prepared<L>,
    tracer: &'a mut PathTracer,
    accel: &'a A,
}

impl<L: Layout, A: Accelerator> Kernel for OneByOne<'_, L, A> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(mut self, _: S) {
        let count = self.tracer.queue.count;
        for from in (0..count).step_by(PIECE) {
            // The rest of the paths stays as it is, because the picture ends after this span.
            if self.tracer.limits.is_stopped() {
                return;
            }
            for at in from..count.min(from + PIECE) {
                self.tracer.scatter_samples.prepare();
                self.tracer.ends.begin();
                let vertex = PathVertex::of(self.tracer.queue.entries.get(at));
                if RaysLeft::of_bits(vertex.rays).is_none() {
                    self.tracer.end_at_max_depth(at);
                } else {
                    let scatter_sample = self.tracer.scatter_samples.next();
                    self.trace::<S>(at, &vertex, scatter_sample);
                }
            }
        }
    }
}

impl<L: Layout, A: Accelerator> OneByOne<'_, L, A> {
    /// Traces the path at index `at` of the queue to its end. The path begins at `vertex`, and `scatter_sample` gives
    /// its first ray.
    #[inline(always)]
    fn trace<S: Simd>(&mut self, at: usize, vertex: &PathVertex, scatter_sample: Vec3) {
        let Self { prepared, tracer, accel } = self;
        let objects = &prepared.objects;
        let mut ray = vertex.scattered_ray(scatter_sample);
        let mut rays = RaysLeft::of_bits(vertex.rays);
        let mut origin = accel.origin(objects, &ray, vertex.object as ObjectId);
        loop {
            if A::MAY_BE_SLOW && tracer.limits.stops_every_ray() {
                return tracer.ends.terminate(at, &mut tracer.queue);
            }
            add(Counter::PathRays, 1);
            let hit = accel.closest_hit::<S, _>(objects, &ray, origin, &mut tracer.stack);
            if !hit.is_hit() {
                return tracer.ends.escape(at, ray.direction);
            }
            rays = rays.minus_one();
            let Some(scattered) = tracer.scatter(prepared, (at, rays), &ray, &hit) else {
                return;
            };
            origin = match scattered.cause {
                Some((material, vector)) => accel.next_origin(objects, &ray, &hit, material, vector),
                None => accel.origin(objects, &scattered.ray, hit.object),
            };
            ray = scattered.ray;
        }
    }
}
