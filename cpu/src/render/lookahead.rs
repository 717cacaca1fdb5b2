//! Path tracing with few objects. The first rays of the next paths are tested ahead, several at once.
//!
//! Often half of all paths escape with their first ray. So the guess is that each of the next paths escapes at once.
//! Then each of them takes exactly one scatter sample, and the first rays of all of them can be tested at once. The
//! guess is right for the paths before the first one that may hit an object. The test also gives the objects that this
//! path may hit. The lanes after this path are computed again, because its hits may take more scatter samples.
//!
//! The intersections of one path depend on each other, so execution ports are idle meanwhile. Tests of the next paths
//! use these ports, so they take almost no time. After [many hits](MANY_HITS) paths are traced without them.
//!
//! If a ray is the last one that its path may send, and it certainly hits an object, the hit itself is not needed. The
//! path is black, and the surface takes one scatter sample. This is used only if no object is refractive.
//!
//! A path escapes only if the conservative test discards every object. The test discards no object if a number is NaN
//! or if the direction is too short.

use crate::render::{path::PathTracer, path_vertex::PathVertex, prepared::Prepared};
use crate::{
    accel::may_hit::conservative::is_too_short, accel::may_hit::object_lanes::MayHitLanes,
    accel::small_scene::SmallScene, accel::small_scene::closest_hit_among, counters::Counter, counters::add,
    geometry::ray::Ray, layout::Layout, math::vec3::Vec3, simd::Kernel, simd::Simd, simd::SimdF64,
};

/// If rays have hit a surface this many times since a path escaped, the paths are probably between mirrors or inside an
/// object, and will not escape with their next rays. So the next ray of a path is intersected with every object, and no
/// other path is tested ahead.
const MANY_HITS: usize = 4;

/// The first scattered rays of consecutive paths of the queue, one in each lane, with the objects that they may hit.
/// All paths take their scatter samples from one stream, so a ray depends on how many the paths before it take. The
/// rays are computed on the assumption that each path escapes with its first ray, and so takes one scatter sample. The
/// lanes after a path that does not escape are computed again.
#[derive(Clone, Copy)]
struct Lookahead<V: SimdF64> {
    /// The index of the first path in the queue.
    at: usize,
    /// The position, in the stream, of the scatter sample that the first path takes.
    position: u64,
    /// Number of lanes that hold a path.
    tested: usize,
    direction: Vec3<V>,
    /// The objects that each ray may hit.
    may_hit: MayHitLanes,
}

impl<V: SimdF64> Lookahead<V> {
    /// Tests the first rays of the paths from index `at` on, one in each lane. They use the next scatter samples, but
    /// do not take them.
    #[inline(always)]
    fn new(small_scene: &SmallScene, PathTracer { queue, scatter_samples, .. }: &PathTracer, at: usize) -> Self {
        let tested = V::LANES.min(queue.count - at);
        add(Counter::LookaheadRays, tested as u64);
        let PathVertex { point, unperturbed, scatter_params, .. } = PathVertex::of(queue.entries.load::<V>(at));
        let mut direction = unperturbed + scatter_params.vector(scatter_samples.peek::<V>());
        // If all components of a direction are negligible, the direction is too short. So only then the components need
        // to be checked.
        let short = V::bits(is_too_short(direction.dot(direction)));
        if short != 0 {
            let limit = scatter_params.negligible;
            let Vec3 { x, y, z } = direction;
            let is_negligible = x.abs().less(limit) & y.abs().less(limit) & z.abs().less(limit);
            direction = Vec3::select(is_negligible, unperturbed, direction);
        }
        let may_hit = small_scene.object_lanes.objects_may_hit_lanes(&Ray { origin: point, direction }, short);
        Self { at, position: scatter_samples.position(), tested, direction, may_hit }
    }

    /// Returns the number of paths before the first one that may hit an object. All these paths escape.
    #[inline(always)]
    fn escaping(&self) -> usize {
        (self.may_hit.any | u32::MAX << self.tested).trailing_zeros() as usize
    }
}

/// A kernel that traces every path of the queue to its end. Each of the paths must be allowed to send at least one ray.
pub struct TraceWithLookahead<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub tracer: &'a mut PathTracer,
    pub small_scene: &'a SmallScene,
    /// Number of hits since a path escaped. It counts no paths that escape with their first rays.
    pub hits: usize,
}

impl<L: Layout> Kernel for TraceWithLookahead<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(mut self, _: S) {
        debug_assert!(self.tracer.all_may_send_rays());
        self.tracer.scatter_samples.prepare();
        let mut lookahead = Lookahead::<S::F64>::new(self.small_scene, self.tracer, 0);
        let mut at = 0;
        while at < self.tracer.queue.count {
            let tracer = &mut *self.tracer;
            tracer.scatter_samples.prepare();
            if lookahead.at != at || lookahead.position != tracer.scatter_samples.position() {
                lookahead = Lookahead::new(self.small_scene, tracer, at);
            }
            let (escaping, tested, may_hit) = (lookahead.escaping(), lookahead.tested, lookahead.may_hit);
            tracer.ends.escape_several(at, lookahead.direction);
            tracer.scatter_samples.skip(escaping);
            add(Counter::PathRays, escaping as u64);
            at += escaping;
            if escaping < tested {
                tracer.scatter_samples.skip(1);
                add(Counter::PathRays, 1);
                self.trace(at, may_hit.of_lane(escaping), &mut lookahead);
                at += 1;
            }
        }
    }
}

impl<L: Layout> TraceWithLookahead<'_, L> {
    /// Traces the path at index `at` of the queue to its end. Its first ray may hit the objects whose bits are set in
    /// `may_hit`. For each ray, tests the first rays of the next paths, under the guess that this path escapes with
    /// that ray. The last of these tests is then in `if_escapes`.
    #[inline(always)]
    fn trace<V: SimdF64>(&mut self, at: usize, mut may_hit: u32, if_escapes: &mut Lookahead<V>) {
        let Self { prepared, tracer, small_scene, .. } = self;
        let vertex = PathVertex::of(tracer.queue.entries.get(at));
        let mut ray = Ray { origin: vertex.point, direction: tracer.ends.direction.get(at).into() };
        let mut rays = vertex.rays.get();
        loop {
            let hit = closest_hit_among(&prepared.objects, &ray, may_hit);
            if !hit.is_hit() {
                self.hits = 0;
                return tracer.ends.escape(at, ray.direction);
            }
            rays = rays.minus_one();
            let Some(scattered) = tracer.scatter(prepared, (at, rays), &ray, &hit) else {
                return;
            };
            ray = scattered.ray;
            add(Counter::PathRays, 1);
            tracer.scatter_samples.prepare();
            self.hits += 1;
            if self.hits < MANY_HITS {
                *if_escapes = Lookahead::new(small_scene, tracer, at + 1);
                may_hit = small_scene.objects_may_hit::<V, _>(&prepared.objects, &ray);
                // This is the most frequent case, so one branch decides it as early as possible.
                if may_hit == 0 {
                    self.hits = 0;
                    return tracer.ends.escape(at, ray.direction);
                }
            } else {
                may_hit = u32::MAX;
            }
            // If the last ray certainly hits, the object does not matter, because every material takes one scatter
            // sample.
            if rays.is_one() && prepared.scatters_everywhere && small_scene.starts_inside(&prepared.objects, &ray) {
                add(Counter::Hits, 1);
                add(Counter::LastRaysSkipped, 1);
                return tracer.end_at_max_depth(at);
            }
        }
    }
}
