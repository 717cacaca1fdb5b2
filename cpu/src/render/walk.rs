//! The part of the paths that is sequential by definition: from the first surface that scatters on, sample after sample,
//! each taking its random vectors from one stream.
//!
//! With few objects it goes [several samples at a time](super::leaps); here is the way of one ray after the other.

use super::batch::Batch;
use super::ends::Ended;
use super::leaps;
use super::queue::Queue;
use super::vectors::Triples;
use crate::certified::Intersect;
use crate::layout::Layout;
use crate::prepare::{Kind, Prepared};
use crate::ray::Ray;
use crate::scatter;
use crate::search::{Search, Stack};
use crate::simd::{Kernel, Simd};
use crate::surface::{Onward, Surface};

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

    /// Follows every waiting sample to its end.
    #[inline(always)]
    fn follow<S: Simd, L: Layout, P: Intersect>(&mut self, prepared: &Prepared<L, P>, batch: &Batch) {
        let all_go_on = self.queue.fill(prepared, batch);
        match &prepared.search {
            Search::Few(few) if all_go_on => leaps::follow::<S::F64, L, P>(prepared, few, self),
            _ => {
                for at in 0..self.queue.count {
                    self.follow_one::<S, L, P>(prepared, at);
                }
            }
        }
    }

    /// Follows the queue's sample `at`.
    #[inline(always)]
    fn follow_one<S: Simd, L: Layout, P: Intersect>(&mut self, prepared: &Prepared<L, P>, at: usize) {
        let Self { triples, queue, ended, stack } = self;
        ended.begin(at);
        let mut ray = Ray { origin: queue.point.get(at), direction: queue.base.get(at) };
        let mut from = queue.object[at];
        let mut material = queue.material[at];
        let mut rays = queue.rays[at];
        loop {
            let finish = &prepared.finishes[material as usize];
            triples.prepare();
            let vector = finish.vector(triples.next());
            let base = ray.direction;
            ray.direction = if finish.kind == Kind::Matte { scatter::matte(base, vector) } else { base + vector };
            // On through refractive surfaces to the next one that scatters.
            loop {
                if rays == 0 {
                    return ended.forget(at);
                }
                rays -= 1;
                let found = prepared.search.nearest::<S, L::Objects, P>(&prepared.objects, &ray, from, stack);
                if !found.is_hit() {
                    return ended.leave(at, ray.direction);
                }
                let surface = Surface::new(&prepared.objects, &ray, &found);
                from = found.object;
                ray.origin = surface.point;
                match surface.onward(&prepared.finishes[surface.material as usize], ray.direction) {
                    Onward::Scattered(base) => {
                        ray.direction = base;
                        material = surface.material;
                        break;
                    }
                    Onward::Through(direction) => ray.direction = direction,
                }
            }
            ended.meet(material);
        }
    }
}

/// Follows every waiting sample to its end.
pub struct Follow<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub walk: &'a mut Walk,
    pub batch: &'a Batch,
}

impl<L: Layout, P: Intersect> Kernel for Follow<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        self.walk.follow::<S, L, P>(self.prepared, self.batch);
    }
}
