//! The samples of a batch that wait for a random vector, side by side: what their ways on begin with.

use super::batch::{Batch, CAPACITY, SLACK, Values, Vectors};
use crate::certified::Intersect;
use crate::layout::{Layout, Objects};
use crate::prepare::{Kind, Prepared};
use crate::scene::MaterialId;
use crate::search::ObjectId;
use crate::vec3::NEGLIGIBLE;

/// Waiting samples in order. What lies behind the last is of no meaning.
#[derive(Debug)]
pub struct Queue {
    /// Their number.
    pub count: usize,
    /// Where each stands.
    pub point: Vectors,
    /// See [`Batch::base`].
    pub base: Vectors,
    /// Its random vector is the triple times `scale`, plus `shift`.
    pub scale: Values,
    /// See `scale`.
    pub shift: Values,
    /// A direction whose components are all smaller is replaced by the base: nothing is smaller for metal.
    pub negligible: Values,
    /// The object it stands on.
    pub object: [ObjectId; CAPACITY + SLACK],
    /// The object's material.
    pub material: [MaterialId; CAPACITY + SLACK],
    /// Rays that it may still send.
    pub rays: [u64; CAPACITY + SLACK],
}

impl Queue {
    /// Nobody waits.
    pub fn new() -> Self {
        Self {
            count: 0,
            point: Vectors::ZERO,
            base: Vectors::ZERO,
            scale: [0.0; CAPACITY + SLACK],
            shift: [0.0; CAPACITY + SLACK],
            negligible: [0.0; CAPACITY + SLACK],
            object: [0; CAPACITY + SLACK],
            material: [0; CAPACITY + SLACK],
            rays: [0; CAPACITY + SLACK],
        }
    }

    /// Takes the batch's waiting samples; says whether all of them may send a ray.
    #[inline(always)]
    pub fn fill<L: Layout, P: Intersect>(&mut self, prepared: &Prepared<L, P>, batch: &Batch) -> bool {
        self.count = batch.waiting.len();
        let mut fewest = u64::MAX;
        for (at, &sample) in batch.waiting.iter().enumerate() {
            let sample = sample as usize;
            self.point.set(at, batch.point.get(sample));
            self.base.set(at, batch.base.get(sample));
            let object = batch.object[sample];
            let material = material_of(&prepared.objects, object);
            let finish = &prepared.finishes[material as usize];
            self.scale[at] = finish.scale;
            self.shift[at] = finish.shift;
            self.negligible[at] = if finish.kind == Kind::Matte { NEGLIGIBLE } else { 0.0 };
            self.object[at] = object;
            self.material[at] = material;
            let rays = prepared.max_depth - 1 - batch.passed[sample];
            self.rays[at] = rays;
            fewest = fewest.min(rays);
        }
        fewest > 0
    }
}

/// The material of the object at `object`.
#[inline(always)]
pub fn material_of<O: Objects>(objects: &O, object: ObjectId) -> MaterialId {
    match (object as usize).checked_sub(objects.sphere_count()) {
        None => objects.sphere(object as usize).material,
        Some(index) => objects.cylinder(index).material,
    }
}
