//! Rays through refractive surfaces, which need no random number: followed ahead up to the first surface that does.

use crate::accel::choice::Accel;
use crate::accel::conservative::{ConservativeRay, is_too_short};
use crate::accel::object::ObjectId;
use crate::accel::small_scene::SmallScene;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::{Layout, Objects};
use crate::math::vec3::Vec3;
use crate::render::hit_lanes::{HitLanes, Rays};
use crate::render::lane_by_lane::{LaneByLane, MOST_LANES, for_each_lane};
use crate::render::path_queue::PathQueue;
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::render::sample_set::SampleSet;
use crate::render::samples::{Batch, SpecularSample};
use crate::render::shade::shade;
use crate::render::surface::{ScatterResult, Surface};
use crate::simd::{Kernel, LaneMask, Simd, SimdF64, valid_lanes};

/// Traces specular chains until each hits a surface that scatters, escapes, or has used up its depth. Those that escape
/// or have used it up are no longer in the queue.
pub struct Trace<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub batch: &'a mut Batch,
    pub queue: &'a mut PathQueue,
}

impl<L: Layout> Kernel for Trace<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let Self { prepared, batch, queue } = self;
        let mut specular = std::mem::take(&mut batch.specular);
        let mut gone = SampleSet::EMPTY;
        match &prepared.search {
            Accel::SmallScene(few) => {
                // All samples go from one surface to the next together.
                let mut rays = prepared.max_depth - 1;
                while rays > 0 && !specular.is_empty() {
                    rays -= 1;
                    step_all::<S, L>(prepared, few, (batch, queue), &mut specular, &mut gone, rays);
                }
                for &sample in &specular {
                    leave(batch, &mut gone, sample, Vec3::ZERO);
                }
            }
            // Not a closure: it would be compiled without the instruction set.
            _ => {
                for &sample in &specular {
                    trace::<S, L>(prepared, batch, queue, &mut gone, sample);
                }
            }
        }
        if !gone.is_empty() {
            queue.take_out::<S::F64>(&gone);
        }
        specular.clear();
        batch.specular = specular;
    }
}

/// A sample that does not come to a surface that scatters has its colour.
#[inline(always)]
fn leave(batch: &mut Batch, gone: &mut SampleSet, SpecularSample { sample, place }: SpecularSample, color: Vec3) {
    batch.color.set(sample as usize, color);
    batch.queued.remove(sample as usize);
    gone.add(place as usize, 1);
}

/// As many samples as there are lanes.
struct Group {
    /// Those beyond the last repeat the first.
    samples: [SpecularSample; MOST_LANES],
    /// The lanes that hold one of their own, as bits.
    valid: u32,
}

impl Group {
    /// The first of these.
    #[inline(always)]
    fn new<V: SimdF64>(specular: &[SpecularSample]) -> Self {
        let count = V::LANES.min(specular.len());
        let mut samples = [specular[0]; MOST_LANES];
        for lane in 1..V::LANES {
            // Not as a slice of unknown length, which would be a call.
            samples[lane] = specular[if lane < count { lane } else { 0 }];
        }
        Self { samples, valid: valid_lanes::<V>(specular.len()) }
    }
}

/// The ways on of samples from anywhere in the queue.
#[inline(always)]
fn gather<V: SimdF64>(queue: &PathQueue, samples: &[SpecularSample; MOST_LANES]) -> Ray<V> {
    let mut values = [[0.0; MOST_LANES]; 6];
    for lane in 0..V::LANES {
        let place = samples[lane].place as usize;
        let (point, base) = (queue.point.get(place), queue.base.get(place));
        for (value, component) in values.iter_mut().zip([point.x, point.y, point.z, base.x, base.y, base.z]) {
            value[lane] = component;
        }
    }
    let [x, y, z, dx, dy, dz] = &values;
    Ray {
        origin: Vec3::new(V::load(x), V::load(y), V::load(z)),
        direction: Vec3::new(V::load(dx), V::load(dy), V::load(dz)),
    }
}

