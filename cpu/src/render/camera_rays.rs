//! Intersects several camera rays at once with the span's candidates, and shades them.

use crate::render::{
    arrays::SAMPLES, frustum::Candidate, frustum::Candidates, hit_lanes::HitLanes, hit_lanes::Rays,
    lane_numbers::SampleIndex, max_depth::RaysLeft, path_vertex::PathVertex, shade::shade, span_state::SpanState,
};
use crate::{
    counters::Counter, counters::add, geometry::ray::Ray, layout::Layout, layout::Objects, math::real::Real,
    simd::Kernel, simd::Simd, simd::SimdF64, simd::valid_lanes,
};

/// A kernel that traces the camera rays of the batch, which are the first rays of the span's samples. If a ray hits no
/// object, its sample gets the colour of the background. If it hits a refractive surface, its sample goes to the
/// specular queue. If it hits a matte or metal surface, its sample goes to the path queue.
pub struct TraceCameraRays<'s, 'a, L: Layout>(pub &'s mut SpanState<'a, L>);

impl<L: Layout> Kernel for TraceCameraRays<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let SpanState { prepared, row, candidates, batch, tracer, .. } = self.0;
        let (batch, queue) = (&mut **batch, &mut tracer.queue);
        let camera = prepared.camera.lanes::<S::F64>();
        let background = prepared.background.lanes::<S::F64>();
        let row = S::F64::of(*row as f64);
        let rays = RaysLeft::after_camera_ray(prepared.max_depth).in_lanes();
        batch.specular.count = 0;
        queue.count = 0;
        add(Counter::CameraRays, batch.count as u64);
        add(Counter::CameraRayTests, (batch.count * candidates.span.len()) as u64);
        for at in (0..batch.count).step_by(S::F64::LANES) {
            let ray = camera.ray(row, S::F64::load(&batch.column[at..]), batch.offset.load(at));
            let valid = valid_lanes::<S::F64>(batch.count - at);
            let hits = closest_hit(&prepared.objects, candidates, &ray, valid);
            if hits.bits != valid {
                batch.color.store(at, background.color(ray.direction).to_array());
            }
            if hits.bits != 0 {
                let (vertex, refractive) = shade(prepared, &ray, &hits);
                let vertex = PathVertex { sample: SampleIndex(S::F64::load(&SAMPLES[at..])), rays, ..vertex };
                if refractive != 0 {
                    batch.specular.push(vertex.specular_numbers(), refractive);
                }
                if hits.bits != refractive {
                    queue.push(vertex.numbers(), hits.bits & !refractive);
                }
            }
        }
    }
}

/// Returns the closest hit of each ray among the candidates. `valid` has a bit for each lane that holds a ray.
#[inline(always)]
fn closest_hit<V: SimdF64, O: Objects>(objects: &O, candidates: &Candidates, ray: &Ray<V>, valid: u32) -> HitLanes<V> {
    let mut hits = HitLanes::none();
    if candidates.span.is_empty() {
        return hits;
    }
    let rays = Rays::new(objects, ray, valid);
    for (id, candidate) in &candidates.span {
        match candidate {
            Candidate::Sphere(record, view) => hits.intersect_sphere(*id, record, &view.lanes(), &rays),
            Candidate::Cylinder(record, file_axis, view) => {
                hits.intersect_cylinder(*id, (record, file_axis), &view.lanes(), &rays);
            }
        }
    }
    hits
}
