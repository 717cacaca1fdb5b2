// The quadratic of ray and side without cancellation; twin of cpu/src/exact/cylinder_compensated.rs.

// difference_of_products: returns `a b - c d` by Kahan's algorithm.
fn exact_difference_of_products(a: real, b: real, c: real, d: real) -> real {
    let product = c * d;
    let error = exact_mul_add(-c, d, product);
    return exact_mul_add(a, b, -product) + error;
}

// cross: returns the cross product with a small relative error of each component.
fn exact_cross(a: vec3<real>, b: vec3<real>) -> vec3<real> {
    return vec3<real>(
        exact_difference_of_products(a.y, b.z, a.z, b.y),
        exact_difference_of_products(a.z, b.x, a.x, b.z),
        exact_difference_of_products(a.x, b.y, a.y, b.x),
    );
}

// side: returns the quadratic. `axis` is that of the scene file. The share is 2^-90.
fn exact_side_compensated(cylinder: CylinderRecord, axis: vec3<real>, ray: Ray) -> ExactSide {
    let x = exact_two_sum(ray.origin.x, -cylinder.center.x);
    let y = exact_two_sum(ray.origin.y, -cylinder.center.y);
    let z = exact_two_sum(ray.origin.z, -cylinder.center.z);
    let from_center = vec3<real>(x.sum, y.sum, z.sum);
    let error = vec3<real>(x.error, y.error, z.error);
    let r_c = exact_cross(from_center, axis) + exact_cross(error, axis);
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
