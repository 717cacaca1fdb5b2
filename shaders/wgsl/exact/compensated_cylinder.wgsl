// The hit of ray and cylinder by formulas in which less cancels; twin of cpu/src/exact/cylinder_compensated.rs.

// squares_of_component: `q^2 - (r v)^2` with its rounding error, and `q^2 + (r v)^2`.
struct ComponentSquares {
    difference: real,
    error: real,
    sum: real,
}

// squares_of_component: returns the squares for a component `v` of the axis. `rest` is the error of `q`.
fn exact_squares_of_component(q: real, rest: real, radius: real, v: real) -> ComponentSquares {
    let rim = exact_two_product(radius, v);
    let inner = exact_two_product(q, q);
    let outer = exact_two_product(rim.sum, rim.sum);
    let difference = exact_two_sum(inner.sum, -outer.sum);
    let half = q * rest - rim.sum * rim.error;
    let error = difference.error + (inner.error - outer.error) + (half + half);
    return ComponentSquares(difference.sum, error, inner.sum + outer.sum);
}

// difference_of_squares: returns `|q|^2 - r^2 V.V`, nearly as accurate as if it were rounded once, and
// `|q|^2 + r^2 V.V`.
fn exact_cylinder_squares(q: ExactVector, axis: vec3<real>, radius: real) -> SquareTerms {
    let x = exact_squares_of_component(q.rounded.x, q.error.x, radius, axis.x);
    let y = exact_squares_of_component(q.rounded.y, q.error.y, radius, axis.y);
    let z = exact_squares_of_component(q.rounded.z, q.error.z, radius, axis.z);
    let first = exact_two_sum(x.difference, y.difference);
    let second = exact_two_sum(first.sum, z.difference);
    let rest = (first.error + second.error) + (x.error + y.error + z.error);
    return SquareTerms(second.sum + rest, x.sum + y.sum + z.sum);
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
    let q = exact_cross_with_error(difference, axis);
    let p = exact_cross(ray.direction, axis);
    let axis_squared = vec3_dot(axis, axis);
    let distance_squared = vec3_dot(from_center, from_center);
    let a = vec3_dot(p, p);
    let squares = exact_cylinder_squares(q, axis, cylinder.radius);
    let far = distance_squared * axis_squared;
    let terms_of_h = sqrt(a * (squares.sum + far * real(8.077935669463161e-28)));
    let aside = vec3_dot(from_center, p) + vec3_dot(difference.error, p);
    let of_radius = a * cylinder.radius_squared;
    let reach = a * distance_squared;
    let size = of_radius + (abs(aside) * sqrt(reach) + reach * real(2.220446049250313e-16));
    let h = -vec3_dot(q.rounded, p);
    let terms_of_c = squares.sum + far * real(4.0);
    return ExactSideTerms(
        CompensatedQuadratic(a, h, squares.difference, terms_of_c, terms_of_h),
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
    let side = exact_side_new(cylinder, ray);
    if !exact_in_scale(side.length_squared) {
        return decision_uncertain();
    }
    // Many rays are uncertain only because of a cap, but few rays of a long cylinder are.
    var decision = exact_cylinder_without_caps(exact_side_crossings(side, cylinder, ray));
    if exact_is_long(cylinder) || !decision.decision.certain {
        let terms = exact_side_terms(cylinder, axis, ray);
        decision = exact_cylinder_without_caps(exact_crossings(terms, cylinder, ray));
    }
    if !decision.needs_caps {
        return decision.decision;
    }
    let down = side.slope < real(0.0);
    let near = select(cylinder.bottom, cylinder.top, down);
    let far = select(cylinder.top, cylinder.bottom, down);
    let facing = exact_plane_compensated(cylinder, axis, ray, near, down);
    let other = exact_plane_compensated(cylinder, axis, ray, far, !down);
    return exact_cylinder_with_caps(cylinder, ray, decision.decision, facing, other, down);
}
