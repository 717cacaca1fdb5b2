// Each invocation computes one product with its rounding error, and one multiply-add that rounds once.

struct MulAddCase {
    a: real,
    b: real,
    c: real,
}

struct MulAddReport {
    product: real,
    error: real,
    mul_add: real,
}

@group(0) @binding(0) var<storage, read> cases: array<MulAddCase>;
@group(0) @binding(1) var<storage, read_write> reports: array<MulAddReport>;

@compute @workgroup_size(64)
fn mul_add(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let this_case = cases[id.x];
    let product = exact_two_product(this_case.a, this_case.b);
    let sum = exact_mul_add(this_case.a, this_case.b, this_case.c);
    reports[id.x] = MulAddReport(product.sum, product.error, sum);
}
