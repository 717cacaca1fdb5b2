// Each invocation computes one sum and its rounding error.

struct TwoSumCase {
    a: real,
    b: real,
}

@group(0) @binding(0) var<storage, read> cases: array<TwoSumCase>;
@group(0) @binding(1) var<storage, read_write> results: array<ExactSum>;

@compute @workgroup_size(64)
fn two_sum(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    results[id.x] = exact_two_sum(this_case.a, this_case.b);
}
