// Each invocation finds which of two spheres a ray hits first, in every step that compares two lambdas.

struct ExactOrderCase {
    ray: PackedRay,
    first: PackedVec3,
    first_radius: real,
    second: PackedVec3,
    second_radius: real,
}

// The answer of each step: 1 or 2 if the first or the second sphere certainly is closer, 0 if that is uncertain, and 3
// if the step does not find two hits.
struct ExactOrder {
    plain: real,
    doubled: real,
}

@group(0) @binding(0) var<storage, read> cases: array<ExactOrderCase>;
@group(0) @binding(1) var<storage, read_write> orders: array<ExactOrder>;

@compute @workgroup_size(64)
fn exact_order(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let ray = ray_load(cases[id.x].ray);
    let first = vec3_load(cases[id.x].first);
    let second = vec3_load(cases[id.x].second);
    let first_radius = cases[id.x].first_radius;
    let second_radius = cases[id.x].second_radius;
    let plain = array(
        exact_sphere_filtered(sphere_new(first, first_radius), ray),
        exact_sphere_filtered(sphere_new(second, second_radius), ray),
    );
    let doubled = array(
        precise_sphere_filtered(first, first_radius, ray),
        precise_sphere_filtered(second, second_radius, ray),
    );
    var order = ExactOrder(real(3.0), real(3.0));
    if plain[0].certain && plain[0].some && plain[1].certain && plain[1].some {
        order.plain = exact_order_code(
            order_is_certainly_closer(plain[0].lambda, plain[1].lambda),
            order_is_certainly_closer(plain[1].lambda, plain[0].lambda),
        );
    }
    if doubled[0].certain && doubled[0].some && doubled[1].certain && doubled[1].some {
        order.doubled = exact_order_code(
            order_is_certainly_closer_precisely(doubled[0].lambda, doubled[1].lambda),
            order_is_certainly_closer_precisely(doubled[1].lambda, doubled[0].lambda),
        );
    }
    orders[id.x] = order;
}

// Returns the number for an answer.
fn exact_order_code(first: bool, second: bool) -> real {
    return select(select(real(0.0), real(2.0), second), real(1.0), first);
}
