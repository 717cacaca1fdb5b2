// The colour that arrives along the path of one sample, with random numbers; twin of Path::color and of the loop over
// samples in cpu/src/reference.rs.

// The state of a sample's path between two runs, as PackedPath in trace.wgsl. `next_word` is the index of the next word
// of the scatter stream. `unused` makes the size a multiple of 8 bytes, as f64 needs it.
struct PackedSamplePath {
    ray: PackedRay,
    attenuation_count: u32,
    ended: u32,
    next_word: u32,
    unused: u32,
}

// The result of each sample.
@group(0) @binding(5) var<storage, read_write> traced_samples: array<TracedSample>;
// The state of each sample's path between two runs.
@group(0) @binding(6) var<storage, read_write> sample_paths: array<PackedSamplePath>;

// Returns the camera ray of sample number `slot` of this run. The position in the pixel takes two words: x, then y.
fn sample_camera_ray(slot: u32) -> Ray {
    let pixel = picture.first_pixel + (picture.first_sample + slot) / picture.samples_per_pixel;
    let half = real(0.5);
    let x = uniform_draw(words[3u * slot], -half, half);
    let y = uniform_draw(words[3u * slot + 1u], -half, half);
    let row = real(pixel / picture.width);
    let column = real(pixel % picture.width);
    return camera_ray(picture_camera(), row, column, vec2<real>(x, y));
}

// Path::color: traces the path of sample number `slot` of this run, at the depths of this run. Writes the colour that
// arrives along the path, and the number of words that the path took, once both are known.
fn trace_sample(slot: u32) {
    let first_word = words[3u * slot + 2u].x;
    let first = slot * max_depth;
    var ray: Ray;
    var next_word = first_word;
    var attenuation_count = 0u;
    var escapes = false;
    if picture.first_depth > 0u {
        if sample_paths[slot].ended != 0u {
            return;
        }
        ray = ray_load(sample_paths[slot].ray);
        next_word = sample_paths[slot].next_word;
        attenuation_count = sample_paths[slot].attenuation_count;
    } else {
        ray = sample_camera_ray(slot);
    }
    for (var depth = picture.first_depth; depth < min(max_depth, picture.end_depth); depth++) {
        let surface = closest_hit(ray);
        if !surface.some {
            escapes = true;
            break;
        }
        let material = material_load(materials[surface.material]);
        var vector = vec3<real>();
        if bounce_attenuates(material) {
            attenuations[first + attenuation_count] = surface.material;
            attenuation_count++;
            let scatter_vector = scatter_vector_next(next_word, material.extent);
            vector = scatter_vector.vector;
            next_word = scatter_vector.next_word;
        }
        ray = bounce_ray(ray, surface.hit, material, vector);
    }
    // A path that escapes gets the attenuated background, and one that has reached the maximum depth gets black. Every
    // other path gets black here, and a later run writes its result.
    var color = vec3<real>();
    if escapes {
        color = bounce_attenuated(background_color(picture_background(), ray.direction), first, attenuation_count);
    }
    traced_samples[slot] = TracedSample(vec3_store(color), next_word - first_word, 0u);
    sample_paths[slot] =
        PackedSamplePath(ray_store(ray), attenuation_count, select(0u, 1u, escapes), next_word, 0u);
}
