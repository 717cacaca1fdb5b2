//! Rays through refractive surfaces, which need no random number: followed ahead up to the first surface that does.

use super::batch::Batch;
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::ray::Ray;
use crate::simd::{Kernel, Simd};
use crate::surface::{Onward, Surface};

/// Follows the samples in glass until each meets a surface that scatters, leaves the scene, or has used up its depth.
pub struct Trace<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub batch: &'a mut Batch,
}

impl<L: Layout> Kernel for Trace<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        trace::<S, L>(self.prepared, self.batch);
    }
}

#[inline(always)]
fn trace<S: Simd, L: Layout>(prepared: &Prepared<L>, batch: &mut Batch) {
    if batch.in_glass.is_empty() {
        return;
    }
    let mut in_glass = std::mem::take(&mut batch.in_glass);
    for &sample in &in_glass {
        follow::<S, L>(prepared, batch, sample as usize);
    }
    in_glass.clear();
    batch.in_glass = in_glass;
    batch.waiting.sort_unstable();
}

#[inline(always)]
fn follow<S: Simd, L: Layout>(prepared: &Prepared<L>, batch: &mut Batch, sample: usize) {
    let mut ray = Ray { origin: batch.point.get(sample), direction: batch.base.get(sample) };
    let mut from = batch.object[sample];
    for passed in 1..prepared.max_depth {
        let found = prepared.search.nearest::<S, L::Objects>(&prepared.objects, &ray, from, &mut batch.stack);
        if !found.is_hit() {
            batch.color.set(sample, prepared.background.color(ray.direction));
            return;
        }
        let surface = Surface::new(&prepared.objects, &ray, &found);
        from = found.object;
        let base = match surface.onward(&prepared.finishes[surface.material as usize], ray.direction) {
            Onward::Scattered(base) => base,
            Onward::Through(direction) => {
                ray = Ray { origin: surface.point, direction };
                continue;
            }
        };
        batch.point.set(sample, surface.point);
        batch.base.set(sample, base);
        batch.object[sample] = from;
        batch.passed[sample] = passed;
        batch.waiting.push(sample as u32);
        return;
    }
}
