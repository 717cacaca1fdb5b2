// The hit of ray and cylinder by formulas in which less cancels; twin of cpu/src/exact/cylinder_compensated.rs.

// rim: returns `r^2 V.V` with a rounding error.
fn exact_rim(radius: real, axis: vec3<real>) -> ExactSum {
    let rr = exact_two_product(radius, radius);
    let xx = exact_two_product(axis.x, axis.x);
    let yy = exact_two_product(axis.y, axis.y);
    let zz = exact_two_product(axis.z, axis.z);
    let first = exact_two_sum(xx.sum, yy.sum);
    let second = exact_two_sum(first.sum, zz.sum);
    let product = exact_two_product(rr.sum, second.sum);
    let sum_error = (first.error + second.error) + (xx.error + yy.error + zz.error);
    return ExactSum(product.sum, product.error + (rr.sum * sum_error + rr.error * second.sum));
}

// Terms: the quadratic of a ray and the side, the discriminant by Lagrange's identity, and `O - C`.
struct ExactSideTerms {
    quadratic: CompensatedQuadratic,
    far: CompensatedDiscriminant,
    from_center: vec3<real>,
    in_scale: bool,
}

// Terms::new: returns the terms. `axis` is that of the scene file. The shares are 2^-90, 2^-52 and 4.
fn exact_side_terms(cylinder: CylinderRecord, axis: vec3<real>, ray: Ray) -> ExactSideTerms {
    let difference = exact_difference(ray.origin, cylinder.center);
    let from_center = difference.rounded;
    let parts = exact_cross_with_error(difference, axis);
    let q = parts.rounded + parts.error;
    let p = exact_cross(ray.direction, axis);
    let axis_squared = vec3_dot(axis, axis);
    let distance_squared = vec3_dot(from_center, from_center);
    let a = vec3_dot(p, p);
    let squares = exact_difference_of_squares(parts, exact_rim(cylinder.radius, axis));
    let far = distance_squared * axis_squared;
    let size_of_h = sqrt(a * (squares.sum + far * real(8.077935669463161e-28)));
    let aside = vec3_dot(from_center, p) + vec3_dot(difference.error, p);
    let of_radius = a * cylinder.radius_squared;
    let reach = a * distance_squared;
    let size = of_radius + (abs(aside) * sqrt(reach) + reach * real(2.220446049250313e-16));
    let h = -vec3_dot(q, p);
    let size_of_c = squares.sum + far * real(4.0);
    return ExactSideTerms(
        CompensatedQuadratic(a, h, squares.difference, size_of_c, size_of_h),
        CompensatedDiscriminant(axis_squared * (of_radius - aside * aside), axis_squared * size),
        from_center,
        exact_in_scale(axis_squared) && exact_in_scale(a) && exact_in_scale(squares.sum),
    );
}

// Terms::crossings: returns the crossings, by the discriminant whose terms are smaller. The factor is 64 * 2^-53.
fn exact_crossings(terms: ExactSideTerms, cylinder: CylinderRecord, ray: Ray) -> ExactCrossings {
    let quadratic = terms.quadratic;
    var discriminant = compensated_near(quadratic);
    if !(discriminant.size < terms.far.size) {
        discriminant = terms.far;
    }
    let roots = compensated_roots(quadratic, discriminant);
    let lambda_small = abs(quadratic.c) / roots.w;
    let lambda_large = roots.w / quadratic.a;
    let relative = roots.condition * real(7.105427357601002e-15);
    let error_small = lambda_small * relative + (roots.error_of_c + roots.error_of_c) / roots.w;
    let margin_small = exact_cylinder_margin(cylinder, ray, error_small);
    let margin_large = exact_cylinder_margin(cylinder, ray, lambda_large * relative);
    let start = vec3_dot(terms.from_center, cylinder.axis);
    let slope = vec3_dot(ray.direction, cylinder.axis);
    let accurate = terms.in_scale && roots.accurate;
    // If `h` is negative, the large root is the one where the ray enters, and it is negative.
    let backward = quadratic.h < real(0.0);
    let small_counts = accurate && roots.small_is_ahead && compensated_is_in_range(lambda_small);
    let small_fails = accurate && roots.small_fails;
    let small = exact_crossing_new(cylinder, start, slope, lambda_small, margin_small, small_counts, small_fails);
    let large_counts = accurate && !backward && compensated_is_in_range(lambda_large);
    let large_fails = accurate && roots.large_fails;
    let large = exact_crossing_new(cylinder, start, slope, lambda_large, margin_large, large_counts, large_fails);
    let misses = terms.in_scale && roots.misses;
    if backward {
        return ExactCrossings(large, small, misses);
    }
    return ExactCrossings(small, large, misses);
}

// plane: returns the plane of the cap around `center`. `axis` is that of the scene file. The factors are 2^-40, and 32
// and 16 times 2^-53.
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
    var plane = exact_plane_at(cylinder, ray, center, to_plane, size);
    let of_distance = size / abs(to_plane) * real(3.552713678800501e-15);
    let of_slope = exact_magnitude(ray.direction) / abs(plane.slope) * real(1.7763568394002505e-15);
    plane.error = of_distance + of_slope + real(1.7763568394002505e-15);
    // The square of a short axis may underflow.
    let in_scale = exact_in_scale(vec3_dot(axis, axis));
    plane.fails = plane.fails && in_scale;
    plane.accurate = plane.accurate && in_scale;
    return plane;
}

// cylinder::compensated: returns the hit, if rounding certainly has not changed it. `axis` is that of the scene file.
fn exact_cylinder_compensated(cylinder: CylinderRecord, axis: vec3<real>, ray: Ray) -> Decision {
    if !exact_in_scale(vec3_dot(ray.direction, ray.direction)) {
        return decision_uncertain();
    }
    let down = vec3_dot(ray.direction, cylinder.axis) < real(0.0);
    let near = select(cylinder.bottom, cylinder.top, down);
    let far = select(cylinder.top, cylinder.bottom, down);
    let facing = exact_plane_compensated(cylinder, axis, ray, near, down);
    let other = exact_plane_compensated(cylinder, axis, ray, far, !down);
    let view = cylinder_seen_from(cylinder, ray.origin);
    let inside = exact_is_inside(view.c, exact_squares(cylinder, ray.origin));
    // If a cylinder is not long, most uncertain rays from inside are uncertain only because of a cap.
    if !exact_is_long(cylinder) && inside {
        let decision = exact_cylinder_with_caps(cylinder, ray, decision_uncertain(), facing, other, down);
        if decision.certain {
            return decision;
        }
    }
    let terms = exact_side_terms(cylinder, axis, ray);
    let side = exact_cylinder_without_caps(exact_crossings(terms, cylinder, ray), inside);
    if !side.needs_caps {
        return side.decision;
    }
    return exact_cylinder_with_caps(cylinder, ray, side.decision, facing, other, down);
}
