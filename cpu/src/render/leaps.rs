//! The walk where objects are few: in one step over all the samples that leave the scene at once.
//!
//! Half of all paths leave with the first ray after a surface that scatters. So while one ray is on its way, the first
//! rays of the samples after it are tried too, as if each before them left: then each takes the next triple of the
//! stream, and all of them are tested together. Those before the first ray that may meet something have left; that ray
//! is asked for exactly, and leads the next step. What was guessed wrong is tried again.

use super::queue::Queue;
use super::shade::{load, select};
use super::vectors::Triples;
use super::walk::Walk;
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::prepare::{Kind, Prepared};
use crate::ray::Ray;
use crate::scatter;
use crate::search::{Few, nearest_of};
use crate::simd::{LaneMask, Lanes};
use crate::surface::{Onward, Surface};
use crate::vec3::{NEGLIGIBLE, Vec3};

/// Most lanes.
const MOST: usize = 8;

/// Follows every sample of the queue to its end. Each may send a ray.
#[inline(always)]
pub fn follow<V: Lanes, L: Layout, P: Intersect>(prepared: &Prepared<L, P>, few: &Few, walk: &mut Walk) {
    let Walk { triples, queue, ended, .. } = walk;
    let mut touched_by = [0.0; MOST];
    let mut first = 0;
    while first < queue.count {
        triples.prepare();
        // How many of the next samples leave with their first rays.
        let rays = lanes::<V>(queue, first, triples);
        let touched = few.touched(&prepared.objects, &rays);
        touched.store(&mut touched_by);
        ended.leave_several(first, rays.direction);
        let tried = V::LANES.min(queue.count - first);
        let stops = V::of(0.0).less(touched).bits() | u32::MAX << tried;
        let leaving = stops.trailing_zeros() as usize;
        add(Counter::WalkRays, tried.min(leaving + 1) as u64);
        add(Counter::WrongGuesses, (tried - tried.min(leaving + 1)) as u64);
        triples.skip(leaving);
        first += leaving;
        if leaving == tried {
            continue;
        }
        // The one after them goes its own way.
        triples.skip(1);
        let mut ray = Ray { origin: queue.point.get(first), direction: ended.direction.get(first) };
        let mut found = nearest_of::<_, P>(&prepared.objects, &ray, touched_by[leaving % MOST] as u32);
        let mut rays = queue.rays[first];
        loop {
            if !found.is_hit() {
                ended.leave(first, ray.direction);
                break;
            }
            rays -= 1;
            let surface = Surface::new(&prepared.objects, &ray, &found);
            let finish = &prepared.finishes[surface.material as usize];
            ray.origin = surface.point;
            match surface.onward(finish, ray.direction) {
                Onward::Scattered(base) => {
                    ended.meet(surface.material);
                    triples.prepare();
                    let vector = finish.vector(triples.next());
                    let matte = finish.kind == Kind::Matte;
                    ray.direction = if matte { scatter::matte(base, vector) } else { base + vector };
                }
                Onward::Through(direction) => ray.direction = direction,
            }
            if rays == 0 {
                ended.forget(first);
                break;
            }
            add(Counter::WalkRays, 1);
            found = few.nearest::<_, P>(&prepared.objects, &ray);
        }
        first += 1;
    }
}

/// The first rays of the samples from `first` on.
#[inline(always)]
fn lanes<V: Lanes>(queue: &Queue, first: usize, triples: &Triples) -> Ray<V> {
    let (base, triple) = (load::<V>(&queue.base, first), triples.following::<V>());
    let (scale, shift) = (V::load(&queue.scale[first..]), V::load(&queue.shift[first..]));
    let vector = Vec3::new(triple.x * scale + shift, triple.y * scale + shift, triple.z * scale + shift);
    let mut direction = base + vector;
    // Components that are negligible are short together.
    let short = direction.dot(direction).less(V::of(4.0 * NEGLIGIBLE * NEGLIGIBLE));
    if short.bits() != 0 {
        let limit = V::load(&queue.negligible[first..]);
        let negligible = direction.x.abs().less(limit) & direction.y.abs().less(limit) & direction.z.abs().less(limit);
        direction = select(negligible, base, direction);
    }
    Ray { origin: load(&queue.point, first), direction }
}
