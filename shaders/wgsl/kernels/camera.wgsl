// Each invocation computes the camera ray of one pixel.

struct CameraCase {
    position: PackedVec3,
    origin: PackedVec3,
    delta_x: PackedVec3,
    delta_y: PackedVec3,
    row: real,
    column: real,
    offset_x: real,
    offset_y: real,
}

@group(0) @binding(0) var<storage, read> cases: array<CameraCase>;
@group(0) @binding(1) var<storage, read_write> results: array<PackedRay>;

@compute @workgroup_size(64)
fn camera(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    let camera = Camera(
        vec3_load(this_case.position),
        vec3_load(this_case.origin),
        vec3_load(this_case.delta_x),
        vec3_load(this_case.delta_y),
    );
    let offset = vec2<real>(this_case.offset_x, this_case.offset_y);
    results[id.x] = ray_store(camera_ray(camera, this_case.row, this_case.column, offset));
}
