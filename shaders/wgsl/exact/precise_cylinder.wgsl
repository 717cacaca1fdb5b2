// The formulas of exact/cap.wgsl and exact/cylinder.wgsl in double-double.

// cap::filtered: the factors are 8 and 16 times 2^-102, and 4 and 8 times the condition limit 65,536 * 2^24.
fn precise_cap_filtered(
    cylinder: PreciseCylinder,
    origin: DoubleDouble3,
    direction: DoubleDouble3,
    center: DoubleDouble3,
    part: u32,
) -> PreciseDecision {
    let parallel = dd_of(real(1e-8));
    let to_center = dd3_sub(center, origin);
    let to_plane = dd3_dot(to_center, cylinder.axis);
    let slope = dd3_dot(direction, cylinder.axis);
    let steepness = dd_abs(slope);
    let size_of_direction = dd3_magnitude(direction);
    let slope_error = dd_mul(size_of_direction, dd_of(real(1.5777218104420236e-30)));
    if dd_less(dd_add(steepness, slope_error), parallel) {
        return precise_miss();
    }
    let steep = dd_less(dd_add(parallel, slope_error), steepness);
    var distance = to_plane;
    if dd_less(slope, dd_of(real(0.0))) {
        distance = dd_neg(to_plane);
    }
    let size = dd_add(precise_extent_of_axis(cylinder), dd3_magnitude(to_center));
    let farthest = dd_add(distance, dd_mul(size, dd_of(real(3.1554436208840472e-30))));
    if steep && dd_less(farthest, dd_mul(dd_sub(steepness, slope_error), precise_least_lambda())) {
        return precise_miss();
    }
    let lambda = dd_div(to_plane, slope);
    let accurate = dd_less(size, dd_mul(distance, dd_of(real(4398046511104.0))))
        && dd_less(size_of_direction, dd_mul(steepness, dd_of(real(8796093022208.0))));
    let is_in_range = accurate && precise_in_range(precise_cylinder_limits(), lambda);
    let from_center = dd3_sub(dd3_add(origin, dd3_scaled(direction, lambda)), center);
    let off_center = dd_sqrt(dd3_dot(from_center, from_center));
    let margin = precise_cylinder_margin(cylinder, direction, lambda);
    if steep && is_in_range && dd_less(off_center, dd_sub(cylinder.radius, margin)) {
        return precise_hit(lambda, part);
    }
    if steep && is_in_range && dd_less(dd_add(cylinder.radius, margin), off_center) {
        return precise_miss();
    }
    return precise_uncertain();
}

// cylinder::filtered::<DoubleDouble>: returns the hit, if rounding certainly has not changed it. `axis` is that of the
// scene file, so the record is made from it in double-double.
fn precise_cylinder_filtered(center: vec3<real>, radius: real, axis: vec3<real>, ray: Ray) -> PreciseDecision {
    let cylinder = precise_cylinder_new(center, radius, axis);
    let origin = dd3_of(ray.origin);
    let direction = dd3_of(ray.direction);
    let side = precise_side_new(cylinder, origin, direction);
    if !precise_in_scale(side.length_squared) {
        return precise_uncertain();
    }
    if precise_bound_misses(side.bound, side.discriminant) {
        return precise_miss();
    }
    let root = dd_sqrt(side.discriminant);
    let entry = precise_side_crossing(side, cylinder, direction, dd_sub(dd_neg(side.h), root), root);
    let leaving = precise_side_crossing(side, cylinder, direction, dd_add(dd_neg(side.h), root), root);
    if entry.behind && leaving.straight {
        return precise_hit(leaving.lambda, SIDE);
    }
    if entry.hits {
        return precise_hit(entry.lambda, SIDE);
    }
    if !(precise_crossing_fails(entry) && (leaving.hits || precise_crossing_fails(leaving))) {
        return precise_uncertain();
    }
    if precise_crossing_passes_by(entry, leaving) {
        return precise_miss();
    }
    let down = dd_less(side.slope, dd_of(real(0.0)));
    var half = cylinder.half_height;
    if down {
        half = dd_neg(half);
    }
    let along = dd3_scaled(cylinder.axis, half);
    let below = dd3_sub(cylinder.center, along);
    let facing = precise_cap_filtered(cylinder, origin, direction, below, select(BOTTOM, TOP, down));
    if !facing.certain || facing.some {
        return facing;
    }
    if leaving.hits {
        return precise_hit(leaving.lambda, SIDE);
    }
    let other = dd3_add(cylinder.center, along);
    return precise_cap_filtered(cylinder, origin, direction, other, select(TOP, BOTTOM, down));
}
