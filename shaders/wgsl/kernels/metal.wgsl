// Each invocation scatters one ray at a metal surface.

struct MetalCase {
    direction: PackedVec3,
    normal: PackedVec3,
    vector: PackedVec3,
}

@group(0) @binding(0) var<storage, read> cases: array<MetalCase>;
@group(0) @binding(1) var<storage, read_write> results: array<PackedVec3>;

@compute @workgroup_size(64)
fn metal(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    let direction = vec3_load(this_case.direction);
    let normal = vec3_load(this_case.normal);
    results[id.x] = vec3_store(scatter_metal(direction, normal, vec3_load(this_case.vector)));
}
