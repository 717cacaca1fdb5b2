// The plain formulas of ray and cylinder with their error bounds; twin of cpu/src/exact/cylinder.rs.

// cylinder::filtered: returns the hit, if rounding certainly has not changed it.
fn exact_cylinder_filtered(cylinder: CylinderRecord, ray: Ray) -> Decision {
    return exact_cylinder_decided(cylinder, ray, exact_side_new(cylinder, ray));
}

// cylinder::decided: the same with a quadratic of the side that may be more accurate.
fn exact_cylinder_decided(cylinder: CylinderRecord, ray: Ray, side: ExactSide) -> Decision {
    if !exact_in_scale(side.length_squared) {
        return decision_uncertain();
    }
    if error_bound_misses(side.bound, side.discriminant) {
        return decision_miss();
    }
    let root = sqrt(side.discriminant);
    let entry = exact_side_crossing(side, cylinder, ray, -side.h - root, root);
    let leaving = exact_side_crossing(side, cylinder, ray, -side.h + root, root);
    if entry.behind && leaving.straight {
        return decision_hit(leaving.lambda, SIDE);
    }
    if entry.hits {
        return decision_hit(entry.lambda, SIDE);
    }
    if !(exact_crossing_fails(entry) && (leaving.hits || exact_crossing_fails(leaving))) {
        return decision_uncertain();
    }
    if exact_crossing_passes_by(entry, leaving) {
        return decision_miss();
    }
    // The cap that faces the ray is hit first. The other one counts only if nothing else is hit.
    let down = side.slope < real(0.0);
    let half = select(cylinder.half_height, -cylinder.half_height, down);
    let along = cylinder.axis * half;
    let facing = exact_cap_filtered(cylinder, ray, cylinder.center - along, select(BOTTOM, TOP, down));
    if !facing.certain || facing.some {
        return facing;
    }
    if leaving.hits {
        return decision_hit(leaving.lambda, SIDE);
    }
    return exact_cap_filtered(cylinder, ray, cylinder.center + along, select(TOP, BOTTOM, down));
}