/// Takes every chain to its next hit, as many at once as there are lanes; those that hit a refractive surface stay in
/// the list. After that surface each may send `rays` rays.
#[inline(always)]
fn step_all<S: Simd, L: Layout>(
    prepared: &Prepared<L>,
    few: &SmallScene,
    (batch, queue): (&mut Batch, &mut PathQueue),
    specular: &mut Vec<SpecularSample>,
    gone: &mut SampleSet,
    rays: u64,
) {
    let background = prepared.background.lanes::<S::F64>();
    let count = specular.len();
    add(Counter::GlassRays, count as u64);
    let mut staying = 0;
    for from in (0..count).step_by(S::F64::LANES) {
        let Group { samples, valid } = Group::new::<S::F64>(&specular[from..]);
        let ray = gather::<S::F64>(queue, &samples);
        let hits = closest_hit(&prepared.objects, few, &ray, valid);
        let missed = valid & !hits.bits;
        if missed != 0 {
            let color = LaneByLane::new(background.color(ray.direction).to_array());
            for_each_lane(missed, |lane| leave(batch, gone, samples[lane], color.of(lane).into()));
        }
        if hits.bits == 0 {
            continue;
        }
        let shaded = shade(prepared, &ray, &hits);
        let vertex = LaneByLane::new(shaded.vertex.numbers());
        for_each_lane(shaded.glass, |lane| {
            queue.pass_on(samples[lane].place as usize, &vertex, lane);
            specular[staying] = samples[lane];
            staying += 1;
        });
        for_each_lane(hits.bits & !shaded.glass, |lane| {
            queue.set_from(samples[lane].place as usize, &vertex, lane, rays);
        });
    }
    specular.truncate(staying);
}

/// The nearest hits of rays that each have an origin of their own, among the objects that any of them may meet:
/// neighbours in glass mostly leave the same objects behind.
#[inline(always)]
fn closest_hit<V: SimdF64, O: Objects>(objects: &O, few: &SmallScene, ray: &Ray<V>, valid: u32) -> HitLanes<V> {
    let mut hits = HitLanes::none();
    let rays = Rays::new(ray, valid);
    let touch = ConservativeRay::new(*ray);
    let too_short = is_too_short(touch.length_squared).bits() & valid;
    for &id in few.in_order() {
        if (few.touches(id, &touch).bits() & valid) | too_short == 0 {
            continue;
        }
        match (id as usize).checked_sub(objects.sphere_count()) {
            None => hits.intersect_candidate_sphere(id, &objects.sphere(id as usize).record, &rays),
            Some(index) => {
                let record = objects.cylinder(index).record;
                hits.intersect_candidate_cylinder(id, (&record, &objects.axis(index)), &rays);
            }
        }
    }
    hits
}

/// Follows one sample, where the search is for one ray at a time.
#[inline(always)]
fn trace<S: Simd, L: Layout>(
    prepared: &Prepared<L>,
    batch: &mut Batch,
    queue: &mut PathQueue,
    gone: &mut SampleSet,
    sample: SpecularSample,
) {
    let place = sample.place as usize;
    let mut ray = Ray { origin: queue.point.get(place), direction: queue.base.get(place) };
    let mut from = queue.object[place] as ObjectId;
    for passed in 1..prepared.max_depth {
        let found = prepared.search.closest_hit::<S, L::Objects>(&prepared.objects, &ray, from, &mut batch.stack);
        if !found.is_hit() {
            return leave(batch, gone, sample, prepared.background.color(ray.direction));
        }
        let surface = Surface::new(&prepared.objects, &ray, &found);
        let material_data = &prepared.materials[surface.material as usize];
        from = found.object;
        match surface.scatter_result(material_data, ray.direction) {
            ScatterResult::Along(direction) => ray = Ray { origin: surface.point, direction },
            ScatterResult::Around(base) => {
                let vertex = PathVertex::new(surface.point, base, f64::from(from), material_data);
                return queue.set(place, &vertex, prepared.max_depth - 1 - passed);
            }
        }
    }
    leave(batch, gone, sample, Vec3::ZERO);
}
