//! Path tracing with fewer than four objects: the first rays of the next paths are tested ahead, several at once.
//!
//! Half of all paths escape with their first ray. So the first rays of the next paths are tested as if each of them
//! escaped: then each takes the next sample of the stream. The paths before the first that may hit something have
//! escaped, and of that one it is known what it may hit. Lanes behind a wrong guess are computed again.
//!
//! A path's intersections wait for one another, so these tests beside them cost next to nothing. Where a ray is the
//! last that its path may send, and certainly hits something, the hit itself is not needed: its surface takes one
//! sample of the stream.
//!
//! A path escapes only if the conservative test rejects every object; a NaN and a very short direction are never
//! rejected.

use crate::accel::conservative::is_too_short;
use crate::accel::side_by_side::MayHitLanes;
use crate::accel::small_scene::{SmallScene, closest_hit_among};
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::math::vec3::Vec3;
use crate::render::context::Context;
use crate::render::path::PathTracer;
use crate::render::path_vertex::PathVertex;
use crate::render::queue::PathQueue;
use crate::sampling::scatter_stream::ScatterSamples;
use crate::simd::{LaneMask, Simd, SimdF64};

/// The lanes that a context is compiled for.
type LanesOf<'a, C> = <<C as Context<'a>>::Simd as Simd>::F64;

/// First rays of consecutive paths of the queue, one a lane, as if each of them escaped.
#[derive(Clone, Copy)]
struct Lookahead<V: SimdF64> {
    /// The first sample.
    at: usize,
    /// The position in the stream of the scatter sample that it takes.
    position: u64,
    /// How many lanes hold a sample.
    tested: usize,
    direction: Vec3<V>,
    /// What each ray may hit.
    may_hit: MayHitLanes,
}

impl<V: SimdF64> Lookahead<V> {
    /// No samples.
    #[inline(always)]
    fn nothing() -> Self {
        let direction = Vec3::splat(V::of(0.0));
        Self { at: usize::MAX, position: 0, tested: 0, direction, may_hit: MayHitLanes::NOTHING }
    }

    /// The samples from `at` on.
    #[inline(always)]
    fn look(small_scene: &SmallScene, PathTracer { queue, scatter_samples, .. }: &PathTracer, at: usize) -> Self {
        let (rays, short) = first_rays::<V>(queue, scatter_samples, at);
        let tested = V::LANES.min(queue.count - at);
        add(Counter::Guesses, tested as u64);
        Self {
            at,
            position: scatter_samples.position(),
            tested,
            direction: rays.direction,
            may_hit: small_scene.objects_may_hit_lanes(&rays, short),
        }
    }

    /// Whether it begins with the sample `at` and the scatter sample at `position`.
    #[inline(always)]
    fn is_of(&self, at: usize, position: u64) -> bool {
        self.at == at && self.position == position
    }

    /// How many samples escape before the first that may hit something.
    #[inline(always)]
    fn escaping(&self) -> usize {
        (self.may_hit.any() | u32::MAX << self.tested).trailing_zeros() as usize
    }
}

/// Traces every path of the queue, each of which may send a ray, to its end.
#[inline(always)]
pub fn trace<'a, C: Context<'a, Accel = SmallScene>>(context: &C, tracer: &mut PathTracer) {
    let (simd, small_scene) = (context.simd(), context.accel());
    let mut ahead = Lookahead::<LanesOf<'a, C>>::nothing();
    let mut at = 0;
    while at < tracer.queue.count {
        tracer.scatter_samples.prepare(simd);
        if !ahead.is_of(at, tracer.scatter_samples.position()) {
            ahead = Lookahead::look(small_scene, tracer, at);
        }
        let (escaping, tested, may_hit) = (ahead.escaping(), ahead.tested, ahead.may_hit);
        tracer.ends.escape_several(at, ahead.direction);
        tracer.scatter_samples.skip(escaping);
        add(Counter::WalkRays, escaping as u64);
        at += escaping;
        if escaping < tested {
            tracer.scatter_samples.skip(1);
            add(Counter::WalkRays, 1);
            trace_path(context, tracer, at, may_hit.by(escaping), &mut ahead);
            at += 1;
        }
    }
}

/// Traces path `at` of the queue to its end, from its first ray on, which may hit the objects of `may_hit`. Tests the
/// first rays of the paths behind it meanwhile.
#[inline(always)]
fn trace_path<'a, C: Context<'a, Accel = SmallScene>>(
    context: &C,
    tracer: &mut PathTracer,
    at: usize,
    mut may_hit: u32,
    if_escapes: &mut Lookahead<LanesOf<'a, C>>,
) {
    let (prepared, small_scene) = (context.prepared(), context.accel());
    let vertex = PathVertex::of(tracer.queue.get(at));
    let mut ray = Ray { origin: vertex.point, direction: tracer.ends.direction.get(at) };
    let mut rays = vertex.rays.to_bits();
    loop {
        let hit = closest_hit_among(&prepared.objects, &ray, may_hit);
        if !hit.is_hit() {
            return tracer.ends.escape(at, ray.direction);
        }
        rays -= 1;
        let Some(scattered) = tracer.scatter(context, at, rays, &ray, &hit) else {
            return;
        };
        ray = scattered.ray;
        add(Counter::WalkRays, 1);
        tracer.scatter_samples.prepare(context.simd());
        *if_escapes = Lookahead::look(small_scene, tracer, at + 1);
        may_hit = small_scene.objects_may_hit::<LanesOf<'a, C>, _>(&prepared.objects, &ray);
        // One branch for the commonest answer, as early as it can be known.
        if may_hit == 0 {
            return tracer.ends.escape(at, ray.direction);
        }
        // On a certain hit by the last ray the object does not matter: every material takes one sample.
        if rays == 1 && prepared.scatters_everywhere && small_scene.starts_inside(&prepared.objects, &ray) {
            add(Counter::Hits, 1);
            add(Counter::LastRaysSpared, 1);
            tracer.scatter_samples.skip(1);
            return tracer.ends.terminate(at, &mut tracer.queue);
        }
    }
}

/// The first rays of the samples from `at` on, which take the next scatter samples; and the lanes whose directions are
/// too short for the filter, as bits.
#[inline(always)]
fn first_rays<V: SimdF64>(queue: &PathQueue, scatter_samples: &ScatterSamples, at: usize) -> (Ray<V>, u32) {
    let PathVertex { point, base, scatter_params, .. } = PathVertex::of(queue.load::<V>(at));
    let mut direction = base + scatter_params.vector(scatter_samples.following::<V>());
    // A direction whose components are all negligible is shorter still.
    let short = is_too_short(direction.dot(direction)).bits();
    if short != 0 {
        let limit = scatter_params.negligible;
        let negligible = direction.x.abs().less(limit) & direction.y.abs().less(limit) & direction.z.abs().less(limit);
        direction = Vec3::select(negligible, base, direction);
    }
    (Ray { origin: point, direction }, short)
}
