// Records every step of a pixel's path, for debug views and to compare two implementations step by step.

// A step: one ray of a path and its hit; twin of twin::steps::Step. All fields are numbers, so that one function
// can compare them all.
struct Step {
    // 1 if the ray hits an object, 0 if it escapes to the background, -1 after the end of the path.
    is_hit: real,
    lambda: real,
    object: real,
    part: real,
    front: real,
    material: real,
    origin: PackedVec3,
    direction: PackedVec3,
    point: PackedVec3,
    normal: PackedVec3,
    // The colour of the background, if the ray escapes.
    light: PackedVec3,
}

// Each invocation writes `max_depth` steps, in one run or in several. A run continues from the step of the last one.
@group(0) @binding(5) var<storage, read_write> ways: array<Step>;

@compute @workgroup_size(64)
fn steps(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.pixel_count {
        return;
    }
    let pixel = picture.first_pixel + id.x;
    let offset = vec2<real>(picture.offset_x, picture.offset_y);
    let scatter_vector = vec3_load(picture.scatter_vector);
    var ray = camera_ray(picture_camera(), real(pixel / picture.width), real(pixel % picture.width), offset);
    var ended = false;
    if picture.first_depth > 0u {
        let last = ways[id.x * max_depth + picture.first_depth - 1u];
        ended = last.is_hit != real(1.0);
        ray = Ray(vec3_load(last.origin), vec3_load(last.direction));
        if !ended {
            let hit = Hit(vec3_load(last.point), vec3_load(last.normal), last.front == real(1.0));
            ray = bounce_ray(ray, hit, material_load(materials[u32(last.material)]), scatter_vector);
        }
    }
    for (var depth = picture.first_depth; depth < min(max_depth, picture.end_depth); depth++) {
        // Chromium's SwiftShader keeps the values of the iteration before if the initial value is left out.
        var step = Step();
        if ended {
            step.is_hit = real(-1.0);
        } else {
            step.origin = vec3_store(ray.origin);
            step.direction = vec3_store(ray.direction);
            let surface = closest_hit(ray);
            if surface.some {
                step.is_hit = real(1.0);
                step.lambda = surface.lambda;
                step.object = real(surface.order);
                step.part = real(surface.part);
                step.front = select(real(0.0), real(1.0), surface.hit.front);
                step.material = real(surface.material);
                step.point = vec3_store(surface.hit.point);
                step.normal = vec3_store(surface.hit.normal);
                ray = bounce_ray(ray, surface.hit, material_load(materials[surface.material]), scatter_vector);
            } else {
                step.light = vec3_store(background_color(picture_background(), ray.direction));
                ended = true;
            }
        }
        // The program reports an error for a number that still has the bits of an output that was not written.
        if closest_hit_gave_up {
            step.is_hit = UNWRITTEN;
        }
        ways[id.x * max_depth + depth] = step;
    }
}
