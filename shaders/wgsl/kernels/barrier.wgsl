// Each invocation computes one sum and its rounding error.

struct BarrierCase {
    a: real,
    b: real,
    one: real,
}

@group(0) @binding(0) var<storage, read> cases: array<BarrierCase>;
@group(0) @binding(1) var<storage, read_write> results: array<ExactSum>;

@compute @workgroup_size(64)
fn barrier(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    results[id.x] = exact_two_sum(this_case.a, this_case.b, this_case.one);
}
