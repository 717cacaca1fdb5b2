//! The walk where objects are two or three: beside every ray the samples that come next, several at once.
//!
//! Half of all paths leave with their first ray after a surface that scatters. So the first rays of the next samples are
//! tried as if each of them left: then each takes the next triple of the stream. Those before the first that may meet
//! something have left, and of that one it is known what it may meet. What was guessed wrong behind it is tried again.
//!
//! They are tried beside the ray before them, as if that left as well: what a ray meets takes the processor long to find
//! out, but little of what it can do at a time. Where the ray is the last that its path may send, they are also tried as
//! if it met something: then its surface takes one triple more, and nothing else. Where it is certain that it meets something,
//! nobody asks what.
//!
//! A sample leaves only where the filter stops its ray, and the filter keeps every ray that it cannot judge: directions that
//! are too short for it, and what is not a number.

use super::path::Walk;
use super::queue::Queue;
use super::vectors::Triples;
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::ray::Ray;
use crate::search::{Few, TouchedByEach, is_too_short, nearest_of};
use crate::simd::{LaneMask, Lanes, Simd};
use crate::vec3::Vec3;

/// The first rays of the samples of the queue from one on, a lane each, as if each of them left.
#[derive(Clone, Copy)]
struct Ahead<V: Lanes> {
    /// The first sample.
    at: usize,
    /// Where in the stream the triple stands that it takes.
    position: u64,
    /// How many samples there are.
    tried: usize,
    direction: Vec3<V>,
    touched: TouchedByEach,
}

impl<V: Lanes> Ahead<V> {
    /// No samples.
    #[inline(always)]
    fn nothing() -> Self {
        let direction = Vec3::splat(V::of(0.0));
        Self { at: usize::MAX, position: 0, tried: 0, direction, touched: TouchedByEach::NOTHING }
    }

    /// The samples from `at` on, if `skipped` triples are used up before.
    #[inline(always)]
    fn look(few: &Few, Walk { queue, triples, .. }: &Walk, at: usize, skipped: usize) -> Self {
        let (rays, short) = first_rays::<V>(queue, triples, at, skipped);
        let position = triples.position().wrapping_add(skipped as u64);
        let tried = V::LANES.min(queue.count - at);
        add(Counter::Guesses, tried as u64);
        Self { at, position, tried, direction: rays.direction, touched: few.touched_by_each(&rays, short) }
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
pub fn follow<V: Lanes, W: Simd, L: Layout>(prepared: &Prepared<L>, few: &Few, walk: &mut Walk, wide: W) {
    let mut aheads = [Ahead::<V>::nothing(); 2];
    let mut at = 0;
    while at < walk.queue.count {
        walk.triples.prepare(wide);
        let position = walk.triples.position();
        let which = usize::from(aheads[1].is_of(at, position));
        if !aheads[which].is_of(at, position) {
            aheads[which] = Ahead::look(few, walk, at, 0);
        }
        let ahead = &aheads[which];
        let (left, tried, touched) = (ahead.leaving(), ahead.tried, ahead.touched);
        walk.ended.leave_several(at, ahead.direction);
        walk.triples.skip(left);
        add(Counter::WalkRays, left as u64);
        at += left;
        if left < tried {
            walk.triples.skip(1);
            add(Counter::WalkRays, 1);
            go_on(prepared, few, walk, wide, at, touched.by(left), &mut aheads);
            at += 1;
        }
    }
}

/// Follows the queue's sample `at` to its end, from its first ray on, which may meet the objects of `touched`. Looks at the
/// samples behind it meanwhile.
#[inline(always)]
fn go_on<V: Lanes, W: Simd, L: Layout>(
    prepared: &Prepared<L>,
    few: &Few,
    walk: &mut Walk,
    wide: W,
    at: usize,
    mut touched: u32,
    [if_it_leaves, if_it_ends]: &mut [Ahead<V>; 2],
) {
    let mut ray = Ray { origin: walk.queue.point.get(at), direction: walk.ended.direction.get(at) };
    let mut rays = walk.queue.rays[at];
    if rays == 1 {
        walk.triples.prepare(wide);
        *if_it_ends = Ahead::look(few, walk, at + 1, 1);
    }
    loop {
        let found = nearest_of(&prepared.objects, &ray, touched);
        if !found.is_hit() {
            return walk.ended.leave(at, ray.direction);
        }
        rays -= 1;
        let Some(sent) = walk.send_on(prepared, wide, at, rays, &ray, &found) else {
            return;
        };
        ray = sent.ray;
        add(Counter::WalkRays, 1);
        walk.triples.prepare(wide);
        *if_it_leaves = Ahead::look(few, walk, at + 1, 0);
        touched = few.touched_by_one::<V, _>(&prepared.objects, &ray);
        // One branch for the commonest answer, as early as it can be known.
        if touched == 0 {
            return walk.ended.leave(at, ray.direction);
        }
        if rays == 1 && ends(prepared, few, walk, wide, at, &ray, if_it_ends) {
            return;
        }
    }
}

/// Looks at the samples behind the one at `at` as if its last ray met something, and ends it where that is certain and all
/// objects are alike.
#[inline(always)]
fn ends<V: Lanes, W: Simd, L: Layout>(
    prepared: &Prepared<L>,
    few: &Few,
    walk: &mut Walk,
    wide: W,
    at: usize,
    ray: &Ray,
    if_it_ends: &mut Ahead<V>,
) -> bool {
    walk.triples.prepare(wide);
    *if_it_ends = Ahead::look(few, walk, at + 1, 1);
    let ends = prepared.scatters_everywhere && few.begins_inside(&prepared.objects, ray);
    if ends {
        add(Counter::Hits, 1);
        add(Counter::LastRaysSpared, 1);
        walk.triples.skip(1);
        walk.ended.forget(at, &mut walk.queue);
    }
    ends
}

/// The first rays of the samples from `at` on, which take the triples behind the next `skipped`; and the lanes whose directions
/// are too short for the filter, as bits.
#[inline(always)]
fn first_rays<V: Lanes>(queue: &Queue, triples: &Triples, at: usize, skipped: usize) -> (Ray<V>, u32) {
    let (base, triple) = (queue.base.load::<V>(at), triples.following::<V>(skipped));
    let spread = queue.spread::<V>(at);
    let mut direction = base + spread.vector(triple);
    // A direction whose components are all negligible is shorter still.
    let short = is_too_short(direction.dot(direction)).bits();
    if short != 0 {
        let limit = spread.negligible;
        let negligible = direction.x.abs().less(limit) & direction.y.abs().less(limit) & direction.z.abs().less(limit);
        direction = Vec3::select(negligible, base, direction);
    }
    (Ray { origin: queue.point.load(at), direction }, short)
}
