//! Primary rays, several at once: drawn, intersected with the span's candidates, shaded.

use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Layout;
use crate::math::real::Real;
use crate::render::frustum::{Candidate, Candidates};
use crate::render::hit_lanes::{HitLanes, Rays};
use crate::render::lane_by_lane::for_each_lane;
use crate::render::path_queue::PathQueue;
use crate::render::prepared::Prepared;
use crate::render::sample_set::SampleSet;
use crate::render::samples::{Batch, SpecularSample};
use crate::render::shade::shade;
use crate::simd::{Kernel, Simd, SimdF64, valid_lanes};

/// Traces the batch's primary rays: the samples that meet nothing have their colour, the others stand in the queue.
pub struct Trace<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub row: usize,
    pub candidates: &'a Candidates,
    pub batch: &'a mut Batch,
    pub queue: &'a mut PathQueue,
}

impl<L: Layout> Kernel for Trace<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        trace::<S, L>(self);
    }
}

#[inline(always)]
fn trace<S: Simd, L: Layout>(Trace { prepared, row, candidates, batch, queue }: Trace<'_, L>) {
    let camera = prepared.camera.lanes::<S::F64>();
    let background = prepared.background.lanes::<S::F64>();
    let row = S::F64::of(row as f64);
    batch.specular.clear();
    batch.queued = SampleSet::EMPTY;
    queue.clear();
    add(Counter::PrimaryRays, batch.count as u64);
    add(Counter::PrimaryTests, (batch.count * candidates.span.len()) as u64);
    for at in (0..batch.count).step_by(S::F64::LANES) {
        let offset = [S::F64::load(&batch.offset[0][at..]), S::F64::load(&batch.offset[1][at..])];
        let ray = camera.ray(row, S::F64::load(&batch.column[at..]), offset);
        let valid = valid_lanes::<S::F64>(batch.count - at);
        let hits = closest_hit(candidates, &ray, valid);
        if hits.bits != valid {
            batch.color.store(at, background.color(ray.direction));
        }
        if hits.bits != 0 {
            let shaded = shade(prepared, &ray, &hits);
            for_each_lane(shaded.glass, |lane| {
                let before = hits.bits & ((1 << lane) - 1);
                let place = queue.count as u32 + before.count_ones();
                batch.specular.push(SpecularSample { sample: (at + lane) as u32, place });
            });
            batch.queued.add(at, hits.bits);
            queue.push(&shaded.vertex, hits.bits, prepared.max_depth - 1);
        }
    }
}

/// The nearest hits among the candidates, which are in the order of the file.
#[inline(always)]
fn closest_hit<V: SimdF64>(candidates: &Candidates, ray: &Ray<V>, valid: u32) -> HitLanes<V> {
    let mut hits = HitLanes::none();
    if candidates.span.is_empty() {
        return hits;
    }
    let rays = Rays::new(ray, valid);
    for (id, candidate) in &candidates.span {
        match candidate {
            Candidate::Sphere(record, view) => hits.intersect_sphere(*id, record, &view.lanes(), &rays),
            Candidate::Cylinder(record, axis, view) => {
                hits.intersect_cylinder(*id, (record, axis), &view.lanes(), &rays);
            }
        }
    }
    hits
}
