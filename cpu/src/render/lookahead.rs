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
use crate::layout::Layout;
use crate::math::vec3::Vec3;
use crate::render::path::PathTracer;
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::render::queue::PathQueue;
use crate::sampling::scatter_stream::ScatterSamples;
use crate::simd::{LaneMask, Simd, SimdF64};

/// First rays of consecutive paths of the queue, one a lane, as if each of them escaped.
#[derive(Clone, Copy)]
struct Lookahead<V: SimdF64> {
    /// The first sample.
    at: usize,
    /// Where in the stream the triple stands that it takes.
    position: u64,
    /// How many samples there are.
    tried: usize,
    direction: Vec3<V>,
    touched: MayHitLanes,
}

impl<V: SimdF64> Lookahead<V> {
    /// No samples.
    #[inline(always)]
    fn nothing() -> Self {
        let direction = Vec3::splat(V::of(0.0));
        Self { at: usize::MAX, position: 0, tried: 0, direction, touched: MayHitLanes::NOTHING }
    }

    /// The samples from `at` on.
    #[inline(always)]
    fn look(few: &SmallScene, PathTracer { queue, scatter_samples, .. }: &PathTracer, at: usize) -> Self {
        let (rays, short) = first_rays::<V>(queue, scatter_samples, at);
        let tried = V::LANES.min(queue.count - at);
        add(Counter::Guesses, tried as u64);
        Self {
            at,
            position: scatter_samples.position(),
            tried,
            direction: rays.direction,
            touched: few.objects_may_hit_lanes(&rays, short),
        }
    }

    /// Whether it begins with the sample `at` and the triple at `position`.
    #[inline(always)]
    fn is_of(&self, at: usize, position: u64) -> bool {
        self.at == at && self.position == position
    }

    /// How many samples leave before one that may meet something.
    #[inline(always)]
    fn leaving(&self) -> usize {
        (self.touched.any() | u32::MAX << self.tried).trailing_zeros() as usize
    }
}

/// Follows every waiting sample, each of which may send a ray, to its end.
#[inline(always)]
pub fn trace<S: Simd, L: Layout>(prepared: &Prepared<L>, few: &SmallScene, walk: &mut PathTracer, simd: S) {
    let mut ahead = Lookahead::<S::F64>::nothing();
    let mut at = 0;
    while at < walk.queue.count {
        walk.scatter_samples.prepare(simd);
        if !ahead.is_of(at, walk.scatter_samples.position()) {
            ahead = Lookahead::look(few, walk, at);
        }
        let (left, tried, touched) = (ahead.leaving(), ahead.tried, ahead.touched);
        walk.ends.escape_several(at, ahead.direction);
        walk.scatter_samples.skip(left);
        add(Counter::WalkRays, left as u64);
        at += left;
        if left < tried {
            walk.scatter_samples.skip(1);
            add(Counter::WalkRays, 1);
            trace_path(prepared, few, walk, simd, at, touched.by(left), &mut ahead);
            at += 1;
        }
    }
}

/// Traces path `at` of the queue to its end, from its first ray on, which may hit the objects of `touched`. Tests the
/// first rays of the paths behind it meanwhile.
#[inline(always)]
fn trace_path<S: Simd, L: Layout>(
    prepared: &Prepared<L>,
    few: &SmallScene,
    walk: &mut PathTracer,
    simd: S,
    at: usize,
    mut touched: u32,
    if_it_leaves: &mut Lookahead<S::F64>,
) {
    let vertex = PathVertex::of(walk.queue.get(at));
    let mut ray = Ray { origin: vertex.point, direction: walk.ends.direction.get(at) };
    let mut rays = vertex.rays.to_bits();
    loop {
        let found = closest_hit_among(&prepared.objects, &ray, touched);
        if !found.is_hit() {
            return walk.ends.escape(at, ray.direction);
        }
        rays -= 1;
        let Some(sent) = walk.scatter(prepared, simd, at, rays, &ray, &found) else {
            return;
        };
        ray = sent.ray;
        add(Counter::WalkRays, 1);
        walk.scatter_samples.prepare(simd);
        *if_it_leaves = Lookahead::look(few, walk, at + 1);
        touched = few.objects_may_hit::<S::F64, _>(&prepared.objects, &ray);
        // One branch for the commonest answer, as early as it can be known.
        if touched == 0 {
            return walk.ends.escape(at, ray.direction);
        }
        // On a certain hit by the last ray the object does not matter: every material takes one sample.
        if rays == 1 && prepared.scatters_everywhere && few.starts_inside(&prepared.objects, &ray) {
            add(Counter::Hits, 1);
            add(Counter::LastRaysSpared, 1);
            walk.scatter_samples.skip(1);
            return walk.ends.terminate(at, &mut walk.queue);
        }
    }
}

/// The first rays of the samples from `at` on, which take the next triples; and the lanes whose directions are too
/// short for the filter, as bits.
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
