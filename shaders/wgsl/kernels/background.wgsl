// Each invocation computes the background of one direction.

struct BackgroundCase {
    dark: PackedVec3,
    light: PackedVec3,
    direction: PackedVec3,
}

@group(0) @binding(0) var<storage, read> cases: array<BackgroundCase>;
@group(0) @binding(1) var<storage, read_write> results: array<PackedVec3>;

@compute @workgroup_size(64)
fn background(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    let background = Background(vec3_load(this_case.dark), vec3_load(this_case.light));
    results[id.x] = vec3_store(background_color(background, vec3_load(this_case.direction)));
}
