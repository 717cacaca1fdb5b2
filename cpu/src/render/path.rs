//! One path, from the first surface that scatters to its end, and the stream that all paths share.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::Found;
use crate::accel::find::Find;
use crate::accel::object::ObjectId;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Layout;
use crate::materials::prepared::{Finish, Kind};
use crate::math::vec3::Vec3;
use crate::render::path_ends::Ended;
use crate::render::path_queue::Queue;
use crate::render::prepared::Prepared;
use crate::render::surface::{Onward, Surface, material_of};
use crate::sampling::scatter_stream::Triples;
use crate::simd::Simd;

/// Where a surface has sent a path.
pub struct Sent<'a> {
    pub ray: Ray,
    /// The surface's finish and the random vector, if it scatters.
    scattered: Option<(&'a Finish, Vec3)>,
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
    pub fn new<L: Layout>(prepared: &Prepared<L>) -> Box<Self> {
        Box::new(Self {
            triples: Triples::new(prepared.vectors, prepared.material_seed),
            queue: Queue::new(),
            ended: Ended::new(),
            stack: Stack::EMPTY,
        })
    }

    /// Follows every waiting sample to its end.
    #[inline(always)]
    pub fn follow<S: Simd, L: Layout, F: Find>(&mut self, prepared: &Prepared<L>, search: &F, simd: S) {
        for at in 0..self.queue.count {
            self.triples.prepare(simd);
            self.ended.begin();
            let triple = self.triples.next();
            if self.queue.rays[at] == 0 {
                self.ended.forget(at, &mut self.queue);
            } else {
                let ray = self.queue.ray(at, triple);
                self.go_on::<S, L, F>(prepared, search, simd, at, ray);
            }
        }
    }

    /// Follows the queue's sample `at` from its first ray to its end.
    #[inline(always)]
    fn go_on<S: Simd, L: Layout, F: Find>(
        &mut self,
        prepared: &Prepared<L>,
        search: &F,
        simd: S,
        at: usize,
        mut ray: Ray,
    ) {
        let mut rays = self.queue.rays[at];
        let mut origin = search.origin(&prepared.objects, &ray, self.queue.object[at] as ObjectId);
        loop {
            add(Counter::WalkRays, 1);
            let found = search.find::<S, L::Objects>(&prepared.objects, &ray, origin, &mut self.stack);
            if !found.is_hit() {
                return self.ended.leave(at, ray.direction);
            }
            rays -= 1;
            let Some(sent) = self.send_on(prepared, simd, at, rays, &ray, &found) else {
                return;
            };
            origin = match sent.scattered {
                Some((finish, vector)) => search.next_origin(&prepared.objects, &ray, &found, finish, vector),
                None => search.origin(&prepared.objects, &sent.ray, found.object),
            };
            ray = sent.ray;
        }
    }

    /// Sends path `at` on from what its ray has found, as one that may send `rays` more; or ends it where there is none.
    #[inline(always)]
    pub fn send_on<'a, S: Simd, L: Layout>(
        &mut self,
        prepared: &'a Prepared<L>,
        simd: S,
        at: usize,
        rays: u64,
        ray: &Ray,
        found: &Found,
    ) -> Option<Sent<'a>> {
        let Self { triples, queue, ended, .. } = self;
        if rays == 0 {
            // The last surface takes its vector all the same.
            add(Counter::Hits, 1);
            let material = material_of(&prepared.objects, found.object);
            if prepared.finishes[material as usize].kind != Kind::Refractive {
                triples.prepare(simd);
                triples.skip(1);
            }
            ended.forget(at, queue);
            return None;
        }
        let surface = Surface::new(&prepared.objects, ray, found);
        let finish = &prepared.finishes[surface.material as usize];
        match surface.onward(finish, ray.direction) {
            Onward::Scattered(base) => {
                if !ended.meet(at, surface.material) {
                    ended.forget(at, queue);
                    return None;
                }
                triples.prepare(simd);
                let triple = triples.next();
                let ray = Ray { origin: surface.point, direction: finish.spread.around(base, triple) };
                Some(Sent { ray, scattered: Some((finish, finish.spread.vector(triple))) })
            }
            Onward::Through(direction) => Some(Sent { ray: Ray { origin: surface.point, direction }, scattered: None }),
        }
    }
}
