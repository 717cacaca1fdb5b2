// Each invocation reflects one direction.

struct ReflectionCase {
    direction: PackedVec3,
    normal: PackedVec3,
}

@group(0) @binding(0) var<storage, read> cases: array<ReflectionCase>;
@group(0) @binding(1) var<storage, read_write> results: array<PackedVec3>;

@compute @workgroup_size(64)
fn reflection(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    results[id.x] = vec3_store(scatter_reflect(vec3_load(this_case.direction), vec3_load(this_case.normal)));
}
