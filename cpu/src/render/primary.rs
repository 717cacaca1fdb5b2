//! Primary rays, several at once: drawn, intersected with the span's candidates, shaded.

use super::batch::Batch;
use super::shade::{Hits, shade, store};
use super::span::{Candidate, Candidates};
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::ray::Ray;
use crate::real::Real;
use crate::simd::{Kernel, LaneMask, Lanes, Simd};
use crate::sphere::SphereRecord;

/// Traces the batch's primary rays: the samples that meet nothing have their colour, the others their point, base and
/// object.
pub struct Trace<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub row: usize,
    pub candidates: &'a Candidates,
    pub batch: &'a mut Batch,
}

impl<L: Layout> Kernel for Trace<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        trace::<S, L>(self.prepared, self.row, self.candidates, self.batch);
    }
}

#[inline(always)]
fn trace<S: Simd, L: Layout>(prepared: &Prepared<L>, row: usize, candidates: &Candidates, batch: &mut Batch) {
    let camera = prepared.camera.lanes::<S::F64>();
    let background = prepared.background.lanes::<S::F64>();
    let row = S::F64::of(row as f64);
    batch.in_glass.clear();
    batch.waiting.clear();
    for at in (0..batch.count).step_by(S::F64::LANES) {
        let offset = [S::F64::load(&batch.offset[0][at..]), S::F64::load(&batch.offset[1][at..])];
        let ray = camera.ray(row, S::F64::load(&batch.column[at..]), offset);
        let valid = valid_lanes::<S::F64>(batch.count - at);
        let hits = nearest(candidates, &ray, valid);
        if hits.bits != valid {
            store(background.color(ray.direction), &mut batch.color, at);
        }
        if hits.bits != 0 {
            let shaded = shade(prepared, &ray, &hits);
            store(shaded.point, &mut batch.point, at);
            store(shaded.base, &mut batch.base, at);
            let mut bits = hits.bits;
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let sample = at + lane;
                batch.object[sample] = shaded.object[lane % shaded.object.len()];
                batch.passed[sample] = 0;
                // Black, until the way on is known to reach the background.
                batch.color.set(sample, crate::Vec3::ZERO);
                if shaded.glass >> lane & 1 == 1 {
                    batch.in_glass.push(sample as u32);
                } else {
                    batch.waiting.push(sample as u32);
                }
            }
        }
    }
}

/// The lanes that samples fill when `left` are left, as bits.
#[inline(always)]
pub fn valid_lanes<V: Lanes>(left: usize) -> u32 {
    let all = (1_u32 << V::LANES) - 1;
    if left >= V::LANES { all } else { all & ((1_u32 << left) - 1) }
}

/// The nearest hits among the candidates, which are in the order of the file: of equals the later counts.
#[inline(always)]
fn nearest<V: Lanes>(candidates: &Candidates, ray: &Ray<V>, valid: u32) -> Hits<V> {
    let mut hits = Hits { lambda: V::of(f64::INFINITY), object: V::of(0.0), part: V::of(0.0), bits: 0 };
    if candidates.span.is_empty() {
        return hits;
    }
    let a = ray.direction.dot(ray.direction);
    for (id, candidate) in &candidates.span {
        match candidate {
            Candidate::Sphere(view) => {
                let (h, discriminant) = view.lanes::<V>().quadratic(ray.direction, a);
                if V::of(0.0).less_equal(discriminant).bits() & valid == 0 {
                    continue;
                }
                let (lambda, met) = SphereRecord::first_root(a, h, discriminant);
                hits.offer(f64::from(*id), lambda, met, V::of(0.0), valid);
            }
            Candidate::Cylinder(record, view) => {
                let (record, view) = (record.lanes::<V>(), view.lanes::<V>());
                let quadratic = record.quadratic(&view, ray.direction);
                let (lambda, met, part) = record.first_part(&view, ray, quadratic);
                hits.offer(f64::from(*id), lambda, met, part, valid);
            }
        }
    }
    hits
}

impl<V: Lanes> Hits<V> {
    /// Takes hits with an object later in the file into account.
    #[inline(always)]
    fn offer(&mut self, object: f64, lambda: V, met: V::Mask, part: V, valid: u32) {
        let closer = met & lambda.less_equal(self.lambda);
        self.lambda = V::select(closer, lambda, self.lambda);
        self.object = V::select(closer, V::of(object), self.object);
        self.part = V::select(closer, part, self.part);
        self.bits |= closer.bits() & valid;
    }
}
