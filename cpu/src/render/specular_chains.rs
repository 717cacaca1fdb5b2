//! Specular chains: rays through refractive surfaces. They need no random number, so they are traced before the paths,
//! up to the first matte or metal surface.

use crate::render::{
    hit_lanes::HitLanes, hit_lanes::Rays, lane_by_lane::for_each_lane, lane_numbers::ObjectNumber,
    lane_numbers::SampleIndex, limits::Limits, max_depth::RaysLeft, path_vertex::PathVertex, prepared::Prepared,
    samples::Batch, shade::shade, span_state::SpanState, surface_hit::SurfaceHit,
};
use crate::{
    accel::may_hit::conservative::ConservativeRay, accel::may_hit::conservative::is_too_short,
    accel::may_hit::target::Target, accel::object::ObjectId, accel::object::ObjectRef, accel::stack::Stack,
    counters::Counter, counters::add, geometry::ray::Ray, layout::Layout, layout::Objects, math::vec3::Vec3,
    simd::Kernel, simd::MOST_LANES, simd::Simd, simd::SimdF64, simd::columns::Columns, simd::valid_lanes,
};

/// A kernel that traces the samples of the specular queue until each hits a matte or metal surface, escapes, or is at
/// the maximum depth. The samples on matte or metal surfaces are merged into the path queue. All other samples get
/// their colours.
pub struct TraceSpecularChains<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>);

impl<L: Layout> Kernel for TraceSpecularChains<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let SpanState { prepared, batch, tracer, stack, .. } = self.0;
        if !prepared.chain_targets.is_empty() {
            let mut rays = RaysLeft::after_camera_ray(prepared.max_depth);
            while !rays.is_none() && batch.specular.count > 0 {
                if rays.pauses() && tracer.limits.is_stopped() {
                    break;
                }
                rays = rays.minus_one();
                step_all::<S, L>(prepared, batch, rays);
            }
            for at in 0..batch.specular.count {
                let [.., sample] = batch.specular.entries.get(at);
                batch.terminate(SampleIndex(sample));
            }
        } else {
            for at in 0..batch.specular.count {
                trace::<S, L>(prepared, &tracer.limits, (batch, at), stack);
            }
        }
        // All paths share one stream of scatter samples, from which they take in the order of their samples.
        tracer.queue.merge(&mut batch.chained, PathVertex::SAMPLE);
    }
}

/// Traces every chain to its next hit, as many at once as there are lanes. If the hit is refractive, the sample stays
/// in the specular queue. `rays` is the number of rays that a sample may still send from that hit.
#[inline(always)]
fn step_all<S: Simd, L: Layout>(prepared: &Prepared<L>, batch: &mut Batch, rays: RaysLeft) {
    let background = prepared.background.lanes::<S::F64>();
    let rays = rays.in_lanes();
    let count = std::mem::take(&mut batch.specular.count);
    add(Counter::SpecularRays, count as u64);
    for from in (0..count).step_by(S::F64::LANES) {
        let valid = valid_lanes::<S::F64>(count - from);
        let [x, y, z, dx, dy, dz, _, sample] = batch.specular.entries.load::<S::F64>(from);
        let ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
        let hits = closest_hit(&prepared.objects, &prepared.chain_targets, &ray, valid);
        let missed = valid & !hits.bits;
        if missed != 0 {
            let [x, y, z] = background.color(ray.direction).to_array();
            let colors = Columns::<4, MOST_LANES>::of_lanes([x, y, z, sample]);
            for_each_lane(missed, |lane| {
                let [x, y, z, sample] = colors.get(lane);
                batch.color.set(SampleIndex(sample).get(), [x, y, z]);
            });
        }
        if hits.bits != 0 {
            let (vertex, refractive) = shade(prepared, &ray, &hits);
            let vertex = PathVertex { sample: SampleIndex(sample), rays, ..vertex };
            // This overwrites only entries that have been loaded.
            batch.specular.push(vertex.specular_numbers(), refractive);
            batch.chained.push(vertex.numbers(), hits.bits & !refractive);
        }
    }
}

/// Returns the closest hit of each ray. An object is intersected only if at least one of the rays may hit it, because
/// neighbouring chains mostly miss the same objects. `valid` has a bit for each lane that holds a ray.
#[inline(always)]
fn closest_hit<V: SimdF64, O: Objects>(objects: &O, targets: &[Target], ray: &Ray<V>, valid: u32) -> HitLanes<V> {
    let mut hits = HitLanes::none();
    let rays = Rays::new(objects, ray, valid);
    let conservative = ConservativeRay::new(*ray);
    let too_short = V::bits(is_too_short(conservative.length_squared)) & valid;
    let (spheres, cylinders) = targets.split_at(objects.sphere_count().min(targets.len()));
    for (index, target) in spheres.iter().enumerate() {
        if (V::bits(conservative.sphere(&target.lanes())) & valid) | too_short != 0 {
            let (id, record) = (index as ObjectId, objects.sphere(index).record);
            hits.filtered_sphere(id, &record, &record.lanes().seen_from(ray.origin), &rays);
        }
    }
    for (index, target) in cylinders.iter().enumerate() {
        if (V::bits(conservative.cylinder(&target.lanes())) & valid) | too_short != 0 {
            let id = ObjectRef::Cylinder(index).number(spheres.len());
            let (record, file_axis) = (objects.cylinder(index).record, objects.file_axis(index));
            hits.filtered_cylinder(id, (&record, &file_axis), &record.lanes().seen_from(ray.origin), &rays);
        }
    }
    hits
}

/// Traces the chain at index `at` of the specular queue to its end. This serves structures that take one ray at a time.
#[inline(always)]
fn trace<S: Simd, L: Layout>(
    prepared: &Prepared<L>,
    limits: &Limits,
    (batch, at): (&mut Batch, usize),
    stack: &mut Stack,
) {
    let [x, y, z, dx, dy, dz, object, sample] = batch.specular.entries.get(at);
    let mut ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
    let (mut start_object, sample) = (ObjectNumber(object).id(), SampleIndex(sample));
    let mut rays = RaysLeft::after_camera_ray(prepared.max_depth);
    while !(rays.pauses() && (rays.is_none() || limits.is_stopped())) && !limits.stops_every_ray() {
        rays = rays.minus_one();
        let hit = prepared.accel.closest_hit::<S, L::Objects>(&prepared.objects, &ray, start_object, stack);
        if !hit.is_hit() {
            let color = prepared.background.color(ray.direction).to_array();
            return batch.color.set(sample.get(), color);
        }
        let surface_hit = SurfaceHit::new(&prepared.objects, &ray, &hit);
        let material = &prepared.materials[surface_hit.material as usize];
        let direction = material.unperturbed_direction(ray.direction, surface_hit.outward);
        if material.takes_scatter_sample() {
            let vertex = PathVertex::new(surface_hit.point, direction, ObjectNumber::of(hit.object), material);
            return batch.chained.push_one(PathVertex { sample, rays: rays.in_lanes(), ..vertex }.numbers());
        }
        start_object = hit.object;
        ray = Ray { origin: surface_hit.point, direction };
    }
    batch.terminate(sample);
}
