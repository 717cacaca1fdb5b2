// A cap of a cylinder with its error bound; twin of the cap in cpu/src/exact/cylinder_parts.rs.

// cap::filtered: returns the hit with the cap around `center`, which has the name `part`, if rounding certainly has not
// changed it. The factors are 8 and 16 times 2^-53, and 4 and 8 times the condition limit 65,536.
fn exact_cap_filtered(cylinder: CylinderRecord, ray: Ray, center: vec3<real>, part: u32) -> Decision {
    let to_center = center - ray.origin;
    let to_plane = vec3_dot(to_center, cylinder.axis);
    let slope = vec3_dot(ray.direction, cylinder.axis);
    let steepness = abs(slope);
    let size_of_direction = exact_magnitude(ray.direction);
    let slope_error = size_of_direction * real(8.881784197001252e-16);
    if steepness + slope_error < real(1e-8) {
        return decision_miss();
    }
    let steep = real(1e-8) + slope_error < steepness;
    let distance = select(to_plane, -to_plane, slope < real(0.0));
    let size = exact_extent_of_axis(cylinder) + exact_magnitude(to_center);
    let distance_error = size * real(1.7763568394002505e-15);
    if steep && distance + distance_error < (steepness - slope_error) * real(1e-3) {
        return decision_miss();
    }
    let lambda = to_plane / slope;
    let accurate = size < distance * real(262144.0) && size_of_direction < steepness * real(524288.0);
    let is_in_range = accurate && exact_cylinder_limits().most <= lambda;
    let from_center = vec3_length(ray_at(ray, lambda) - center);
    let margin = exact_cylinder_margin(cylinder, ray, lambda);
    if steep && is_in_range && from_center < cylinder.radius - margin {
        return decision_hit(lambda, part);
    }
    if steep && is_in_range && cylinder.radius + margin < from_center {
        return decision_miss();
    }
    return decision_uncertain();
}
