//! The part of the paths that is sequential by definition: from the first surface that scatters on, sample after sample,
//! each taking its random vectors from one stream.
//!
//! With two or three objects the samples that leave at once are passed over [together](super::leaps).

use super::ends::Ended;
use super::leaps;
use super::queue::Queue;
use super::vectors::Triples;
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::layout::Layout;
use crate::prepare::{Kind, Prepared};
use crate::ray::Ray;
use crate::search::{Find, Found, ObjectId, Plain, Search, Stack};
use crate::simd::{Kernel, Simd};
use crate::surface::{Onward, Surface, material_of};

/// What became of the next samples with their first rays.
pub struct Start {
    /// As many are at their ends.
    pub done: usize,
    /// The first ray of the one after them, unless that is at its end too.
    pub next: Option<First>,
}

/// The first ray of a sample.
pub struct First {
    pub ray: Ray,
    /// What it meets, if that is known.
    pub found: Option<Found>,
}

/// Walks paths; holds the stream and what waits for its background.
#[derive(Debug)]
pub struct Walk {
    pub triples: Triples,
    pub queue: Queue,
    /// The paths of the queue that are done.
    pub ended: Ended,
    stack: Stack,
}

impl Walk {
    /// At the beginning of the stream.
    pub fn new<L: Layout, P: Intersect>(prepared: &Prepared<L, P>) -> Box<Self> {
        Box::new(Self {
            triples: Triples::new(prepared.vectors, prepared.material_seed),
            queue: Queue::new(),
            ended: Ended::new(),
            stack: Stack::EMPTY,
        })
    }

    /// Follows every waiting sample to its end; `wide` is for what is done in bulk.
    #[inline(always)]
    fn follow<S: Simd, W: Simd, L: Layout, P: Intersect, F: Find>(
        &mut self,
        prepared: &Prepared<L, P>,
        search: &F,
        wide: W,
    ) {
        let all_go_on = self.queue.fewest_rays > 0;
        let mut at = 0;
        while at < self.queue.count {
            self.triples.prepare(wide);
            let start = match search.for_leaps() {
                Some(few) if all_go_on => leaps::leap::<S::F64, L, P>(prepared, few, self, at),
                _ => self.start(at),
            };
            at += start.done;
            if let Some(first) = start.next {
                self.go_on::<S, W, L, P, F>(prepared, search, wide, at, first);
                at += 1;
            }
        }
    }

    /// Begins the queue's sample `at`, which may be allowed no ray.
    #[inline(always)]
    fn start(&mut self, at: usize) -> Start {
        let Self { triples, queue, ended, .. } = self;
        ended.begin();
        let triple = triples.next();
        if queue.rays[at] == 0 {
            ended.forget(at, queue);
            return Start { done: 1, next: None };
        }
        Start { done: 0, next: Some(First { ray: queue.ray(at, triple), found: None }) }
    }

    /// Follows the queue's sample `at` from its first ray to its end.
    #[inline(always)]
    fn go_on<S: Simd, W: Simd, L: Layout, P: Intersect, F: Find>(
        &mut self,
        prepared: &Prepared<L, P>,
        search: &F,
        wide: W,
        at: usize,
        First { mut ray, found: mut known }: First,
    ) {
        let Self { triples, queue, ended, stack } = self;
        let mut rays = queue.rays[at];
        let mut origin = search.origin(&prepared.objects, &ray, queue.object[at] as ObjectId);
        loop {
            // The search stands here once: its code is long.
            let found = match known.take() {
                Some(found) => found,
                None => {
                    add(Counter::WalkRays, 1);
                    search.find::<S, L::Objects, P>(&prepared.objects, &ray, origin, stack)
                }
            };
            if !found.is_hit() {
                return ended.leave(at, ray.direction);
            }
            rays -= 1;
            if rays == 0 {
                // The last surface takes its vector all the same.
                add(Counter::Hits, 1);
                let material = material_of(&prepared.objects, found.object);
                if prepared.finishes[material as usize].kind != Kind::Refractive {
                    triples.prepare(wide);
                    triples.skip(1);
                }
                return ended.forget(at, queue);
            }
            let surface = Surface::new(&prepared.objects, &ray, &found);
            let finish = &prepared.finishes[surface.material as usize];
            match surface.onward(finish, ray.direction) {
                Onward::Scattered(base) => {
                    if !ended.meet(at, surface.material) {
                        return ended.forget(at, queue);
                    }
                    triples.prepare(wide);
                    let triple = triples.next();
                    let vector = finish.spread.vector(triple);
                    origin = search.next_origin(&prepared.objects, &ray, &found, finish, vector);
                    ray = Ray { origin: surface.point, direction: finish.spread.around(base, triple) };
                }
                Onward::Through(direction) => {
                    ray = Ray { origin: surface.point, direction };
                    origin = search.origin(&prepared.objects, &ray, found.object);
                }
            }
        }
    }
}

/// Follows every waiting sample to its end.
pub struct Follow<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub walk: &'a mut Walk,
}

impl<L: Layout, P: Intersect> Kernel for Follow<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        // Each kind of search has a walk of its own, compiled apart.
        match &self.prepared.search {
            Search::Plain => simd.run_promptly(Promptly { follow: self, search: &Plain, wide: simd }),
            Search::Few(search) => simd.run_promptly(Promptly { follow: self, search, wide: simd }),
            Search::Flat(search) => simd.run_promptly(Promptly { follow: self, search, wide: simd }),
            Search::Tree(search) => simd.run_promptly(Promptly { follow: self, search, wide: simd }),
        }
    }
}

/// The same, with the instruction set for work on one ray after the other.
struct Promptly<'a, L: Layout, P, F, W> {
    follow: Follow<'a, L, P>,
    search: &'a F,
    wide: W,
}

impl<L: Layout, P: Intersect, F: Find, W: Simd> Kernel for Promptly<'_, L, P, F, W> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let Self { follow: Follow { prepared, walk }, search, wide } = self;
        walk.follow::<S, W, L, P, F>(prepared, search, wide);
    }
}
