//! Where objects are two or three: the samples that leave the scene at once, passed over together.
//!
//! Half of all paths leave with their first ray after a surface that scatters. So the first rays of the next samples are
//! tried as if each of them left: then each takes the next triple of the stream, and all of them are tested together.
//! Those before the first ray that may meet something have left; that ray is asked for exactly. What was guessed wrong
//! behind it is tried again.

use super::queue::Queue;
use super::shade::{load, select};
use super::vectors::Triples;
use super::walk::{First, Start, Walk};
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::ray::Ray;
use crate::search::{Few, nearest_of};
use crate::simd::{LaneMask, Lanes};
use crate::vec3::NEGLIGIBLE;

/// Most lanes.
const MOST: usize = 8;

/// Tries the samples of the queue from `at` on, each of which may send a ray.
#[inline(always)]
pub fn leap<V: Lanes, L: Layout, P: Intersect>(
    prepared: &Prepared<L, P>,
    few: &Few,
    walk: &mut Walk,
    at: usize,
) -> Start {
    let Walk { triples, queue, ended, .. } = walk;
    let rays = lanes::<V>(queue, at, triples);
    let touched = few.touched(&rays);
    ended.leave_several(at, rays.direction);
    let tried = V::LANES.min(queue.count - at);
    let stops = V::of(0.0).less(touched).bits() | u32::MAX << tried;
    let done = stops.trailing_zeros() as usize;
    add(Counter::WalkRays, tried.min(done + 1) as u64);
    add(Counter::WrongGuesses, (tried - tried.min(done + 1)) as u64);
    triples.skip(done);
    if done == tried {
        return Start { done, next: None };
    }
    triples.skip(1);
    let mut touched_by = [0.0; MOST];
    touched.store(&mut touched_by);
    let ray = Ray { origin: queue.point.get(at + done), direction: ended.direction.get(at + done) };
    let found = nearest_of::<_, P>(&prepared.objects, &ray, touched_by[done % MOST] as u32);
    Start { done, next: Some(First { ray, found: Some(found) }) }
}

/// The first rays of the samples from `first` on.
#[inline(always)]
fn lanes<V: Lanes>(queue: &Queue, first: usize, triples: &Triples) -> Ray<V> {
    let (base, triple) = (load::<V>(&queue.base, first), triples.following::<V>());
    let spread = queue.spread::<V>(first);
    let mut direction = base + spread.vector(triple);
    // Components that are negligible are short together.
    let short = direction.dot(direction).less(V::of(4.0 * NEGLIGIBLE * NEGLIGIBLE));
    if short.bits() != 0 {
        let limit = spread.negligible;
        let negligible = direction.x.abs().less(limit) & direction.y.abs().less(limit) & direction.z.abs().less(limit);
        direction = select(negligible, base, direction);
    }
    Ray { origin: load(&queue.point, first), direction }
}
