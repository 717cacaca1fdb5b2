// The plain formula of ray and sphere with its error bound; twin of cpu/src/exact/sphere_filter.rs.

// LIMITS: the error constant 32 times 2^-53, the reciprocal of the condition limit 12,288, and 10^-3 times one minus
// and plus 256 * 12,288 * 2^-53.
fn exact_sphere_limits() -> Limits {
    let error = real(3.552713678800501e-15);
    let share = real(8.138020833333333e-05);
    return Limits(error, share, real(0.000999999999650754), real(0.001000000000349246));
}

// |C - O|^2 + r^2, which only the error bound needs.
fn exact_sphere_squares(sphere: SphereRecord, r_c: vec3<real>) -> real {
    return vec3_dot(r_c, r_c) + sphere.radius_squared;
}

// sphere_filter::filtered: returns the hit, if rounding certainly has not changed it.
fn exact_sphere_filtered(sphere: SphereRecord, ray: Ray) -> Decision {
    let a = vec3_dot(ray.direction, ray.direction);
    let view = sphere_seen_from(sphere, ray.origin);
    let quadratic = sphere_quadratic(view, ray.direction, a);
    let squares = exact_sphere_squares(sphere, view.r_c);
    let bound = error_bound_of_size(exact_sphere_limits(), a * squares, a * squares, squares);
    if !exact_in_scale(a) {
        return decision_uncertain();
    }
    if error_bound_misses(bound, quadratic.discriminant) {
        return decision_miss();
    }
    let root = sqrt(quadratic.discriminant);
    let near = error_bound_root(bound, a, quadratic.h - root, root);
    // Bounds of both kinds may hold for a root at the limit. Then the root is too small.
    if !near.fails && near.hits {
        return decision_hit(near.lambda, SIDE);
    }
    let far = error_bound_root(bound, a, quadratic.h + root, root);
    if near.fails && far.hits {
        return decision_hit(far.lambda, SIDE);
    }
    // If the larger root is too small, the smaller one is too.
    if far.fails {
        return decision_miss();
    }
    return decision_uncertain();
}
