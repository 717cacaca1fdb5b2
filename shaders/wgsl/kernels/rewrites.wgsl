// Expressions that some drivers rewrite by the laws of real numbers, written here without a barrier. The self-test
// gpu_check::rewrites compares their results with those of Rust.

struct RewriteCase {
    x: real,
    y: real,
    z: real,
    // Minus zero and NaN. They are loaded at run time, so that the driver does not know their values.
    minus_zero: real,
    not_a_number: real,
}

struct RewriteReport {
    // (x + y) - x, which is y for real numbers.
    sum_less_term: real,
    // x y + x z, which is x (y + z).
    common_factor: real,
    // sqrt(x) sqrt(x), which is x.
    root_squared: real,
    // -0 + 0, which is 0. A driver that drops the addition gives -0.
    zero_added: real,
    // 1 if NaN != NaN is true, as it must be; 0 if the driver assumes that every x is equal to itself.
    is_not_itself: real,
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
    let zero_added = cases[id.x].minus_zero + real(0.0);
    let is_not_itself = select(real(0.0), real(1.0), cases[id.x].not_a_number != cases[id.x].not_a_number);
    reports[id.x] = RewriteReport((x + y) - x, x * y + x * z, root * root, zero_added, is_not_itself);
}
