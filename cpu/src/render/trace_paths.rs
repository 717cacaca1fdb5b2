//! Traces the paths one after the other, each from its first matte or metal surface on. The specification makes this
//! part sequential, because all paths take their scatter samples from one stream.
//!
//! With few objects (`accel/small_scene.rs`), [`lookahead`](crate::render::lookahead) replaces this loop, unless a path
//! of the queue is already at the maximum depth.

use crate::accel::{accelerator::Accelerator, choice::dispatch, stack::Stack};
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Layout;
use crate::math::vec3::Vec3;
use crate::render::{limits::PIECE, lookahead::TraceWithLookahead, path::PathTracer};
use crate::render::{path_vertex::PathVertex, prepared::Prepared, span_state::SpanState};
use crate::simd::{Kernel, Simd};

/// A kernel that traces every path of the queue to its end.
pub struct TracePaths<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>);

impl<L: Layout> Kernel for TracePaths<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let SpanState { prepared, tracer, stack, .. } = self.0;
        let prepared = *prepared;
        if let Some(small_scene) = prepared.accel.in_lanes()
            && !small_scene.uses_object_lanes()
            && tracer.all_may_send_rays()
        {
            let kernel = TraceWithLookahead { prepared, tracer, small_scene, hits: 0 };
            return if small_scene.looks_ahead_promptly() { simd.run_promptly(kernel) } else { simd.run(kernel) };
        }
        let is_prompt = prepared.accel.is_prompt(&prepared.objects);
        dispatch!(&prepared.accel, |accel| {
            let kernel = OneByOne { prepared, tracer, accel, stack };
            if is_prompt { simd.run_promptly(kernel) } else { simd.run(kernel) }
        });
    }
}

/// A kernel that traces the paths one after the other, without lookahead.
struct OneByOne<'a, L: Layout, A> {
    prepared: &'a Prepared<L>,
    tracer: &'a mut PathTracer,
    accel: &'a A,
    stack: &'a mut Stack,
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
                if vertex.rays.get().is_none() {
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
        let Self { prepared, tracer, accel, stack } = self;
        let objects = &prepared.objects;
        let direction = vertex.scatter_params.scatter_around(vertex.unperturbed, scatter_sample);
        let mut ray = Ray { origin: vertex.point, direction };
        let mut rays = vertex.rays.get();
        let mut start = accel.start(objects, &ray, vertex.object.id());
        loop {
            if A::MAY_BE_SLOW && tracer.limits.stops_every_ray() {
                return tracer.ends.terminate(at, &mut tracer.queue);
            }
            add(Counter::PathRays, 1);
            let hit = accel.closest_hit::<S, _>(objects, &ray, start, stack);
            if !hit.is_hit() {
                return tracer.ends.escape(at, ray.direction);
            }
            rays = rays.minus_one();
            let Some(scattered) = tracer.scatter(prepared, (at, rays), &ray, &hit) else {
                return;
            };
            start = match &scattered.terms {
                Some(terms) => accel.next_start(objects, &ray, &hit, terms),
                None => accel.start(objects, &scattered.ray, hit.object),
            };
            ray = scattered.ray;
        }
    }
}
