// One bounce of a path, and the attenuation by all bounces; twin of Paths::scatter in cpu/src/reference.rs.

// The materials that attenuate each invocation's path, from the first hit on. Each invocation has max_depth entries.
@group(0) @binding(4) var<storage, read_write> attenuations: array<u32>;

// Returns whether a surface of `material` attenuates the colour and takes a scatter vector. A refractive surface does
// neither.
fn bounce_attenuates(material: Material) -> bool {
    return (has_matte && material.kind == MATTE) || (has_metal && material.kind == METAL);
}

// Returns the ray that a surface of `material` scatters when `ray` hits it at `hit`.
fn bounce_ray(ray: Ray, hit: Hit, material: Material, scatter_vector: vec3<real>) -> Ray {
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
fn bounce_attenuated(color: vec3<real>, first: u32, attenuation_count: u32) -> vec3<real> {
    var attenuated = color;
    for (var left = attenuation_count; left > 0u; left--) {
        attenuated = attenuated * vec3_load(materials[attenuations[first + left - 1u]].reflectance);
    }
    return attenuated;
}
