// A cap of a cylinder with its error bound; twin of the cap in cpu/src/exact/cylinder_decision.rs.

// Plane: the plane of a cap and one ray, with what is certain before lambda is computed.
struct ExactPlane {
    center: vec3<real>,
    to_plane: real,
    slope: real,
    fails: bool,
    steep: bool,
    accurate: bool,
    // Twice the bound of the relative error of an accepted lambda, or more.
    error: real,
}

// Plane::new: returns the plane of the cap around `center`.
fn exact_plane_new(cylinder: CylinderRecord, ray: Ray, center: vec3<real>) -> ExactPlane {
    let to_center = center - ray.origin;
    let to_plane = vec3_dot(to_center, cylinder.axis);
    return exact_plane_at(cylinder, ray, center, to_plane, exact_plane_size(cylinder, to_center));
}

// Plane::size: returns the size of the terms that cancel in the distance of a cap's plane.
fn exact_plane_size(cylinder: CylinderRecord, to_center: vec3<real>) -> real {
    return exact_reach_of_axis(cylinder) + exact_magnitude(to_center);
}

// Plane::at: returns the plane for its distance. The factors are 8 and 16 times 2^-53, and 4 and 8 times the condition
// limit 65,536.
fn exact_plane_at(
    cylinder: CylinderRecord,
    ray: Ray,
    center: vec3<real>,
    to_plane: real,
    size: real,
) -> ExactPlane {
    let slope = vec3_dot(ray.direction, cylinder.axis);
    let steepness = abs(slope);
    let size_of_direction = exact_magnitude(ray.direction);
    let slope_error = size_of_direction * real(8.881784197001252e-16);
    let parallel = steepness + slope_error < real(1e-8);
    let steep = real(1e-8) + slope_error < steepness;
    let distance = select(to_plane, -to_plane, slope < real(0.0));
    let distance_error = size * real(1.7763568394002505e-15);
    let too_near = distance + distance_error < (steepness - slope_error) * real(1e-3);
    let accurate = size < distance * real(262144.0) && size_of_direction < steepness * real(524288.0);
    let fails = parallel || (steep && too_near);
    return ExactPlane(center, to_plane, slope, fails, steep, accurate, exact_cylinder_lambda_error());
}

// filtered_cap: returns the hit with the cap in `plane`, which has the name `part`, if rounding certainly has not
// changed it.
fn exact_cap_filtered(cylinder: CylinderRecord, ray: Ray, plane: ExactPlane, part: u32) -> Decision {
    if plane.fails {
        return decision_miss();
    }
    let lambda = plane.to_plane / plane.slope;
    let is_in_range = plane.accurate && exact_cylinder_limits().most <= lambda;
    let from_center = vec3_length(ray_at(ray, lambda) - plane.center);
    let margin = exact_cylinder_margin(cylinder, ray, lambda * plane.error);
    if plane.steep && is_in_range && from_center < cylinder.radius - margin {
        return decision_hit(lambda, part);
    }
    if plane.steep && is_in_range && cylinder.radius + margin < from_center {
        return decision_miss();
    }
    return decision_uncertain();
}
