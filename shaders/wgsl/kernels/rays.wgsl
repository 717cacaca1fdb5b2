// The closest hits of given rays. It uses the buffers of a picture: `paths` has the rays, and each pixel gets the
// lambda, the order and the part of a hit, or minus one three times.

@compute @workgroup_size(64)
fn rays(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.pixel_count {
        return;
    }
    let surface = closest_hit(ray_load(paths[id.x].ray));
    var report = vec3<real>(real(-1.0));
    if surface.some {
        report = vec3<real>(surface.lambda, real(surface.order), real(surface.part));
    }
    if closest_hit_gave_up {
        report = vec3<real>(UNWRITTEN);
    }
    pixels[id.x] = vec3_store(report);
}
