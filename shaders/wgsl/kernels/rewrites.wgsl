// Expressions that drivers are known to rewrite by the laws of real numbers, as they stand and without a barrier.

struct RewriteCase {
    x: real,
    y: real,
    z: real,
}

struct RewriteReport {
    // (x + y) - x, which is y for real numbers.
    sum_less_term: real,
    // x y + x z, which is x (y + z).
    common_factor: real,
    // sqrt(x) sqrt(x), which is x.
    root_squared: real,
}

@group(0) @binding(0) var<storage, read> cases: array<RewriteCase>;
@group(0) @binding(1) var<storage, read_write> reports: array<RewriteReport>;

@compute @workgroup_size(64)
fn rewrites(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let x = cases[id.x].x;
    let y = cases[id.x].y;
    let z = cases[id.x].z;
    let root = sqrt(x);
    reports[id.x] = RewriteReport((x + y) - x, x * y + x * z, root * root);
}
