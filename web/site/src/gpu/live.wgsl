// The page's own kernels for the live view. They use the modules of shaders/wgsl.

// `number` counts the frames since the picture has changed, from 0.
struct Frame {
    number: u32,
}

@group(0) @binding(5) var<storage, read_write> sums: array<PackedVec3>;
@group(0) @binding(6) var<storage, read> frame: Frame;

// The state of this invocation's random generator.
var<private> random_state: u32;

// Returns the next random word: one step of a linear congruential generator and a permutation of its bits (PCG, O'Neill
// 2014). The live view needs speed and no period, so 32 bits are enough.
fn random_next() -> u32 {
    random_state = random_state * 747796405u + 2891336453u;
    let word = ((random_state >> ((random_state >> 28u) + 4u)) ^ random_state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Returns a random number in [low, high).
fn random_draw(low: real, high: real) -> real {
    return uniform_draw(vec2<u32>(random_next(), random_next()), low, high);
}

// Adds one sample of each pixel to its sum. Its random numbers follow the convention of the statement: a position in
// the pixel, and for each surface a vector in a cube. They are not the numbers of render-aos.
@compute @workgroup_size(64)
fn accumulate(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.pixel_count {
        return;
    }
    let pixel = picture.first_pixel + id.x;
    random_state = pixel * 1664525u + frame.number * 1013904223u;
    random_state = random_next() ^ frame.number;
    let half = real(0.5);
    let offset = vec2<real>(random_draw(-half, half), random_draw(-half, half));
    var ray = camera_ray(picture_camera(), real(pixel / picture.width), real(pixel % picture.width), offset);
    let first = id.x * max_depth;
    var attenuation_count = 0u;
    var escapes = false;
    for (var depth = 0u; depth < max_depth; depth++) {
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
            let extent = material.extent;
            vector = vec3<real>(
                random_draw(-extent, extent),
                random_draw(-extent, extent),
                random_draw(-extent, extent),
            );
        }
        ray = bounce_ray(ray, surface.hit, material, vector);
    }
    var color = vec3<real>();
    if escapes {
        color = bounce_attenuated(background_color(picture_background(), ray.direction), first, attenuation_count);
    }
    if frame.number > 0u {
        color = color + vec3_load(sums[pixel]);
    }
    sums[pixel] = vec3_store(color);
}
