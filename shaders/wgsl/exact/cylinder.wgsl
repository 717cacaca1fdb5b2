// The plain formulas of ray and cylinder with their error bounds; twin of cpu/src/exact/cylinder.rs.

// What the side alone decides. If the caps are needed, the decision is the hit where the ray leaves the side, or a
// miss.
struct ExactWithoutCaps {
    needs_caps: bool,
    decision: Decision,
}

// The part of cylinder::filtered and of SideLanes::without_caps that follows the crossings.
fn exact_cylinder_without_caps(crossings: ExactCrossings) -> ExactWithoutCaps {
    let entry = crossings.entry;
    let leaving = crossings.leaving;
    if crossings.misses {
        return ExactWithoutCaps(false, decision_miss());
    }
    if entry.behind && leaving.straight {
        return ExactWithoutCaps(false, decision_hit(leaving.lambda, SIDE));
    }
    if entry.hits {
        return ExactWithoutCaps(false, decision_hit(entry.lambda, SIDE));
    }
    if !(exact_crossing_fails(entry) && (leaving.hits || exact_crossing_fails(leaving))) {
        return ExactWithoutCaps(false, decision_uncertain());
    }
    if exact_crossing_passes_by(entry, leaving) {
        return ExactWithoutCaps(false, decision_miss());
    }
    if leaving.hits {
        return ExactWithoutCaps(true, decision_hit(leaving.lambda, SIDE));
    }
    return ExactWithoutCaps(true, decision_miss());
}

// The end of cylinder::filtered and of SideLanes::with_caps. The cap that faces the ray is hit first. The other cap
// counts only if nothing else is hit. `leaving` is the hit where the ray leaves the side, or a miss.
fn exact_cylinder_with_caps(
    cylinder: CylinderRecord,
    ray: Ray,
    leaving: Decision,
    facing: ExactPlane,
    other: ExactPlane,
    down: bool,
) -> Decision {
    let first = exact_cap_filtered(cylinder, ray, facing, select(BOTTOM, TOP, down));
    if !first.certain || first.some {
        return first;
    }
    if leaving.some {
        return leaving;
    }
    return exact_cap_filtered(cylinder, ray, other, select(TOP, BOTTOM, down));
}

// cylinder::filtered: returns the hit, if rounding certainly has not changed it.
fn exact_cylinder_filtered(cylinder: CylinderRecord, ray: Ray) -> Decision {
    let side = exact_side_new(cylinder, ray);
    if !exact_in_scale(side.length_squared) {
        return decision_uncertain();
    }
    let decision = exact_cylinder_without_caps(exact_side_crossings(side, cylinder, ray));
    if !decision.needs_caps {
        return decision.decision;
    }
    let down = side.slope < real(0.0);
    let along = cylinder.axis * select(cylinder.half_height, -cylinder.half_height, down);
    let facing = exact_plane_new(cylinder, ray, cylinder.center - along);
    let other = exact_plane_new(cylinder, ray, cylinder.center + along);
    return exact_cylinder_with_caps(cylinder, ray, decision.decision, facing, other, down);
}
