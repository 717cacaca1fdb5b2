// Each invocation scatters one ray at a matte surface.

struct MatteCase {
    normal: PackedVec3,
    vector: PackedVec3,
}

@group(0) @binding(0) var<storage, read> cases: array<MatteCase>;
@group(0) @binding(1) var<storage, read_write> results: array<PackedVec3>;

@compute @workgroup_size(64)
fn matte(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    results[id.x] = vec3_store(scatter_matte(vec3_load(this_case.normal), vec3_load(this_case.vector)));
}
