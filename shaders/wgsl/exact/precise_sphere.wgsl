// The formula of exact/sphere.wgsl in double-double.

// LIMITS: the error constant 32 times 2^-102, the reciprocal of the condition limit 12,288 * 2^24, and 10^-3 times
// 256 * 12,288 * 2^24 * 2^-102.
fn precise_sphere_limits() -> PreciseLimits {
    return PreciseLimits(real(6.310887241768095e-30), real(4.850638409455617e-12), real(1.0408340855860843e-20));
}

// sphere_filter::filtered::<DoubleDouble>: returns the hit, if rounding certainly has not changed it.
fn precise_sphere_filtered(center: vec3<real>, radius: real, ray: Ray) -> PreciseDecision {
    let direction = dd3_of(ray.direction);
    let a = dd3_dot(direction, direction);
    let radius_squared = dd_mul(dd_of(radius), dd_of(radius));
    let r_c = dd3_sub(dd3_of(center), dd3_of(ray.origin));
    let distance_squared = dd3_dot(r_c, r_c);
    let c = dd_sub(distance_squared, radius_squared);
    let h = dd3_dot(direction, r_c);
    let discriminant = dd_sub(dd_mul(h, h), dd_mul(a, c));
    let bound = precise_bound_new(precise_sphere_limits(), a, dd_add(distance_squared, radius_squared));
    if !precise_in_scale(a) {
        return precise_uncertain();
    }
    if precise_bound_misses(bound, discriminant) {
        return precise_miss();
    }
    let root = dd_sqrt(discriminant);
    let near = precise_bound_root(bound, a, dd_sub(h, root), root);
    if !near.fails && near.hits {
        return precise_hit(near.lambda, SIDE);
    }
    let far = precise_bound_root(bound, a, dd_add(h, root), root);
    if near.fails && far.hits {
        return precise_hit(far.lambda, SIDE);
    }
    if far.fails {
        return precise_miss();
    }
    return precise_uncertain();
}
