// The side and the caps of a cylinder without cancellation; twin of cpu/src/exact/cylinder_compensated.rs.

// side: returns the quadratic. `axis` is that of the scene file. The share is 2^-90.
fn exact_side_compensated(cylinder: CylinderRecord, axis: vec3<real>, ray: Ray) -> ExactSide {
    let difference = exact_difference(ray.origin, cylinder.center);
    let from_center = difference.rounded;
    let r_c = exact_cross(from_center, axis) + exact_cross(difference.error, axis);
    let direction = exact_cross(ray.direction, axis);
    let axis_squared = vec3_dot(axis, axis);
    let a = vec3_dot(direction, direction);
    let h = vec3_dot(direction, r_c);
    let r_c_squared = vec3_dot(r_c, r_c);
    let c = r_c_squared - cylinder.radius_squared * axis_squared;
    let far = vec3_dot(from_center, from_center) * real(8.077935669463161e-28);
    let squares = r_c_squared + (cylinder.radius_squared + far) * axis_squared;
    let bound = error_bound_new(exact_cylinder_limits(), a, squares);
    return ExactSide(
        bound,
        vec3_dot(ray.direction, ray.direction),
        a,
        exact_in_scale(axis_squared) && exact_in_scale(a) && exact_in_scale(squares),
        h,
        h * h - a * c,
        vec3_dot(from_center, cylinder.axis),
        vec3_dot(ray.direction, cylinder.axis),
    );
}

// plane: returns the plane of the cap around `center`. The share is 2^-40.
fn exact_plane_compensated(
    cylinder: CylinderRecord,
    axis: vec3<real>,
    ray: Ray,
    center: vec3<real>,
    is_top: bool,
) -> ExactPlane {
    let to_cap = select(-axis, axis, is_top);
    let from_middle = exact_difference(cylinder.center + cylinder.center, ray.origin + ray.origin);
    let twice = exact_difference(from_middle.rounded, -to_cap);
    let error = from_middle.error + twice.error;
    let along_x = exact_two_product(twice.rounded.x, axis.x);
    let along_y = exact_two_product(twice.rounded.y, axis.y);
    let along_z = exact_two_product(twice.rounded.z, axis.z);
    let first = exact_two_sum(along_x.sum, along_y.sum);
    let second = exact_two_sum(first.sum, along_z.sum);
    let products = along_x.error + along_y.error + along_z.error;
    let rest = (first.error + second.error) + products + vec3_dot(error, axis);
    let to_plane = (second.sum + rest) / (cylinder.half_height * real(4.0));
    let size = abs(to_plane) + exact_plane_size(cylinder, center - ray.origin) * real(9.094947017729282e-13);
    return exact_plane_at(cylinder, ray, center, to_plane, size);
}

// CompensatedPlanes::plane: returns the plain plane if that is accurate.
fn exact_plane_accurate(
    cylinder: CylinderRecord,
    axis: vec3<real>,
    ray: Ray,
    center: vec3<real>,
    is_top: bool,
) -> ExactPlane {
    let plain = exact_plane_new(cylinder, ray, center);
    if plain.fails || plain.accurate {
        return plain;
    }
    return exact_plane_compensated(cylinder, axis, ray, center, is_top);
}

// compensated: returns the hit, if rounding certainly has not changed it. `axis` is that of the scene file.
fn exact_cylinder_compensated(cylinder: CylinderRecord, axis: vec3<real>, ray: Ray) -> Decision {
    let side = exact_side_compensated(cylinder, axis, ray);
    if !side.a_is_accurate {
        return decision_uncertain();
    }
    let decision = exact_cylinder_without_caps(cylinder, ray, side);
    if !decision.needs_caps {
        return decision.decision;
    }
    let down = side.slope < real(0.0);
    let along = cylinder.axis * select(cylinder.half_height, -cylinder.half_height, down);
    let facing = exact_plane_accurate(cylinder, axis, ray, cylinder.center - along, down);
    let other = exact_plane_accurate(cylinder, axis, ray, cylinder.center + along, !down);
    return exact_cylinder_with_caps(cylinder, ray, decision.decision, facing, other, down);
}
