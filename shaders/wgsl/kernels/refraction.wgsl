// Each invocation refracts one direction.

struct RefractionCase {
    direction: PackedVec3,
    normal: PackedVec3,
    ratio: real,
}

@group(0) @binding(0) var<storage, read> cases: array<RefractionCase>;
@group(0) @binding(1) var<storage, read_write> results: array<PackedVec3>;

@compute @workgroup_size(64)
fn refraction(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    let direction = vec3_load(this_case.direction);
    let normal = vec3_load(this_case.normal);
    results[id.x] = vec3_store(scatter_refract(direction, normal, this_case.ratio));
}
