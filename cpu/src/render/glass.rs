//! Rays through refractive surfaces, which need no random number: followed ahead up to the first surface that does.

use super::batch::Batch;
use crate::layout::Layout;
use crate::prepare::{Kind, Prepared};
use crate::ray::Ray;
use crate::scatter;
use crate::simd::Simd;
use crate::surface::surface;

/// Follows the samples in glass until each meets a surface that scatters, leaves the scene, or has used up its depth.
#[inline(always)]
pub fn trace<S: Simd, L: Layout>(prepared: &Prepared<L>, batch: &mut Batch) {
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
        let found = prepared.search.nearest::<S, L::Objects>(&prepared.objects, &ray, from);
        if !found.is_hit() {
            batch.color.set(sample, prepared.background.color(ray.direction));
            return;
        }
        let (hit, material) = surface(&prepared.objects, &ray, &found);
        let finish = &prepared.finishes[material as usize];
        from = found.object;
        let base = match finish.kind {
            Kind::Matte => hit.normal,
            Kind::Metal => scatter::mirror(ray.direction, hit.normal),
            Kind::Refractive => {
                let ratio = if hit.front { finish.inverse_index } else { finish.index };
                ray = Ray { origin: hit.point, direction: scatter::refract(ray.direction, hit.normal, ratio) };
                continue;
            }
        };
        batch.point.set(sample, hit.point);
        batch.base.set(sample, base);
        batch.object[sample] = from;
        batch.passed[sample] = passed;
        batch.waiting.push(sample as u32);
        return;
    }
}
