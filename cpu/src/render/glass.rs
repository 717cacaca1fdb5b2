//! Rays through refractive surfaces, which need no random number: followed ahead up to the first surface that does.

use super::batch::Batch;
use super::hits::{Hits, MOST_LANES};
use super::primary::valid_lanes;
use super::shade::shade;
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::layout::{Layout, Objects};
use crate::prepare::Prepared;
use crate::ray::Ray;
use crate::search::{Few, ObjectId, Search};
use crate::simd::{Kernel, Lanes, Simd};
use crate::surface::{Onward, Surface};
use crate::vec3::Vec3;

/// Follows the samples in glass until each meets a surface that scatters, leaves the scene, or has used up its depth.
pub struct Trace<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub batch: &'a mut Batch,
}

impl<L: Layout, P: Intersect> Kernel for Trace<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let Self { prepared, batch } = self;
        let mut in_glass = std::mem::take(&mut batch.in_glass);
        match &prepared.search {
            Search::Few(few) => {
                // All samples go from one surface to the next together.
                let mut passed = 1;
                while passed < prepared.max_depth && !in_glass.is_empty() {
                    step_all::<S, L, P>(prepared, few, batch, &mut in_glass, passed);
                    passed += 1;
                }
            }
            // Not a closure: it would be compiled without the instruction set.
            _ => {
                for &sample in &in_glass {
                    follow::<S, L, P>(prepared, batch, sample as usize);
                }
            }
        }
        in_glass.clear();
        batch.in_glass = in_glass;
        // Two or more runs in order; the stable sort finds and merges them.
        batch.waiting.sort();
    }
}

/// Takes every sample to the next surface, as many at once as there are lanes; those that stay in glass remain in the
/// list.
#[inline(always)]
fn step_all<S: Simd, L: Layout, P: Intersect>(
    prepared: &Prepared<L, P>,
    few: &Few,
    batch: &mut Batch,
    in_glass: &mut Vec<u32>,
    passed: u64,
) {
    let background = prepared.background.lanes::<S::F64>();
    let count = in_glass.len();
    add(Counter::GlassRays, count as u64);
    let mut staying = 0;
    for from in (0..count).step_by(S::F64::LANES) {
        let lanes = S::F64::LANES.min(count - from);
        let mut samples = [in_glass[from] as usize; MOST_LANES];
        let mut values = [[0.0; MOST_LANES]; 6];
        for lane in 0..S::F64::LANES {
            // Lanes that no sample fills repeat the first one.
            samples[lane] = in_glass[if lane < lanes { from + lane } else { from }] as usize;
            let (point, base) = (batch.point.get(samples[lane]), batch.base.get(samples[lane]));
            for (value, component) in values.iter_mut().zip([point.x, point.y, point.z, base.x, base.y, base.z]) {
                value[lane] = component;
            }
        }
        let [x, y, z, dx, dy, dz] = &values;
        let ray = Ray {
            origin: Vec3::new(S::F64::load(x), S::F64::load(y), S::F64::load(z)),
            direction: Vec3::new(S::F64::load(dx), S::F64::load(dy), S::F64::load(dz)),
        };
        let valid = valid_lanes::<S::F64>(lanes);
        let hits = nearest::<_, _, P>(&prepared.objects, few.in_order(), &ray, valid);
        let color = spread(background.color(ray.direction));
        let shaded = shade(prepared, &ray, &hits);
        let (point, base) = (spread(shaded.point), spread(shaded.base));
        for (lane, &sample) in samples.iter().enumerate().take(lanes) {
            if hits.bits >> lane & 1 == 0 {
                batch.color.set(sample, get(&color, lane));
                continue;
            }
            batch.point.set(sample, get(&point, lane));
            batch.base.set(sample, get(&base, lane));
            batch.object[sample] = shaded.object[lane];
            batch.passed[sample] = passed;
            if shaded.glass >> lane & 1 == 1 {
                in_glass[staying] = sample as u32;
                staying += 1;
            } else {
                batch.waiting.push(sample as u32);
            }
        }
    }
    in_glass.truncate(staying);
}

/// The nearest hits among all objects, given in the order of the file, of rays that each have an origin of their own.
#[inline(always)]
fn nearest<V: Lanes, O: Objects, P: Intersect>(
    objects: &O,
    in_order: &[ObjectId],
    ray: &Ray<V>,
    valid: u32,
) -> Hits<V> {
    let mut hits = Hits::none();
    let a = ray.direction.dot(ray.direction);
    for &id in in_order {
        match (id as usize).checked_sub(objects.sphere_count()) {
            None => {
                let record = objects.sphere(id as usize).record;
                let view = record.lanes().seen_from(ray.origin);
                hits.ask_sphere::<P>(id, &record, &view, ray, a, valid);
            }
            Some(index) => {
                let record = objects.cylinder(index).record;
                let view = record.lanes().seen_from(ray.origin);
                hits.ask_cylinder::<P>(id, (&record, &objects.axis(index)), &view, ray, a, valid);
            }
        }
    }
    hits
}

/// The lanes of three components in memory.
#[inline(always)]
fn spread<V: Lanes>(vector: Vec3<V>) -> [[f64; MOST_LANES]; 3] {
    let mut values = [[0.0; MOST_LANES]; 3];
    vector.x.store(&mut values[0]);
    vector.y.store(&mut values[1]);
    vector.z.store(&mut values[2]);
    values
}

#[inline(always)]
fn get([x, y, z]: &[[f64; MOST_LANES]; 3], lane: usize) -> Vec3 {
    Vec3::new(x[lane], y[lane], z[lane])
}

/// Follows one sample, where the search is for one ray at a time.
#[inline(always)]
fn follow<S: Simd, L: Layout, P: Intersect>(prepared: &Prepared<L, P>, batch: &mut Batch, sample: usize) {
    let mut ray = Ray { origin: batch.point.get(sample), direction: batch.base.get(sample) };
    let mut from = batch.object[sample];
    for passed in 1..prepared.max_depth {
        let found = prepared.search.nearest::<S, L::Objects, P>(&prepared.objects, &ray, from, &mut batch.stack);
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
