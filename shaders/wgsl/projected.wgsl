// The projected form of both intersections, the most accurate one in a single precision; twin of
// tests/stability/src/methods/projected.rs. It takes the point of the line that is nearest to the centre or the axis,
// and goes half a chord from there to each side. So the numbers that cancel are as large as the distance from the line
// to the centre, and not as large as the distance from the ray's origin.

// crossings: returns both lambdas at which a line crosses a sphere or an infinite cylinder. The arguments are the
// line's direction and the vector from its start to the centre; for a cylinder, their components perpendicular to the
// axis.
struct Crossings {
    some: bool,
    near: real,
    far: real,
}

fn projected_crossings(direction: vec3<real>, r_c: vec3<real>, radius_squared: real) -> Crossings {
    let a = vec3_dot(direction, direction);
    let middle = vec3_dot(direction, r_c) / a;
    let off_center = r_c - direction * middle;
    let rest = radius_squared - vec3_dot(off_center, off_center);
    if rest < real(0.0) {
        return Crossings(false, real(0.0), real(0.0));
    }
    let half = sqrt(rest / a);
    return Crossings(true, middle - half, middle + half);
}

// projected::sphere: returns the smaller lambda that is in range, else the larger, and whether that lambda is in range.
fn projected_sphere_intersect(sphere: SphereRecord, ray: Ray) -> Root {
    let crossings = projected_crossings(ray.direction, sphere.center - ray.origin, sphere.radius_squared);
    let lambda = select(crossings.far, crossings.near, in_range(crossings.near));
    return Root(crossings.some && in_range(lambda), lambda);
}

// projected::cylinder: returns the closest hit of the side, the top cap and the bottom cap.
fn projected_cylinder_intersect(cylinder: CylinderRecord, ray: Ray) -> CylinderRoot {
    let r_c = vec3_perpendicular_to(cylinder.center - ray.origin, cylinder.axis);
    let along = vec3_perpendicular_to(ray.direction, cylinder.axis);
    let crossings = projected_crossings(along, r_c, cylinder.radius_squared);
    var side: Root;
    if crossings.some {
        let near_counts = in_range(crossings.near) && cylinder_within_height(cylinder, ray, crossings.near);
        let far_counts = in_range(crossings.far) && cylinder_within_height(cylinder, ray, crossings.far);
        let lambda = select(crossings.far, crossings.near, near_counts);
        side = Root(near_counts || far_counts, lambda);
    }
    return cylinder_with_caps(cylinder, ray, side);
}
