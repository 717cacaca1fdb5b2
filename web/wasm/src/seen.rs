//! What the ray through the middle of each pixel hits, by the exact intersections, for the views of the page.

use cpu::internals::Prepared;
use cpu::internals::accel::object::{NO_OBJECT, file_index_of};
use cpu::internals::accel::stack::Stack;
use cpu::internals::geometry::ray::front_and_normal;
use cpu::internals::render::surface_hit::SurfaceHit;
use cpu::internals::simd::portable::Portable;
use cpu::{Aos, Ray};

/// The numbers of a pixel: the distance in scene units, the normal on the camera's side, the number of the object in
/// the scene, and the rays of the path without scattering. All but the last are NaN if the ray hits nothing.
pub type Seen = [f64; 6];

/// Calls `add` with the numbers of each pixel.
pub fn each(prepared: &Prepared<Aos>, mut add: impl FnMut(Seen)) {
    let (objects, width) = (&prepared.objects, prepared.size.width());
    let mut stack = Stack::EMPTY;
    for index in 0..prepared.size.pixels() {
        let mut ray = prepared.camera.ray((index / width) as f64, (index % width) as f64, [0.0; 2]);
        let (mut start, mut seen) = (NO_OBJECT, [f64::NAN, f64::NAN, f64::NAN, f64::NAN, f64::NAN, 0.0]);
        for _ in 0..prepared.max_depth {
            seen[5] += 1.0;
            let hit = prepared.accel.closest_hit::<Portable, _>(objects, &ray, start, &mut stack);
            if !hit.is_hit() {
                break;
            }
            let surface = SurfaceHit::new(objects, &ray, &hit);
            if start == NO_OBJECT {
                let [x, y, z] = front_and_normal(ray.direction, surface.outward.unit()).1.to_array();
                let distance = hit.lambda * ray.direction.length();
                seen = [distance, x, y, z, f64::from(file_index_of(objects, hit.object)), seen[5]];
            }
            let material = &prepared.materials[surface.material as usize];
            let direction = material.unperturbed_direction(ray.direction, surface.outward);
            (ray, start) = (Ray { origin: surface.point, direction }, hit.object);
        }
        add(seen);
    }
}
