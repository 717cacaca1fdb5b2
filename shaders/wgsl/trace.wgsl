// One ray's way through the scene; twin of Path::color in cpu/src/reference.rs.

// Path::color: writes the colour that arrives along `primary`; `slot` is the invocation's place in `met`, `paths` and
// `pixels`. Drivers bound the iterations that the loops of an invocation may have together (lavapipe: 65,535), so a
// long way takes several runs, each of which goes on where the last one ended.
fn trace_path(primary: Ray, slot: u32) {
    var ray = primary;
    let scatter_vector = vec3_load(picture.scatter_vector);
    let first = slot * max_depth;
    var met_count = 0u;
    if picture.first_depth > 0u {
        if paths[slot].ended != 0u {
            return;
        }
        ray = ray_load(paths[slot].ray);
        met_count = paths[slot].met_count;
    }
    for (var depth = picture.first_depth; depth < min(max_depth, picture.end_depth); depth++) {
        let surface = nearest_hit(ray);
        if !surface.some {
            let color = background_color(picture_background(), ray.direction);
            pixels[slot] = vec3_store(trace_attenuated(color, first, met_count));
            paths[slot].ended = 1u;
            return;
        }
        let material = material_load(materials[surface.material]);
        if (has_matte && material.kind == MATTE) || (has_metal && material.kind == METAL) {
            met[first + met_count] = surface.material;
            met_count++;
        }
        ray = trace_onward(ray, surface.hit, material, scatter_vector);
    }
    // Black, unless another run goes on.
    pixels[slot] = vec3_store(vec3<real>());
    paths[slot] = PackedPath(ray_store(ray), met_count, 0u);
}

// Onward: the ray that a surface of `material` sends on when `ray` meets it at `hit`.
fn trace_onward(ray: Ray, hit: Hit, material: Material, scatter_vector: vec3<real>) -> Ray {
    var direction: vec3<real>;
    if has_matte && material.kind == MATTE {
        direction = scatter_matte(hit.normal, scatter_vector);
    }
    if has_metal && material.kind == METAL {
        direction = scatter_metal(ray.direction, hit.normal, scatter_vector);
    }
    if has_refraction && material.kind == REFRACTIVE {
        var ratio = material.index;
        if hit.front {
            ratio = real(1.0) / material.index;
        }
        direction = scatter_refract(ray.direction, hit.normal, ratio);
    }
    return Ray(hit.point, direction);
}

// `color` after all surfaces met, from the last to the first, as the recursion returns.
fn trace_attenuated(color: vec3<real>, first: u32, met_count: u32) -> vec3<real> {
    var attenuated = color;
    for (var left = met_count; left > 0u; left--) {
        attenuated = attenuated * vec3_load(materials[met[first + left - 1u]].reflectance);
    }
    return attenuated;
}
