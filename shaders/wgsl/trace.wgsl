// The colour that arrives along one path; twin of Path::color in cpu/src/reference.rs.

// Path::color: writes the colour that arrives along `primary`. `slot` is the invocation's index in `attenuations`,
// `paths` and `pixels`. Drivers limit the iterations of all loops of an invocation together (lavapipe: to 65,535), so a
// long path needs several runs. Each run continues where the last one ended.
fn trace_path(primary: Ray, slot: u32) {
    var ray = primary;
    let scatter_vector = vec3_load(picture.scatter_vector);
    let first = slot * max_depth;
    var attenuation_count = 0u;
    if picture.first_depth > 0u {
        if paths[slot].ended != 0u {
            return;
        }
        ray = ray_load(paths[slot].ray);
        attenuation_count = paths[slot].attenuation_count;
    }
    for (var depth = picture.first_depth; depth < min(max_depth, picture.end_depth); depth++) {
        let surface = closest_hit(ray);
        if !surface.some {
            let color = background_color(picture_background(), ray.direction);
            pixels[slot] = vec3_store(trace_attenuated(color, first, attenuation_count));
            paths[slot].ended = 1u;
            return;
        }
        let material = material_load(materials[surface.material]);
        if (has_matte && material.kind == MATTE) || (has_metal && material.kind == METAL) {
            attenuations[first + attenuation_count] = surface.material;
            attenuation_count++;
        }
        ray = scatter_ray(ray, surface.hit, material, scatter_vector);
    }
    // A path that has reached the maximum depth contributes black. If it has not, a later run writes the colour.
    pixels[slot] = vec3_store(vec3<real>());
    paths[slot] = PackedPath(ray_store(ray), attenuation_count, 0u);
}

// Returns the ray that a surface of `material` scatters when `ray` hits it at `hit`.
fn scatter_ray(ray: Ray, hit: Hit, material: Material, scatter_vector: vec3<real>) -> Ray {
    var direction: vec3<real>;
    if has_matte && material.kind == MATTE {
        direction = scatter_matte(hit.normal, scatter_vector);
    }
    if has_metal && material.kind == METAL {
        direction = scatter_metal(ray.direction, hit.normal, scatter_vector);
    }
    if has_refraction && material.kind == REFRACTIVE {
        let ratio = scatter_index_ratio(material.index, hit.front);
        direction = scatter_refract(ray.direction, hit.normal, ratio);
    }
    return Ray(hit.point, direction);
}

// Returns `color` attenuated by the surfaces of the path, from the last to the first, as the specification's recursion
// does. Their materials start at `first` in `attenuations`.
fn trace_attenuated(color: vec3<real>, first: u32, attenuation_count: u32) -> vec3<real> {
    var attenuated = color;
    for (var left = attenuation_count; left > 0u; left--) {
        attenuated = attenuated * vec3_load(materials[attenuations[first + left - 1u]].reflectance);
    }
    return attenuated;
}
