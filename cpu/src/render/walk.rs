//! The part of the paths that is sequential by definition: from the first surface that scatters on, sample after sample,
//! each taking its random vectors from one stream.

use super::batch::Batch;
use super::ends::Ended;
use super::vectors::Triples;
use crate::certified::Intersect;
use crate::layout::{Layout, Objects};
use crate::prepare::{Kind, Prepared};
use crate::ray::Ray;
use crate::scatter;
use crate::scene::MaterialId;
use crate::search::{ObjectId, Stack};
use crate::simd::{Kernel, Simd};
use crate::surface::{Onward, Surface};

/// Walks paths; holds the stream and what waits for its background.
#[derive(Debug)]
pub struct Walk {
    triples: Triples,
    /// The paths of the present batch that have left the scene.
    pub ended: Ended,
    stack: Stack,
}

impl Walk {
    /// At the beginning of the stream.
    pub fn new<L: Layout, P: Intersect>(prepared: &Prepared<L, P>) -> Self {
        Self {
            triples: Triples::new(prepared.scatter, prepared.material_seed),
            ended: Ended::new(),
            stack: Stack::EMPTY,
        }
    }

    /// Follows every waiting sample to its end.
    #[inline(always)]
    fn follow<S: Simd, L: Layout, P: Intersect>(&mut self, prepared: &Prepared<L, P>, batch: &mut Batch) {
        for &sample in &batch.waiting {
            let sample = sample as usize;
            let object = batch.object[sample];
            let depth_left = prepared.max_depth - 1 - batch.passed[sample];
            let material = material_of(&prepared.objects, object);
            let at = Standing { point: batch.point.get(sample), base: batch.base.get(sample), object, material };
            self.follow_one::<S, L, P>(prepared, at, depth_left, sample);
        }
    }

    #[inline(always)]
    fn follow_one<S: Simd, L: Layout, P: Intersect>(
        &mut self,
        prepared: &Prepared<L, P>,
        mut at: Standing,
        mut depth_left: u64,
        sample: usize,
    ) {
        self.ended.begin();
        loop {
            let finish = &prepared.finishes[at.material as usize];
            let vector = finish.vector(self.triples.next());
            let direction = if finish.kind == Kind::Matte { scatter::matte(at.base, vector) } else { at.base + vector };
            self.ended.meet(at.material);
            let mut ray = Ray { origin: at.point, direction };
            let mut from = at.object;
            // On through refractive surfaces to the next one that scatters.
            at = loop {
                if depth_left == 0 {
                    return self.ended.forget();
                }
                depth_left -= 1;
                let found = prepared.search.nearest::<S, L::Objects, P>(&prepared.objects, &ray, from, &mut self.stack);
                if !found.is_hit() {
                    return self.ended.leave(sample, ray.direction);
                }
                let surface = Surface::new(&prepared.objects, &ray, &found);
                from = found.object;
                match surface.onward(&prepared.finishes[surface.material as usize], ray.direction) {
                    Onward::Scattered(base) => {
                        break Standing { point: surface.point, base, object: from, material: surface.material };
                    }
                    Onward::Through(direction) => ray = Ray { origin: surface.point, direction },
                }
            };
        }
    }
}

/// Follows every waiting sample to its end.
pub struct Follow<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub walk: &'a mut Walk,
    pub batch: &'a mut Batch,
}

impl<L: Layout, P: Intersect> Kernel for Follow<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        self.walk.follow::<S, L, P>(self.prepared, self.batch);
    }
}

/// A path on a surface that scatters.
struct Standing {
    point: crate::Vec3,
    /// The direction in which the surface sends light before the random vector is added.
    base: crate::Vec3,
    object: ObjectId,
    material: MaterialId,
}

#[inline(always)]
fn material_of<O: Objects>(objects: &O, object: ObjectId) -> MaterialId {
    match (object as usize).checked_sub(objects.sphere_count()) {
        None => objects.sphere(object as usize).material,
        Some(index) => objects.cylinder(index).material,
    }
}
