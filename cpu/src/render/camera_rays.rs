//! Primary rays, several at once: drawn, intersected with the span's candidates, shaded.

use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::Layout;
use crate::math::real::Real;
use crate::render::arrays::SAMPLES;
use crate::render::frustum::{Candidate, Candidates};
use crate::render::hit_lanes::{HitLanes, Rays};
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::render::queue::PathQueue;
use crate::render::samples::Batch;
use crate::render::shade::shade;
use crate::simd::{Kernel, Simd, SimdF64, valid_lanes};

/// Traces the batch's primary rays. A sample that hits nothing gets its colour; one whose hit is refractive goes to the
/// batch's specular queue, any other to `queue`.
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
    let rays = S::F64::of(f64::from_bits(prepared.max_depth - 1));
    batch.specular.count = 0;
    queue.count = 0;
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
            let vertex = PathVertex { sample: S::F64::load(&SAMPLES[at..]), rays, ..shaded.vertex };
            if shaded.refractive != 0 {
                batch.specular.push(vertex.specular_numbers(), shaded.refractive);
            }
            if hits.bits != shaded.refractive {
                queue.push(vertex.numbers(), hits.bits & !shaded.refractive);
            }
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
