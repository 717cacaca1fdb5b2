// Each invocation finds which of two spheres a ray hits first, by the lambdas of the plain formula.

struct ExactOrderCase {
    ray: PackedRay,
    first: PackedVec3,
    first_radius: real,
    second: PackedVec3,
    second_radius: real,
}

@group(0) @binding(0) var<storage, read> cases: array<ExactOrderCase>;
// 1 or 2 if the first or the second sphere certainly is closer, 0 if that is uncertain, and 3 if the formula does not
// find two hits.
@group(0) @binding(1) var<storage, read_write> orders: array<real>;

@compute @workgroup_size(64)
fn exact_order(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let ray = ray_load(cases[id.x].ray);
    let first_record = sphere_new(vec3_load(cases[id.x].first), cases[id.x].first_radius);
    let second_record = sphere_new(vec3_load(cases[id.x].second), cases[id.x].second_radius);
    let first = exact_sphere_filtered(first_record, ray);
    let second = exact_sphere_filtered(second_record, ray);
    var order = real(3.0);
    if first.certain && first.some && second.certain && second.some {
        let is_second = order_is_certainly_closer(second.lambda, first.lambda);
        let is_first = order_is_certainly_closer(first.lambda, second.lambda);
        order = select(select(real(0.0), real(2.0), is_second), real(1.0), is_first);
    }
    orders[id.x] = order;
}
