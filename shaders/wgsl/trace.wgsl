// The colour that arrives along one path in deterministic mode; twin of Paths::color in cpu/src/reference.rs.

// The state of a path between two runs: its next ray, and the number of its attenuations so far. `ended` is 1 if the
// path has ended and the colour of its pixel has been written.
struct PackedPath {
    ray: PackedRay,
    attenuation_count: u32,
    ended: u32,
}

// The linear colour of each pixel.
@group(0) @binding(5) var<storage, read_write> pixels: array<PackedVec3>;
// The state of each invocation's path between two runs.
@group(0) @binding(6) var<storage, read_write> paths: array<PackedPath>;

// Path::color: writes the colour that arrives along `primary`. `slot` is the invocation's index in `attenuations`,
// `paths` and `pixels`. Drivers limit the iterations of all loops of an invocation together (lavapipe: to 65,535), so a
// long path needs several runs. Each run continues where the last one ended.
fn trace_path(primary: Ray, slot: u32) {
    var ray = primary;
    let scatter_vector = vec3_load(picture.scatter_vector);
    let first = slot * max_depth;
    var attenuation_count = 0u;
    var escapes = false;
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
            escapes = true;
            break;
        }
        let material = material_load(materials[surface.material]);
        if bounce_attenuates(material) {
            attenuations[first + attenuation_count] = surface.material;
            attenuation_count++;
        }
        ray = bounce_ray(ray, surface.hit, material, scatter_vector);
    }
    // A path that escapes gets the attenuated background, and one that has reached the maximum depth gets black. Every
    // other path gets black here, and a later run writes its colour.
    var color = vec3<real>();
    if escapes {
        color = bounce_attenuated(background_color(picture_background(), ray.direction), first, attenuation_count);
    }
    pixels[slot] = vec3_store(color);
    paths[slot] = PackedPath(ray_store(ray), attenuation_count, select(0u, 1u, escapes));
}
