//! Rays through refractive surfaces, which need no random number: followed ahead up to the first surface that does.

use crate::accel::choice::Accel;
use crate::accel::conservative::{ConservativeRay, is_too_short};
use crate::accel::object::{ObjectId, ObjectRef};
use crate::accel::small_scene::SmallScene;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::layout::{Layout, Objects};
use crate::math::real::Real;
use crate::math::vec3::Vec3;
use crate::render::hit_lanes::{HitLanes, Rays};
use crate::render::lane_by_lane::{LaneByLane, for_each_lane};
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::render::queue::PathQueue;
use crate::render::samples::Batch;
use crate::render::shade::shade;
use crate::render::surface::{ScatterResult, Surface};
use crate::simd::{Kernel, LaneMask, Simd, SimdF64, valid_lanes};

/// Traces the samples of the batch's specular queue until each hits a surface that scatters, escapes, or has used up
/// its depth. Those that scatter are merged into `paths`; the others get their colour.
pub struct Trace<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub batch: &'a mut Batch,
    pub paths: &'a mut PathQueue,
}

impl<L: Layout> Kernel for Trace<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let Self { prepared, batch, paths } = self;
        if let Accel::SmallScene(few) = &prepared.search {
            let mut rays = prepared.max_depth - 1;
            while rays > 0 && batch.specular.count > 0 {
                rays -= 1;
                step_all::<S, L>(prepared, few, batch, rays);
            }
            for at in 0..batch.specular.count {
                let [.., sample] = batch.specular.get(at);
                batch.color.set(sample.to_bits() as usize, Vec3::ZERO);
            }
        } else {
            // Not a closure: it would be compiled without the instruction set.
            for at in 0..batch.specular.count {
                trace::<S, L>(prepared, batch, at);
            }
        }
        // All paths share one stream of random vectors, which they take in the order of their samples.
        paths.merge(&mut batch.chained, PathVertex::SAMPLE);
    }
}

/// Takes every chain to its next hit, as many at once as there are lanes. Those that hit a refractive surface stay in
/// the specular queue. Each may send `rays` rays after that surface.
#[inline(always)]
fn step_all<S: Simd, L: Layout>(prepared: &Prepared<L>, few: &SmallScene, batch: &mut Batch, rays: u64) {
    let background = prepared.background.lanes::<S::F64>();
    let rays = S::F64::of(f64::from_bits(rays));
    let count = std::mem::take(&mut batch.specular.count);
    add(Counter::GlassRays, count as u64);
    for from in (0..count).step_by(S::F64::LANES) {
        let valid = valid_lanes::<S::F64>(count - from);
        let [x, y, z, dx, dy, dz, _, sample] = batch.specular.load::<S::F64>(from);
        let ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
        let hits = closest_hit(&prepared.objects, few, &ray, valid);
        let missed = valid & !hits.bits;
        if missed != 0 {
            let Vec3 { x, y, z } = background.color(ray.direction);
            let colors = LaneByLane::new([x, y, z, sample]);
            for_each_lane(missed, |lane| {
                let [x, y, z, sample] = colors.of(lane);
                batch.color.set(sample.to_bits() as usize, Vec3::new(x, y, z));
            });
        }
        if hits.bits != 0 {
            let shaded = shade(prepared, &ray, &hits);
            let vertex = PathVertex { sample, rays, ..shaded.vertex };
            // The entries that this overwrites have been loaded.
            batch.specular.push(vertex.specular_numbers(), shaded.refractive);
            batch.chained.push(vertex.numbers(), hits.bits & !shaded.refractive);
        }
    }
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
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => hits.intersect_candidate_sphere(id, &objects.sphere(index).record, &rays),
            ObjectRef::Cylinder(index) => {
                let record = objects.cylinder(index).record;
                hits.intersect_candidate_cylinder(id, (&record, &objects.axis(index)), &rays);
            }
        }
    }
    hits
}

/// Traces the chain at `at` of the specular queue alone, for structures that take one ray at a time.
#[inline(always)]
fn trace<S: Simd, L: Layout>(prepared: &Prepared<L>, batch: &mut Batch, at: usize) {
    let [x, y, z, dx, dy, dz, object, sample] = batch.specular.get(at);
    let mut ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
    let mut from = object as ObjectId;
    for passed in 1..prepared.max_depth {
        let found = prepared.search.closest_hit::<S, L::Objects>(&prepared.objects, &ray, from, &mut batch.stack);
        if !found.is_hit() {
            batch.color.set(sample.to_bits() as usize, prepared.background.color(ray.direction));
            return;
        }
        let surface = Surface::new(&prepared.objects, &ray, &found);
        let material_data = &prepared.materials[surface.material as usize];
        from = found.object;
        match surface.scatter_result(material_data, ray.direction) {
            ScatterResult::Along(direction) => ray = Ray { origin: surface.point, direction },
            ScatterResult::Around(base) => {
                let rays = f64::from_bits(prepared.max_depth - 1 - passed);
                let vertex = PathVertex::new(surface.point, base, f64::from(from), material_data);
                return batch.chained.push_one(PathVertex { sample, rays, ..vertex }.numbers());
            }
        }
    }
    batch.color.set(sample.to_bits() as usize, Vec3::ZERO);
}
