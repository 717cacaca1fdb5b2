// The plain formulas of ray and cylinder with their error bounds; twin of cpu/src/exact/cylinder.rs.

// What the side alone decides. If the caps are needed, the decision is the hit where the ray leaves the side, or a
// miss. It is uncertain if only a hit with a cap is certain.
struct ExactWithoutCaps {
    needs_caps: bool,
    decision: Decision,
}

// decide: returns what the crossings decide. `inside` tells whether the ray certainly starts inside the infinite
// cylinder.
fn exact_cylinder_without_caps(crossings: ExactCrossings, inside: bool) -> ExactWithoutCaps {
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
    let fails = exact_crossing_fails(entry);
    if fails && exact_crossing_passes_by(entry, leaving) {
        return ExactWithoutCaps(false, decision_miss());
    }
    if !(fails && (leaving.hits || exact_crossing_fails(leaving))) {
        return ExactWithoutCaps(inside, decision_uncertain());
    }
    if leaving.hits {
        return ExactWithoutCaps(true, decision_hit(leaving.lambda, SIDE));
    }
    return ExactWithoutCaps(true, decision_miss());
}

// with_caps: returns the closest hit with a cap or with the side. The cap that faces the ray is hit first. The other
// cap counts only if nothing else is hit. `leaving` is the hit where the ray leaves the side, or a miss. If it is
// uncertain, only a hit with a cap is certain.
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
    let last = exact_cap_filtered(cylinder, ray, other, select(TOP, BOTTOM, down));
    if last.certain && !last.some {
        return leaving;
    }
    return last;
}

// cylinder::filtered: returns the hit, if rounding certainly has not changed it.
fn exact_cylinder_filtered(cylinder: CylinderRecord, ray: Ray) -> Decision {
    let side = exact_side_new(cylinder, ray);
    if !exact_in_scale(side.length_squared) {
        return decision_uncertain();
    }
    let decision = exact_cylinder_without_caps(exact_side_crossings(side, cylinder, ray), side.inside);
    if !decision.needs_caps {
        return decision.decision;
    }
    let down = side.slope < real(0.0);
    let along = cylinder.axis * select(cylinder.half_height, -cylinder.half_height, down);
    let facing = exact_plane_new(cylinder, ray, cylinder.center - along);
    let other = exact_plane_new(cylinder, ray, cylinder.center + along);
    return exact_cylinder_with_caps(cylinder, ray, decision.decision, facing, other, down);
}
